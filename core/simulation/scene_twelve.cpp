// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/random.h"
#include "core/simulation/scene_builder.h"
#include "core/simulation/scenes.h"

namespace planewright {

/// The planes of Table XII, each a free-standing panel that no other hides; id = number in the table − 1.
///
/// Each wall panel keeps to its own range of bearings in plan, the floor lies below and the ceiling above them all.
Scene makeTwelve(std::uint64_t seed)
{
    Random random(seed);
    const auto trim = [&random] { return random.uniform(0.0, 0.15); };

    SceneBuilder yard("twelve");
    const auto facingX = [&](const char* name, double x, double near, double far) {
        yard.wall(name, {{x, near + trim()}, {x, far - trim()}, -0.9 + trim(), 2.0 - trim()});
    };
    const auto facingY = [&](const char* name, double y, double left, double right) {
        yard.wall(name, {{left + trim(), y}, {right - trim(), y}, -0.9 + trim(), 2.0 - trim()});
    };
    facingX("1", -12.6, 0.3, 2.6);
    facingX("2", -12.28, 3.0, 6.0);
    facingY("3", 2.58, -1.6, -0.6);
    facingX("4", -2.11, 1.5, 3.0);
    facingY("5", 3.69, 0.6, 1.6);
    facingX("6", 1.83, 2.0, 3.3);
    facingY("7", 3.37, -0.55, 0.45);
    facingX("8", 6.34, 4.0, 6.4);
    facingX("9", 10.79, 3.0, 5.6);
    facingX("10", 21.28, 0.3, 3.1);
    yard.level("11", 2.0, {-1.5 + trim(), -0.5}, {1.5 - trim(), 2.4 - trim()});
    yard.level("12", -0.9, {-1.5 + trim(), -0.5}, {1.5 - trim(), 2.4 - trim()});
    return yard.build({});
}

}  // namespace planewright
