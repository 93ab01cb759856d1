// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/evaluation/plane_errors.h"
#include "core/types/angle.h"

namespace planewright {

/// Two planes are one where their normals differ by no more than this …
inline constexpr double kCoplanarAngle = degrees(0.1);
/// … and each lies within this of the other, measured at the foot of the perpendicular from the origin [m].
inline constexpr double kCoplanarDistance = 0.002;

/// True where two planes are the same but for rounding: kCoplanarAngle and kCoplanarDistance both hold.
bool areCoplanar(const ComparedPlane& a, const ComparedPlane& b);

/// For each plane the place of the first plane of its group: planes joined by a chain of coplanar pairs. Quadratic in
/// the planes.
std::vector<std::size_t> coplanarGroups(std::span<const ComparedPlane> planes);

}  // namespace planewright
