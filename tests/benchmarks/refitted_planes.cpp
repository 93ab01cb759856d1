// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/refitted_planes.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/planes/plane_estimate.h"
#include "core/segments/extract_statistics.h"

namespace planewright {

namespace {

/// The segments of one plane in one slice.
struct SliceMembers {
    std::size_t slice = 0;
    SliceFrame frame;
    std::vector<SegmentStatistics> segments;
};

/// The statistics of all segments of a recording, with the noise that was found in it.
std::vector<std::vector<SegmentStatistics>> statisticsOf(const Extracted& whole, const Parameters& parameters)
{
    StatisticsExtractor extractor;
    std::vector<std::vector<SegmentStatistics>> statistics;
    const SensorModel sensor = sensorOf(whole.recording.description);
    for (const ScanSlice& slice : whole.recording.slices)
        extractor.extract(slice, sensor, parameters, statistics.emplace_back());
    return statistics;
}

/// A plane's segments by slice; those that the noise found at the end would cut elsewhere are not among them.
std::vector<SliceMembers> membersOf(const Plane& plane, const Extracted& whole,
                                    const std::vector<std::vector<SegmentStatistics>>& statistics)
{
    std::vector<SliceMembers> members;
    const SensorModel sensor = sensorOf(whole.recording.description);
    for (const SegmentId& id : plane.segments) {
        const LineSegment& wanted = whole.found->segments[id];
        const std::size_t slice = whole.found->segments.find(id.step);
        const ScanSlice& scan = whole.recording.slices[slice];
        const auto same = std::find_if(statistics[slice].begin(), statistics[slice].end(), [&](const auto& s) {
            return s.firstBeam == wanted.firstBeam && s.lastBeam == wanted.lastBeam;
        });
        if (same == statistics[slice].end())
            continue;
        if (members.empty() || members.back().slice != slice)
            members.push_back({slice, frameOf(scan.tiltAt(scan.ranges.size() / 2), sensor), {}});
        members.back().segments.push_back(*same);
    }
    return members;
}

/// Which slices of a plane's a fit takes.
bool takes(Slices slices, std::size_t slice)
{
    return slices == Slices::All || (slice % 2 == 0) == (slices == Slices::Even);
}

struct Fit {
    PlaneEstimate estimate;
    std::shared_ptr<Plane> plane;
};

/// The most likely plane of these slices' members, linearised anew until it stays where it is.
std::optional<Fit> fitOf(const Plane& start, const std::vector<SliceMembers>& members, Slices slices,
                         const NoiseParameters& noise)
{
    constexpr int kIterations = 5;
    Fit fit{{start.normal, start.distance}, std::make_shared<Plane>()};
    int segments = 0;
    std::vector<const SegmentStatistics*> group;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        fit.estimate = PlaneEstimate(fit.estimate.normal(), fit.estimate.distance());
        segments = fit.plane->points = 0;
        for (const SliceMembers& slice : members) {
            if (!takes(slices, slice.slice))
                continue;
            group.clear();
            for (const SegmentStatistics& segment : slice.segments) {
                group.push_back(&segment);
                fit.plane->points += segment.points;
                ++segments;
            }
            fit.estimate.accumulate(fit.estimate.inSlice(slice.frame), group, noise, 0.0, 1.0);
        }
        if (!fit.estimate.solve())
            return std::nullopt;
    }
    fit.plane->id = start.id;
    fit.plane->normal = fit.estimate.normal();
    fit.plane->distance = fit.estimate.distance();
    fit.plane->tangents = fit.estimate.tangents();
    fit.plane->fittingError = fit.estimate.chi() / std::max(1.0, 2.0 * segments - 3.0);
    fit.plane->covariance = std::max(1.0, fit.plane->fittingError) * fit.estimate.covariance();
    return fit;
}

/// Leaves out what the last fit of an extraction leaves out.
void keepFitting(std::vector<SliceMembers>& members, const PlaneEstimate& estimate, const Parameters& parameters)
{
    const double gate = parameters.likelihood.finalGate;
    for (SliceMembers& slice : members) {
        const PlaneInSlice seen = estimate.inSlice(slice.frame);
        std::erase_if(slice.segments, [&](const SegmentStatistics& segment) {
            return !(estimate.joinChi(seen, segment, parameters.noise, parameters.flatnessFloor(), gate) < gate);
        });
    }
    std::erase_if(members, [](const SliceMembers& slice) { return slice.segments.empty(); });
}

}  // namespace

std::vector<RepeatedPlane> refittedPlanes(const Extracted& whole, const Parameters& parameters, int minPoints)
{
    Parameters found = parameters;
    found.noise.rangeConstant = whole.found->noise.rangeConstant;
    found.noise.rangeProportional = whole.found->noise.rangeProportional;
    found.noise.pitch = whole.found->noise.pitch;
    const auto statistics = statisticsOf(whole, found);
    std::vector<RepeatedPlane> refitted;
    for (const auto& plane : whole.found->planes) {
        if (plane->points < minPoints)
            continue;
        std::vector<SliceMembers> members = membersOf(*plane, whole, statistics);
        const auto all = fitOf(*plane, members, Slices::All, found.noise);
        if (!all)
            continue;
        keepFitting(members, all->estimate, found);
        const auto even = fitOf(*plane, members, Slices::Even, found.noise);
        const auto odd = fitOf(*plane, members, Slices::Odd, found.noise);
        if (!even || !odd)
            continue;
        if (auto moved = movedBetween(even->plane, odd->plane, Share::Nothing))
            refitted.push_back(std::move(*moved));
    }
    return refitted;
}

}  // namespace planewright
