// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/seen_planes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "core/geometry/correct_recording.h"
#include "core/pipeline/plane_extractor.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr std::size_t kMostPlanes = 64;
constexpr int kLeastPoints = 150;
constexpr int kLeastSlices = 6;
/// A plane that its points are farther from than this [m], and than so many standard deviations, is none.
constexpr double kFlat = 0.02;
constexpr double kFlatSigmas = 2.5;
/// Planes seen at a shallower angle on average follow every error of the pitch.
constexpr double kLeastIncidence = degrees(8.0);

std::shared_ptr<const Snapshot> extracted(const Recording& recording, const Parameters& parameters)
{
    PlaneExtractor extractor(sensorOf(recording.description), parameters);
    for (const ScanSlice& slice : recording.slices)
        extractor.advance(slice);
    return extractor.finish();
}

/// How a plane is met by its segments.
struct View {
    int slices = 0;
    double range = 0.0;      ///< mean [m]
    double incidence = 0.0;  ///< mean sine
};

View viewOf(const Plane& plane, const Snapshot& snapshot)
{
    View view;
    double points = 0.0;
    int lastStep = -1;
    for (const SegmentId& id : plane.segments) {
        const LineSegment& segment = snapshot.segments[id];
        const Eigen::Vector3d ray = segment.midpoint() - segment.viewpoint;
        view.range += segment.points * ray.norm();
        view.incidence += segment.points * std::abs(plane.normal.dot(ray)) / std::max(ray.norm(), 1e-9);
        points += segment.points;
        view.slices += id.step != lastStep ? 1 : 0;
        lastStep = id.step;
    }
    view.range /= std::max(points, 1.0);
    view.incidence /= std::max(points, 1.0);
    return view;
}

bool isSeenWell(const Plane& plane, const Snapshot& snapshot, const NoiseParameters& noise)
{
    if (plane.points < kLeastPoints)
        return false;
    const View view = viewOf(plane, snapshot);
    return view.slices >= kLeastSlices && view.incidence >= std::sin(kLeastIncidence) &&
           plane.rms < std::max(kFlat, kFlatSigmas * std::sqrt(noise.rangeVariance(view.range)));
}

/// The well seen planes, those of most points first.
std::vector<const Plane*> wellSeen(const Snapshot& snapshot, const NoiseParameters& noise)
{
    std::vector<const Plane*> planes;
    for (const auto& plane : snapshot.planes) {
        if (isSeenWell(*plane, snapshot, noise))
            planes.push_back(plane.get());
    }
    std::stable_sort(planes.begin(), planes.end(),
                     [](const Plane* a, const Plane* b) { return a->points > b->points; });
    planes.resize(std::min(planes.size(), kMostPlanes));
    return planes;
}

NoiseParameters noiseOf(const Snapshot& snapshot, const NoiseParameters& told)
{
    NoiseParameters noise = told;
    noise.rangeConstant = snapshot.noise.rangeConstant;
    noise.rangeProportional = snapshot.noise.rangeProportional;
    noise.pitch = snapshot.noise.pitch;
    return noise;
}

/// Appends the returns of a segment.
void appendPoints(const ScanSlice& slice, const LineSegment& segment, const SensorModel& sensor,
                  std::vector<SeenPoint>& points)
{
    const auto beams = static_cast<double>(std::max<std::size_t>(2, slice.ranges.size()) - 1);
    const auto end = std::min(static_cast<std::size_t>(segment.lastBeam) + 1, slice.ranges.size());
    for (auto beam = static_cast<std::size_t>(segment.firstBeam); beam < end; ++beam) {
        const double range = slice.ranges[beam];
        if (!sensor.hasEcho(range))
            continue;
        const double bearing = slice.bearing(beam);
        points.push_back({range, std::sin(bearing), std::cos(bearing), static_cast<double>(beam) / beams});
    }
}

}  // namespace

SeenPlanes planesSeen(const Recording& recording, const Parameters& parameters)
{
    const std::shared_ptr<const Snapshot> snapshot = extracted(recording, parameters);
    const SensorModel sensor = sensorOf(recording.description);
    SeenPlanes seen;
    seen.leverArm = sensor.pitchAxisOffset;
    seen.noise = noiseOf(*snapshot, parameters.noise);

    std::map<SegmentId, std::size_t> owners;
    for (const Plane* plane : wellSeen(*snapshot, seen.noise)) {
        for (const SegmentId& id : plane->segments)
            owners.emplace(id, seen.planes.size());
        seen.planes.push_back({plane->normal, plane->distance, plane->points});
    }

    const std::vector<double> rates = noddingRates(recording.slices);
    auto owner = owners.begin();
    for (std::size_t i = 0; i < recording.slices.size(); ++i) {
        const ScanSlice& slice = recording.slices[i];
        SeenSlice here{slice.tilt, slice.tiltEnd.value_or(slice.tilt) - slice.tilt, rates[i], seen.segments.size(), 0};
        for (; owner != owners.end() && owner->first.step == slice.step; ++owner) {
            const std::size_t first = seen.points.size();
            appendPoints(slice, snapshot->segments[owner->first], sensor, seen.points);
            seen.segments.push_back({owner->second, first, seen.points.size()});
        }
        here.end = seen.segments.size();
        if (here.end > here.first)
            seen.slices.push_back(here);
    }
    return seen;
}

}  // namespace planewright
