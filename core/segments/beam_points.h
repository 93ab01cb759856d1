// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/segments/beam_kernels.h"
#include "core/segments/bearing_tables.h"
#include "core/segments/line_moments.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// Beams without echo that a run may bridge.
inline constexpr int kBridgedBeams = 8;

/// The echoes of a slice in the slice's own plane, as structures of floats, and the gaps between them.
///
/// Points are numbered among the echoes, in bearing order. Keeps its storage from slice to slice.
class BeamPoints {
public:
    explicit BeamPoints(const BeamKernels& kernels) : kernels_(&kernels) {}

    /// Takes in a slice and marks its breakpoints: gaps beyond D_o of Eq. (3), lifted where 1/ρ is linear in the
    /// bearing, as it is on any straight wall however shallow. Ranges must be finite.
    void take(const ScanSlice& slice, const SensorModel& sensor, const Parameters& parameters);

    int count() const { return count_; }
    double u(int i) const { return static_cast<double>(u_[at(i)]); }
    double v(int i) const { return static_cast<double>(v_[at(i)]); }
    double range(int i) const { return static_cast<double>(range_[at(i)]); }
    int beam(int i) const { return beam_[at(i)]; }
    /// True where a new surface begins with point i.
    bool breaksBefore(int i) const { return marks_[at(i)] != 0; }
    /// The first point from i on with which a new surface begins; count() where there is none.
    int nextBreak(int i) const;

    BeamArrays arrays() const { return {u_.data(), v_.data(), relativeVariance_.data()}; }
    const BeamKernels& kernels() const { return *kernels_; }

    /// The chord from one point to another.
    ChordF chordOf(int first, int last) const;
    /// Moments of the points [first, last], summed up in the frame of a chord near them.
    LineMoments momentsOf(int first, int last, const ChordF& chord) const;

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    void place(const ScanSlice& slice, const SensorModel& sensor, const NoiseParameters& noise);
    void dropMissing(int beams);
    void liftGaps(const Parameters& parameters, double bearingStep);

    const BeamKernels* kernels_;
    BearingTables<float> tables_;
    std::vector<float> range_, u_, v_, relativeVariance_;  // of the echoes only
    std::vector<int> beam_;                                // of each echo
    int count_ = 0;
    std::vector<std::uint8_t> marks_;
    std::vector<int> wideGaps_;  // points before which too many beams are missing
};

inline ChordF BeamPoints::chordOf(int first, int last) const
{
    const auto a = static_cast<std::size_t>(first);
    const auto b = static_cast<std::size_t>(last);
    ChordF chord{u_[a], v_[a], u_[b] - u_[a], v_[b] - v_[a]};
    const float length = std::sqrt(chord.directionU * chord.directionU + chord.directionV * chord.directionV);
    if (length > 0.0F) {
        chord.directionU /= length;
        chord.directionV /= length;
    } else {
        chord.directionU = 1.0F;
        chord.directionV = 0.0F;
    }
    return chord;
}

inline LineMoments BeamPoints::momentsOf(int first, int last, const ChordF& chord) const
{
    const ChordSums sums = kernels_->sums(arrays(), first, last, chord);
    const auto n = static_cast<double>(sums.weight);
    const double t = static_cast<double>(sums.t) / n;
    const double h = static_cast<double>(sums.h) / n;
    const double tt = static_cast<double>(sums.tt) - n * t * t;
    const double th = static_cast<double>(sums.th) - n * t * h;
    const double hh = static_cast<double>(sums.hh) - n * h * h;
    const auto c = static_cast<double>(chord.directionU);
    const auto s = static_cast<double>(chord.directionV);
    LineMoments moments;
    moments.count = n;
    moments.u = static_cast<double>(chord.u) + c * t - s * h;
    moments.v = static_cast<double>(chord.v) + s * t + c * h;
    moments.uu = c * c * tt - 2.0 * c * s * th + s * s * hh;
    moments.uv = c * s * (tt - hh) + (c * c - s * s) * th;
    moments.vv = s * s * tt + 2.0 * c * s * th + c * c * hh;
    return moments;
}

}  // namespace planewright
