// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "core/geometry/tangents.h"
#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// Planes that are nearer to where they were linearised [rad] are good enough to tell which segments fit.
constexpr double kSettledAngle = 1e-3;
/// What an end point at the border to another surface is off by, in standard deviations of a point over the points of
/// its segment: the fewer there are, the less does their line tell which of them are its own.
constexpr double kBorderSigmas = 2.0;
/// Segments of more points do not feel it.
constexpr int kFeltPoints = 15;
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
    const auto chiOf = [&](std::span<const SegmentStatistics* const> segments) {
        return chiTogether(plane, frame, segments, parameters.noise, parameters.flatnessFloor());
    };
    std::vector<const SegmentStatistics*> segments;
    std::vector<double> alone;
    for (const SegmentNumber number : numbers) {
        segments.push_back(&map.segment(number).statistics);
        alone.push_back(chiOf(std::span(segments).last(1)));
    }
    while (segments.size() > 1 &&
           chiOf(segments) >= parameters.likelihood.finalGate + std::accumulate(alone.begin(), alone.end(), 0.0)) {
        std::ptrdiff_t worst = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::ptrdiff_t i = 0; i < std::ssize(segments); ++i) {
            std::vector<const SegmentStatistics*> others = segments;
            others.erase(others.begin() + i);
            const double left = chiOf(others);
            if (left < least) {
                least = left;
                worst = i;
            }
        }
        segments.erase(segments.begin() + worst);
        alone.erase(alone.begin() + worst);
        numbers.erase(numbers.begin() + worst);
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
    // No pitch error makes segments disagree by more than they do without any, which is quickly known.
    std::vector<double> mostChis(plane.members.size());
    if (plane.members.size() > static_cast<std::size_t>(plane.slices)) {
        NoiseParameters noise = parameters.noise;
        noise.pitch = 0.0;
        estimate.residualChis(members, noise, parameters.flatnessFloor(), mostChis);
    }
    std::vector<SegmentNumber> fitting;
    std::vector<SegmentNumber> ofSlice;
    for (std::size_t i = 0; i < chis.size();) {
        const int place = map.segment(plane.members[i]).slice;
        double mostChi = 0.0;
        ofSlice.clear();
        for (; i < chis.size() && map.segment(plane.members[i]).slice == place; ++i) {
            if (chis[i] >= gate)
                continue;
            ofSlice.push_back(plane.members[i]);
            mostChi += mostChis[i];
        }
        if (ofSlice.size() > 1 && mostChi >= gate)
            keepAgreeing(ofSlice, estimate, map, parameters);
        fitting.insert(fitting.end(), ofSlice.begin(), ofSlice.end());
    }
    return fitting;
}

/// Where a segment meets another surface the border may be drawn a point too far. It is so in slice after slice, to the
/// same side: an error that all segments of a plane share, and that averages out over none of them.
void addBorderErrors(PlaneTrack& plane, const SegmentBatch& counting)
{
    const PlaneEstimate estimate = plane.estimate.afresh();
    Eigen::Vector3d atStarts = Eigen::Vector3d::Zero();
    Eigen::Vector3d atEnds = Eigen::Vector3d::Zero();
    for (int i = 0; i < counting.size(); ++i) {
        const SegmentStatistics& s = *counting[i].statistics;
        if (s.points > kFeltPoints || (s.startsFree && s.endsFree))
            continue;
        const PlaneInSlice seen = estimate.inSlice(*counting[i].frame);
        // Of an end point that is off by its standard deviation, times how surely it is one too many.
        const double weight = std::sqrt(s.offsetInformation / (s.points * seen.steepness)) * kBorderSigmas / s.points;
        const auto gradientAt = [&](double place) {
            const double u = s.u + place * s.directionU;
            const double v = s.v + place * s.directionV;
            return Eigen::Vector3d{weight * seen.first.at(u, v), weight * seen.second.at(u, v), -weight};
        };
        if (!s.startsFree)
            atStarts += gradientAt(s.start);
        if (!s.endsFree)
            atEnds += gradientAt(s.end);
    }
    const Eigen::Matrix3d turn = betweenTangents(estimate.tangents(), plane.estimate.tangents());
    plane.estimate.addCommonErrors(std::array<Eigen::Vector3d, 2>{turn * atStarts, turn * atEnds});
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
        addBorderErrors(plane, counting);
        map.touch(plane, step);
    }
}

}  // namespace planewright
