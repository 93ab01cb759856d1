// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/complete_labels.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/geometry/sensor_model.h"
#include "core/segments/slice_trace.h"

namespace planewright {

namespace {

using Labels = std::vector<std::vector<PlaneId>>;

/// Beams within which a plane to the left or to the right counts as next to an echo.
constexpr int kReach = 8;
/// Echoes at the border of two planes that may change sides.
constexpr int kBorder = 6;
constexpr double kSigmas = 3.0;

/// Scans the planes for the best explanation of an echo, with the noise that the scan has told.
class Labeller {
public:
    Labeller(const Snapshot& snapshot, const Recording& recording, const Parameters& parameters, Labels& labels)
        : recording_(recording),
          noise_(parameters.noise),
          floor_(parameters.flatnessFloor()),
          sensor_(sensorOf(recording.description)),
          labels_(labels)
    {
        for (const auto& plane : snapshot.planes) {
            if (static_cast<std::size_t>(plane->id) >= planes_.size())
                planes_.resize(static_cast<std::size_t>(plane->id) + 1, nullptr);
            planes_[static_cast<std::size_t>(plane->id)] = plane.get();
        }
    }

    void labelSlice(std::size_t slice)
    {
        exchangeBorders(slice);
        // Labels that echoes were given count for those next to them, on both sides alike: each beam is looked at again
        // only when something in its reach has changed.
        std::vector<std::size_t> beams(labels_[slice].size());
        std::iota(beams.begin(), beams.end(), std::size_t{0});
        while (!beams.empty())
            beams = labelEchoes(slice, beams);
    }

private:
    struct Ray {
        Eigen::Vector3d point;
        Eigen::Matrix3d covariance;
    };
    struct Choice {
        PlaneId plane = kNoPlane;
        double sigmas = kSigmas;
    };

    /// Labels those of some beams that a plane next to them explains; gives the beams, in order, in reach of these.
    std::vector<std::size_t> labelEchoes(std::size_t slice, const std::vector<std::size_t>& beams)
    {
        const ScanSlice& scan = recording_.slices[slice];
        std::vector<PlaneId>& line = labels_[slice];
        std::vector<std::pair<std::size_t, PlaneId>> given;
        for (const std::size_t beam : beams) {
            if (line[beam] != kNoPlane || !sensor_.hasEcho(scan.ranges[beam]))
                continue;
            Choice choice;
            const Ray ray = rayOf(scan, beam);
            consider(nearest(line, beam, -1), ray, choice);
            consider(nearest(line, beam, 1), ray, choice);
            if (slice > 0)
                consider(labelAt(slice - 1, beam), ray, choice);
            if (slice + 1 < labels_.size())
                consider(labelAt(slice + 1, beam), ray, choice);
            if (choice.plane != kNoPlane)
                given.emplace_back(beam, choice.plane);
        }
        constexpr std::size_t kBeamsInReach = kReach;
        std::vector<std::size_t> inReach;
        for (const auto& [beam, plane] : given) {
            line[beam] = plane;
            const std::size_t from = beam - std::min(beam, kBeamsInReach);
            const std::size_t next = inReach.empty() ? 0 : inReach.back() + 1;
            for (std::size_t i = std::max(from, next); i < std::min(beam + kBeamsInReach + 1, line.size()); ++i)
                inReach.push_back(i);
        }
        return inReach;
    }

    /// The nearest plane on one side of a beam, within reach.
    static PlaneId nearest(const std::vector<PlaneId>& line, std::size_t beam, int side)
    {
        for (int away = 1; away <= kReach; ++away) {
            // Beyond beam 0 the unsigned number is larger than any beam.
            const std::size_t at = beam + static_cast<std::size_t>(side * away);
            if (at >= line.size())
                break;
            if (line[at] != kNoPlane)
                return line[at];
        }
        return kNoPlane;
    }

    Ray rayOf(const ScanSlice& scan, std::size_t beam) const
    {
        const double bearing = scan.bearing(beam);
        const double tilt = scan.tiltAt(beam);
        return {toCartesian(scan.ranges[beam], bearing, tilt, sensor_),
                cartesianCovariance(scan.ranges[beam], bearing, tilt, sensor_, noise_)};
    }

    double sigmasTo(PlaneId id, const Ray& ray) const
    {
        const Plane& plane = *planes_[static_cast<std::size_t>(id)];
        Eigen::Vector3d row;
        row << plane.tangents.transpose() * ray.point, -1.0;
        const double variance =
            plane.normal.dot(ray.covariance * plane.normal) + row.dot(plane.covariance * row) + floor_ * floor_;
        return std::abs(plane.normal.dot(ray.point) - plane.distance) / std::sqrt(variance);
    }

    void consider(PlaneId id, const Ray& ray, Choice& choice) const
    {
        if (id == kNoPlane || id == choice.plane)
            return;
        const double sigmas = sigmasTo(id, ray);
        if (sigmas < choice.sigmas)
            choice = {id, sigmas};
    }

    PlaneId labelAt(std::size_t slice, std::size_t beam) const
    {
        return beam < labels_[slice].size() ? labels_[slice][beam] : kNoPlane;
    }

    /// Moves the border of two neighbouring planes to where their echoes say it is.
    void exchangeBorders(std::size_t slice)
    {
        const ScanSlice& scan = recording_.slices[slice];
        std::vector<PlaneId>& line = labels_[slice];
        for (std::size_t beam = 1; beam < line.size(); ++beam) {
            const PlaneId left = line[beam - 1];
            const PlaneId right = line[beam];
            if (left == right || left == kNoPlane || right == kNoPlane)
                continue;
            const auto move = [&](std::size_t from, int towards, PlaneId own, PlaneId other) {
                std::size_t moved = 0;
                for (auto at = static_cast<std::ptrdiff_t>(from);
                     at >= 0 && at < static_cast<std::ptrdiff_t>(line.size()) && moved < kBorder; at += towards) {
                    const auto i = static_cast<std::size_t>(at);
                    if (line[i] != own)
                        break;
                    const Ray ray = rayOf(scan, i);
                    if (!(sigmasTo(other, ray) < sigmasTo(own, ray)))
                        break;
                    line[i] = other;
                    ++moved;
                }
                return moved;
            };
            if (move(beam - 1, -1, left, right) == 0)
                beam += move(beam, 1, right, left);
        }
    }

    const Recording& recording_;
    NoiseParameters noise_;
    double floor_;  // [m]
    SensorModel sensor_;
    std::vector<const Plane*> planes_;
    Labels& labels_;
};

}  // namespace

void completeLabels(std::vector<std::vector<PlaneId>>& labels, const Snapshot& snapshot, const Recording& recording,
                    const Parameters& parameters)
{
    if (parameters.method.estimator != Estimator::Likelihood)
        return;
    Labeller labeller(snapshot, recording, withNoise(parameters, snapshot.noise), labels);
    for (std::size_t slice = 0; slice < labels.size(); ++slice)
        labeller.labelSlice(slice);
}

}  // namespace planewright
