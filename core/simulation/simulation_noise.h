// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/types/error.h"

namespace planewright {

/// What the simulated scanner does wrong. All zero: nothing. Errors are normally distributed, σ given here.
struct SimulationNoise {
    double rangeConstant = 0.0;      ///< [m]; σ of range is the root of the sum of squares of this and the next
    double rangeProportional = 0.0;  ///< [m per m]
    std::optional<double> rangeFar;  ///< takes the place of both from rangeFarFrom on [m]
    double rangeFarFrom = 10.0;      ///< [m]
    double bearing = 0.0;            ///< one draw per beam [rad]
    double pitch = 0.0;              ///< one draw per slice, common to its beams [rad]
    double dropout = 0.0;            ///< share of returns lost, 0 to 1
    bool mixedPixels = false;        ///< a beam that hits two depths measures between them
    double footprint = 2.2e-3;       ///< full width of the beam, for mixed pixels [rad]

    /// Standard deviation of a range [m].
    double rangeSigma(double range) const;
};

/// The profiles by name: none, default, P, S, A.
std::span<const std::string_view> simulationNoiseNames();

/// A noise profile; an unknown name is a Usage error that lists the known ones.
///
/// none: exact. default: 8 mm and 1 mm/m, bearing 0.02°, pitch 0.084°, 0.4 % dropouts, mixed pixels. P: 3 mm/m. S:
/// 10 mm below 10 m, 30 mm above. A: 30 mm below 10 m, 50 mm above. P, S and A: bearing 0.072°, pitch 0.084°, no
/// dropouts, no mixed pixels.
Result<SimulationNoise> simulationNoise(std::string_view profile);

}  // namespace planewright
