// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <vector>

#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// Planes that are nearer to where they were linearised [rad] are good enough to tell which segments fit.
constexpr double kSettledAngle = 1e-3;
/// Fits of a plane at most, each linearised where the one before ended.
constexpr int kMostFits = 4;

/// χ² of segments of one slice together, the pitch error that they share eliminated.
double chiTogether(const PlaneEstimate& plane, const SliceFrame& frame,
                   std::span<const SegmentStatistics* const> segments, const NoiseParameters& noise, double floor)
{
    PlaneEstimate alone = plane.afresh();
    alone.accumulate(alone.inSlice(frame), segments, noise, floor, 1.0);
    return alone.chi();
}

/// Takes out of a slice's segments those that contradict the others: each alone may pass for one that is off by the
/// pitch error, of which there is one for all. `numbers` are of one slice.
void keepAgreeing(std::vector<SegmentNumber>& numbers, const PlaneEstimate& plane, const TrackMap& map,
                  const Parameters& parameters)
{
    const SliceFrame& frame = map.slice(map.segment(numbers.front()).slice).frame;
    const double floor = parameters.flatnessFloor();
    std::vector<const SegmentStatistics*> segments;
    for (const SegmentNumber number : numbers)
        segments.push_back(&map.segment(number).statistics);
    double chi = chiTogether(plane, frame, segments, parameters.noise, floor);
    while (segments.size() > 1 && chi >= parameters.likelihood.finalGate) {
        std::size_t worst = 0;
        double least = chi;
        for (std::size_t i = 0; i < segments.size(); ++i) {
            std::vector<const SegmentStatistics*> others = segments;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
            const double left = chiTogether(plane, frame, others, parameters.noise, floor);
            if (left < least) {
                least = left;
                worst = i;
            }
        }
        if (chi - least < parameters.likelihood.finalGate)
            return;
        chi = least;
        segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(worst));
        numbers.erase(numbers.begin() + static_cast<std::ptrdiff_t>(worst));
    }
}

/// The members of a plane that its last fit takes: those that fit it, and agree with the others of their slice.
std::vector<SegmentNumber> fittingMembers(const PlaneTrack& plane, const SegmentBatch& members, const TrackMap& map,
                                          const Parameters& parameters)
{
    const double gate = parameters.likelihood.finalGate;
    const PlaneEstimate estimate = plane.estimate.afresh();
    std::vector<double> chis(plane.members.size());
    estimate.joinChis(members, parameters.noise, parameters.flatnessFloor(), gate, chis);
    std::vector<SegmentNumber> fitting;
    std::vector<SegmentNumber> ofSlice;
    for (std::size_t i = 0; i < chis.size();) {
        const int place = map.segment(plane.members[i]).slice;
        ofSlice.clear();
        for (; i < chis.size() && map.segment(plane.members[i]).slice == place; ++i) {
            if (chis[i] < gate)
                ofSlice.push_back(plane.members[i]);
        }
        if (ofSlice.size() > 1)
            keepAgreeing(ofSlice, estimate, map, parameters);
        fitting.insert(fitting.end(), ofSlice.begin(), ofSlice.end());
    }
    return fitting;
}

}  // namespace

void refineTracks(TrackMap& map, const Parameters& parameters)
{
    const int step = map.slice(map.slices() - 1).step;
    for (PlaneTrack& plane : map.planes()) {
        if (plane.slicesUnsolved > 0 || plane.estimate.angleFromLinearisation() > kSettledAngle)
            map.rebuild(plane, parameters);
        const SegmentBatch& members = map.together(plane.members);
        const std::vector<SegmentNumber> fitting = fittingMembers(plane, members, map, parameters);
        const bool all = fitting.size() == plane.members.size();
        const SegmentBatch& counting = all ? members : map.together(fitting);
        for (int fit = 0; fit < kMostFits; ++fit) {
            if (!map.rebuild(plane, counting, parameters.noise, 0.0) ||
                plane.estimate.angleFromLinearisation() < kSettledAngle)
                break;
        }
        map.touch(plane, step);
    }
}

}  // namespace planewright
