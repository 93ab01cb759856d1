// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/scene.h"

#include <array>

#include "core/simulation/scenes.h"

namespace planewright {

namespace {

Scene makeEmpty(std::uint64_t /*seed*/)
{
    Scene scene;
    scene.name = "empty";
    return scene;
}

using Maker = Scene (*)(std::uint64_t seed);

constexpr std::array<std::string_view, 9> kNames{"corridor", "office",  "hall",  "curved", "stairs",
                                                 "twelve",   "clutter", "empty", "hostile"};
constexpr std::array<Maker, kNames.size()> kMakers{makeCorridor, makeOffice,  makeHall,  makeCurved, makeStairs,
                                                   makeTwelve,   makeClutter, makeEmpty, makeHostile};

}  // namespace

std::span<const std::string_view> sceneNames()
{
    return kNames;
}

Result<Scene> makeScene(std::string_view name, std::uint64_t seed)
{
    std::string known;
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (kNames[i] == name)
            return kMakers[i](seed);
        known += (known.empty() ? "" : ", ") + std::string(kNames[i]);
    }
    return fail(ErrorCode::Usage, "No scene is called '" + std::string(name) + "'. Known: " + known + ".");
}

}  // namespace planewright
