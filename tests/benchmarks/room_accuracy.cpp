// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/room_accuracy.h"

#include <algorithm>
#include <chrono>

#include <Eigen/LU>

#include "core/formats/labels.h"
#include "core/pipeline/complete_labels.h"
#include "core/pipeline/plane_extractor.h"
#include "tests/benchmarks/plane_information.h"
#include "tests/benchmarks/scoring.h"

namespace planewright {

namespace {

using SteadyClock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

/// Extractions of which the median time counts.
constexpr int kRepeats = 5;

void extract(const Room& room, const Parameters& parameters, RoomAccuracy& accuracy)
{
    std::vector<double> times;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        const auto start = SteadyClock::now();
        PlaneExtractor extractor(sensorOf(room.scan.recording.description), parameters);
        for (const ScanSlice& slice : room.scan.recording.slices)
            extractor.advance(slice);
        accuracy.found = extractor.finish();
        times.push_back(Milliseconds(SteadyClock::now() - start).count());
    }
    accuracy.milliseconds = median(times);
}

void compare(const Room& room, const Parameters& parameters, std::int64_t minReturns, RoomAccuracy& accuracy)
{
    std::vector<ComparedPlane> planes;
    for (const auto& plane : accuracy.found->planes)
        planes.push_back({plane->id, plane->normal, plane->distance});
    std::vector<ComparedPlane> truth;
    for (const TruePlane& plane : room.scene.planes)
        truth.push_back({plane.id, plane.normal, plane.distance});
    Labels labels = labelsOf(*accuracy.found, room.scan.recording);
    completeLabels(labels, *accuracy.found, room.scan.recording, parameters);
    accuracy.at50 = *compareLabels(labels, room.scan.labels, planes, truth, {0.5, minReturns});
    accuracy.at80 = *compareLabels(labels, room.scan.labels, planes, truth, {0.8, minReturns});
}

/// The error in the plane's own tangents.
Eigen::Vector3d ownErrorOf(const Plane& plane, const TruePlane& truth)
{
    const double side = plane.normal.dot(truth.normal) < 0 ? -1 : 1;
    Eigen::Vector3d error;
    error.head<2>() = plane.tangents.transpose() * (plane.normal - side * truth.normal);
    error[2] = plane.distance - side * truth.distance;
    return error;
}

std::vector<PlaneDeviation> deviationsOf(const Room& room, const RoomAccuracy& accuracy)
{
    const std::vector<Eigen::Matrix3d> information = trueInformation(room.scene, room.scan, room.noise);
    std::vector<PlaneDeviation> deviations;
    for (const RegionMatch& match : accuracy.at50.correct) {
        if (match.b.size() > 1)
            continue;  // coplanar ones may differ by what the noise cannot tell
        const Plane& plane = planeOf(match.a, *accuracy.found);
        const TruePlane& truth = room.scene.planes[static_cast<std::size_t>(match.b.front())];
        const Eigen::Vector3d error = errorOf({plane.normal, plane.distance}, {truth.normal, truth.distance});
        const Eigen::Vector3d own = ownErrorOf(plane, truth);
        deviations.push_back({match.a, truth.id, error.dot(information[static_cast<std::size_t>(truth.id)] * error),
                              own.dot(plane.covariance.inverse() * own)});
    }
    return deviations;
}

}  // namespace

RoomAccuracy measure(const Room& room, const Parameters& parameters, std::int64_t minReturns)
{
    RoomAccuracy accuracy;
    extract(room, parameters, accuracy);
    compare(room, parameters, minReturns, accuracy);
    accuracy.deviations = deviationsOf(room, accuracy);
    return accuracy;
}

const Plane& planeOf(int id, const Snapshot& found)
{
    return **std::find_if(found.planes.begin(), found.planes.end(),
                          [id](const auto& plane) { return plane->id == id; });
}

}  // namespace planewright
