// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// Finds the noise of ranges in the scan itself, slice by slice.
///
/// On a straight wall 1/ρ is A cos θ + B sin θ, so that three neighbouring beams give a residual that is free of the
/// wall: ρ²(1/ρ₋ − 2 cos Δθ/ρ + 1/ρ₊)/√6 has the standard deviation σ_ρ. Its sizes are counted by range, and the
/// median of each count, without what edges and mixed pixels add, tells σ_ρ there.
class RangeNoise {
public:
    /// Takes samples of a slice: many of the first slices, fewer when much is known.
    void add(const ScanSlice& slice, const SensorModel& sensor, const NoiseParameters& told);

    /// The noise told, with the constant and the proportional part of the range noise as found. What was told counts
    /// like some samples, so that it holds until there are more. Neither part becomes less than a sixteenth of what was
    /// told, and none less at all where ranges are told to err together (`noise.systematic`), which this residual
    /// cannot see.
    NoiseParameters estimate(const NoiseParameters& told) const;

    /// Standard deviation of the ranges of this scan by what was found over that by what was told; 1 without samples.
    double share(const NoiseParameters& found, const NoiseParameters& told) const;

    std::int64_t samples() const { return samples_; }

private:
    /// Octaves of range from 1/16 m to 128 m, and in each the sizes from 2⁻¹⁶ m to 4 m, eight to the octave.
    static constexpr std::size_t kRanges = 11;
    static constexpr std::size_t kSizes = std::size_t{18} * 8;

    struct Octave {
        std::array<std::uint32_t, kSizes> counts{};
        std::int64_t samples = 0;
        double squaredRanges = 0.0;  // [m²]
    };

    static double sigmaOf(const Octave& octave);

    std::array<Octave, kRanges> octaves_{};
    std::int64_t samples_ = 0;
    std::size_t slices_ = 0;
};

}  // namespace planewright
