// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/track_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types/angle.h"

namespace planewright {

namespace {

/// A plane is solved with every slice until it has so many, and with every so many-th from then on.
constexpr int kYoungSlices = 10;
constexpr int kSolveEvery = 4;
/// It is linearised anew when it has so many times the points, or has turned so far [rad].
constexpr std::int64_t kRelineariseGrowth = 3;
constexpr double kRelineariseAngle = 0.03;
/// Slices that count as neighbours at least and at most, and the tilt they span at least [rad].
constexpr int kNearSlices = 2;
constexpr int kMostNearSlices = 8;
constexpr double kNearTilt = degrees(1.5);

}  // namespace

void TrackMap::append(const ScanSlice& slice, const SensorModel& sensor, std::span<const SegmentStatistics> segments)
{
    TrackedSlice tracked;
    tracked.step = slice.step;
    tracked.frame = frameOf(slice.tiltAt(slice.ranges.size() / 2), sensor);
    tracked.first = this->segments();
    tracked.end = tracked.first + static_cast<SegmentNumber>(segments.size());
    int beamShift = 0;
    if (slices_.empty()) {
        sensor_ = sensor;
        bearingStep_ = slice.bearingStep;
        firstBearing_ = slice.firstBearing;
    } else {
        tiltTravelled_ += std::abs(tracked.frame.tilt - slices_.back().frame.tilt);
        beamShift = static_cast<int>(std::lround((slice.firstBearing - firstBearing_) / bearingStep_));
    }
    for (const SegmentStatistics& statistics : segments) {
        segments_.push_back({statistics, slices()});
        beams_.push_back({statistics.firstBeam + beamShift, statistics.lastBeam + beamShift});
    }
    slices_.push_back(tracked);
    slices_.back().lookback = neighbours(slices() - 1, -1);
}

PlaneTrack& TrackMap::findPlane(PlaneId id)
{
    const auto found = std::lower_bound(planes_.begin(), planes_.end(), id,
                                        [](const PlaneTrack& plane, PlaneId wanted) { return plane.id < wanted; });
    lastPlace_[static_cast<std::size_t>(id)] = static_cast<std::size_t>(found - planes_.begin());
    return *found;
}

int TrackMap::neighbours(int place, int direction) const
{
    const int available = direction < 0 ? place : slices() - 1 - place;
    const double tilt = slice(place).frame.tilt;
    int count = std::min(kNearSlices, available);
    while (count < std::min(kMostNearSlices, available) &&
           std::abs(slice(place + direction * (count + 1)).frame.tilt - tilt) <= kNearTilt)
        ++count;
    return count;
}

double TrackMap::meanTiltStep() const
{
    return slices_.size() < 2 ? 0.0 : tiltTravelled_ / static_cast<double>(slices_.size() - 1);
}

double TrackMap::incidence(SegmentNumber number, const PlaneEstimate& estimate) const
{
    const TrackedSegment& s = segment(number);
    const double u = s.statistics.u;
    const double v = s.statistics.v;
    const double across = u * estimate.normal().x() + v * estimate.normal().dot(slice(s.slice).frame.ahead);
    return std::abs(across) / std::sqrt(u * u + v * v);
}

double TrackMap::meanIncidence(const PlaneTrack& plane) const
{
    double sum = 0.0;
    for (const SegmentNumber number : plane.members)
        sum += segment(number).statistics.points * incidence(number, plane.estimate);
    return sum / static_cast<double>(plane.points);
}

void TrackMap::touch(PlaneTrack& plane, int step)
{
    plane.changedStep = step;
    ++plane.revision;
    plane.published = nullptr;
    stamp(plane);
}

const SegmentBatch& TrackMap::together(std::span<const SegmentNumber> numbers)
{
    together_.fill(numbers.size(), [&](std::size_t i) {
        const TrackedSegment& s = segment(numbers[i]);
        return SegmentBatch::Placed{&s.statistics, &slice(s.slice).frame};
    });
    return together_;
}

bool TrackMap::rebuild(PlaneTrack& plane, const SegmentBatch& counting, const NoiseParameters& noise, double floor)
{
    PlaneEstimate estimate(plane.estimate.normal(), plane.estimate.distance());
    estimate.accumulate(counting, noise, floor);
    if (!estimate.solve())
        return false;
    plane.estimate = estimate;
    plane.fitted = counting.size();
    plane.linearisedAt = plane.points;
    plane.slicesUnsolved = 0;
    plane.seenIn = -1;
    stamp(plane);
    return true;
}

bool TrackMap::rebuild(PlaneTrack& plane, const Parameters& parameters)
{
    return rebuild(plane, together(plane.members), parameters.noise, parameters.noise.systematic);
}

PlaneTrack* TrackMap::makePlane(std::vector<SegmentNumber> members, const PlaneEstimate& start, int step,
                                const Parameters& parameters)
{
    std::sort(members.begin(), members.end());
    PlaneTrack plane;
    plane.id = nextPlane_;
    plane.estimate = start;
    plane.members = std::move(members);
    plane.bornStep = plane.changedStep = step;
    int last = -1;
    for (const SegmentNumber number : plane.members) {
        const TrackedSegment& s = segment(number);
        plane.points += s.statistics.points;
        plane.slices += s.slice != last ? 1 : 0;
        last = s.slice;
    }
    plane.lastSlice = last;
    if (!rebuild(plane, parameters))
        return nullptr;
    ++nextPlane_;
    for (const SegmentNumber number : plane.members)
        segment(number).owner = plane.id;
    lastPlace_.push_back(planes_.size());
    planes_.push_back(std::move(plane));
    return &planes_.back();
}

void TrackMap::join(PlaneTrack& plane, std::span<const SegmentNumber> numbers, int step, const Parameters& parameters)
{
    const int place = segment(numbers.front()).slice;
    const PlaneInSlice& seen = seenIn(plane, place);
    const auto isLater = [&](int wanted, SegmentNumber number) { return wanted < segment(number).slice; };
    auto end = plane.members.end();
    if (isLater(place, plane.members.back()))
        end = std::upper_bound(plane.members.begin(), end, place, isLater);
    group_.clear();
    for (auto member = end; member != plane.members.begin() && segment(*(member - 1)).slice == place; --member)
        group_.push_back(&segment(*(member - 1)).statistics);
    // Segments of one slice share its pitch error: those that are in already are taken out and put back with the new.
    if (!group_.empty())
        plane.estimate.accumulate(seen, group_, parameters.noise, parameters.noise.systematic, -1.0);
    else
        ++plane.slices;
    for (const SegmentNumber number : numbers) {
        group_.push_back(&segment(number).statistics);
        segment(number).owner = plane.id;
        plane.points += segment(number).statistics.points;
        ++plane.fitted;
        if (plane.members.back() < number)
            plane.members.push_back(number);
        else
            plane.members.insert(std::upper_bound(plane.members.begin(), plane.members.end(), number), number);
    }
    plane.estimate.accumulate(seen, group_, parameters.noise, parameters.noise.systematic, 1.0);
    plane.lastSlice = std::max(plane.lastSlice, place);
    touch(plane, step);
    if (++plane.slicesUnsolved >= kSolveEvery || plane.slices <= kYoungSlices) {
        plane.estimate.solve();
        plane.slicesUnsolved = 0;
        if (plane.points > kRelineariseGrowth * plane.linearisedAt ||
            plane.estimate.angleFromLinearisation() > kRelineariseAngle)
            rebuild(plane, parameters);
    }
}

std::vector<PlaneTrack*> TrackMap::collectMembers(std::span<const PlaneId> changed, int step)
{
    if (changed.empty())
        return {};
    std::vector<PlaneTrack*> byId(static_cast<std::size_t>(nextPlane_), nullptr);
    for (const PlaneId id : changed) {
        PlaneTrack& of = plane(id);
        byId[static_cast<std::size_t>(id)] = &of;
        of.members.clear();
        of.points = 0;
        of.slices = 0;
        of.lastSlice = -1;
    }
    for (SegmentNumber number = 0; number < segments(); ++number) {
        const TrackedSegment& s = segment(number);
        PlaneTrack* of = s.owner == kNoPlane ? nullptr : byId[static_cast<std::size_t>(s.owner)];
        if (of == nullptr)
            continue;
        of->members.push_back(number);
        of->points += s.statistics.points;
        of->slices += s.slice != of->lastSlice ? 1 : 0;
        of->lastSlice = s.slice;
    }
    std::erase_if(planes_, [](const PlaneTrack& plane) { return plane.members.empty(); });
    std::vector<PlaneTrack*> left;
    for (PlaneTrack& plane : planes_) {
        if (byId[static_cast<std::size_t>(plane.id)] == nullptr)
            continue;
        touch(plane, step);
        left.push_back(&plane);
    }
    return left;
}

void TrackMap::dissolve(PlaneId id)
{
    for (const SegmentNumber number : plane(id).members)
        free(number);
    std::erase_if(planes_, [id](const PlaneTrack& plane) { return plane.id == id; });
}

std::vector<SegmentNumber> TrackMap::settleClusters()
{
    clusters.remove([this](SegmentNumber number) { return segment(number).owner != kNoPlane; });
    std::vector<SegmentNumber> homeless = std::exchange(freed_, {});
    if (homeless.empty())
        return homeless;
    std::sort(homeless.begin(), homeless.end());
    homeless.erase(std::unique(homeless.begin(), homeless.end()), homeless.end());
    std::vector<char> clustered(segments_.size(), 0);
    for (const GrowingCluster& cluster : clusters.all()) {
        for (const GrowingCluster::Member& member : cluster.members)
            clustered[static_cast<std::size_t>(member.segment)] = 1;
    }
    std::erase_if(homeless, [&](SegmentNumber number) {
        return segment(number).owner != kNoPlane || clustered[static_cast<std::size_t>(number)] != 0;
    });
    return homeless;
}

}  // namespace planewright
