// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/types/plane.h"

namespace planewright {

/// What planes are called on the screen: "P07".
std::string planeLabel(PlaneId id);

/// The classes that a plane may be given.
inline constexpr std::array<std::string_view, 5> kPlaneClasses{"floor", "ceiling", "wall", "door?", "other"};

/// How a plane came to be what it is: "live" as it was fitted, "merged" out of others, "split" off another.
std::string planeState(const Plane& plane);

/// "P03←P07+P11" for a plane made of others; empty for one fitted from segments.
std::string lineageText(const Plane& plane);

/// What segments are called on the screen, where steps count from 1: "64.3" for the segment 63.3 of files.
std::string segmentLabel(const SegmentId& id);

}  // namespace planewright
