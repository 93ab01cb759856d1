// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "core/simulation/scene.h"

namespace planewright {

// One room each; makeScene() gives them out by name.
Scene makeCorridor(std::uint64_t seed);
Scene makeOffice(std::uint64_t seed);
Scene makeHall(std::uint64_t seed);
Scene makeCurved(std::uint64_t seed);
Scene makeStairs(std::uint64_t seed);
Scene makeTwelve(std::uint64_t seed);
Scene makeClutter(std::uint64_t seed);
Scene makeHostile(std::uint64_t seed);

}  // namespace planewright
