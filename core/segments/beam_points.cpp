// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/beam_points.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "core/segments/breakpoints.h"
#include "core/types/square.h"

namespace planewright {

namespace {

/// Beams over which 1/ρ may be followed across a gap.
constexpr int kFollowedBeams = 4;
/// Elements that the loops over points may read after the last.
constexpr std::size_t kReadAhead = 15;

}  // namespace

/// Closes up the beams without echo, a run of echoes at a time.
void BeamPoints::dropMissing(int beams)
{
    constexpr std::uint8_t kEcho = 0;
    constexpr std::uint8_t kMissing = 1;
    kernels_->markMissing(range_.data(), beams, marks_.data());  // which are free until gaps are looked for
    const auto next = [&](int from, std::uint8_t kind) {
        const void* found = from < beams ? std::memchr(marks_.data() + from, kind, at(beams - from)) : nullptr;
        return found == nullptr ? beams : static_cast<int>(static_cast<const std::uint8_t*>(found) - marks_.data());
    };
    int kept = 0;
    wideGaps_.clear();
    for (int first = next(0, kEcho); first < beams;) {
        const int end = next(first, kMissing);
        if (kept > 0 && first - beam_[at(kept - 1)] > kBridgedBeams)
            wideGaps_.push_back(kept);
        std::iota(beam_.begin() + kept, beam_.begin() + kept + (end - first), first);
        if (kept != first) {
            for (std::vector<float>* numbers : {&range_, &u_, &v_, &relativeVariance_})
                std::memmove(numbers->data() + kept, numbers->data() + first, at(end - first) * sizeof(float));
        }
        kept += end - first;
        first = next(end, kEcho);
    }
}

void BeamPoints::take(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters)
{
    place(slice, sensor, parameters.noise);
    if (count_ == 0)
        return;
    kernels_->markGaps(arrays(), range_.data(), count_,
                       static_cast<float>(gapPerRange(breakpointStep(slice.bearingStep), parameters.segments)),
                       static_cast<float>(parameters.segments.breakpointSigmas), marks_.data());
    liftGaps(parameters, slice.bearingStep);
}

void BeamPoints::place(const ScanSlice& slice, const SensorModel& sensor, const NoiseParameters& noise)
{
    tables_.select(slice);
    const BearingTables<float>::Table& table = tables_.current();
    const int beams = static_cast<int>(slice.ranges.size());
    if (beam_.size() != slice.ranges.size()) {
        const std::size_t padded = slice.ranges.size() + kReadAhead;
        range_.resize(padded);
        u_.resize(padded);
        v_.resize(padded);
        relativeVariance_.resize(padded);
        beam_.resize(slice.ranges.size());
        marks_.resize(slice.ranges.size());
    }
    count_ = kernels_->place(slice.ranges.data(), table.cosine.data(), table.sine.data(), beams,
                             std::max(1e-6F, static_cast<float>(sensor.rangeMin)), static_cast<float>(sensor.rangeMax),
                             static_cast<float>(square(noise.rangeConstant)),
                             static_cast<float>(square(noise.rangeProportional)), range_.data(), u_.data(), v_.data(),
                             relativeVariance_.data());
    if (count_ < beams) {
        dropMissing(beams);
    } else {
        std::iota(beam_.begin(), beam_.end(), 0);
        wideGaps_.clear();
    }
}

/// Looks again at the gaps found: beams between may be missing, and a wall seen at a shallow angle has wide gaps
/// between points that all lie on it. 1/ρ of a straight line is A cos θ + B sin θ, nearly linear in the bearing.
void BeamPoints::liftGaps(const Parameters& parameters, double bearingStep)
{
    const auto inverse = [this](int i) { return 1.0 / range(i); };
    const auto slope = [&](int i) { return (inverse(i) - inverse(i - 1)) / (beam(i) - beam(i - 1)); };
    const auto near = [this](int i) { return i >= 1 && i < count_ && beam(i) - beam(i - 1) <= kFollowedBeams; };
    const double bearingShare = parameters.noise.bearing / bearingStep;
    const auto goesOn = [&](int i, int j) {  // from the gap before i to the gap before j, which is a neighbour
        if (!near(j))
            return false;
        const double here = slope(i);
        const double there = slope(j);
        if (here * there <= 0.0)
            return false;
        const double larger = std::max(std::abs(here), std::abs(there));
        const double q = inverse(i - 1);
        const double sigma =
            parameters.noise.rangeConstant * q * q + parameters.noise.rangeProportional * q + bearingShare * larger;
        const double difference = std::abs(here - there);
        return difference < 9.6 * sigma * (beam(i) - beam(i - 1)) && difference < 0.5 * larger;
    };
    for (const int i : wideGaps_)
        marks_[at(i)] = 1;
    for (int i = nextBreak(1); i < count_; i = nextBreak(i + 1)) {
        std::uint8_t& mark = marks_[at(i)];
        const int beams = beam(i) - beam(i - 1);
        if (beams > kBridgedBeams)
            continue;
        if (beams > 1) {
            const double limit = breakpointDistance(range(i - 1), breakpointStep(bearingStep * beams),
                                                    parameters.segments, parameters.noise);
            if (std::hypot(u(i) - u(i - 1), v(i) - v(i - 1)) < limit) {
                mark = 0;
                continue;
            }
        }
        if (near(i) && (goesOn(i, i - 1) || goesOn(i, i + 1)))
            mark = 0;
    }
}

int BeamPoints::nextBreak(int i) const
{
    if (i >= count_)
        return count_;
    const void* mark = std::memchr(marks_.data() + i, 1, at(count_ - i));
    return mark == nullptr ? count_ : static_cast<int>(static_cast<const std::uint8_t*>(mark) - marks_.data());
}

}  // namespace planewright
