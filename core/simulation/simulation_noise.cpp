// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/simulation_noise.h"

#include <array>
#include <cmath>
#include <string>

#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr std::array<std::string_view, 5> kNames{"none", "default", "P", "S", "A"};

SimulationNoise defaultNoise()
{
    SimulationNoise noise;
    noise.rangeConstant = 0.008;
    noise.rangeProportional = 0.001;
    noise.bearing = degrees(0.02);
    noise.pitch = degrees(0.084);
    noise.dropout = 0.004;
    noise.mixedPixels = true;
    return noise;
}

/// The angle noise is that of rounding to steps of 0.25° and 0.29°.
SimulationNoise quantisedAngles()
{
    SimulationNoise noise;
    noise.bearing = degrees(0.072);
    noise.pitch = degrees(0.084);
    return noise;
}

}  // namespace

double SimulationNoise::rangeSigma(double range) const
{
    if (rangeFar && range >= rangeFarFrom)
        return *rangeFar;
    return std::hypot(rangeConstant, rangeProportional * range);
}

std::span<const std::string_view> simulationNoiseNames()
{
    return kNames;
}

Result<SimulationNoise> simulationNoise(std::string_view profile)
{
    if (profile == "none")
        return SimulationNoise{};
    if (profile == "default")
        return defaultNoise();

    SimulationNoise noise = quantisedAngles();
    if (profile == "P") {
        noise.rangeProportional = 0.003;
        return noise;
    }
    if (profile == "S") {
        noise.rangeConstant = 0.010;
        noise.rangeFar = 0.030;
        return noise;
    }
    if (profile == "A") {
        noise.rangeConstant = 0.030;
        noise.rangeFar = 0.050;
        return noise;
    }

    std::string known;
    for (const std::string_view name : kNames)
        known += (known.empty() ? "" : ", ") + std::string(name);
    return fail(ErrorCode::Usage, "No noise profile is called '" + std::string(profile) + "'. Known: " + known + ".");
}

}  // namespace planewright
