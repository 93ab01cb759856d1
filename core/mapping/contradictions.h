// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/mapping/building_map.h"

namespace planewright {

/// Leaves a sighting open that contradicts all others of its plane, two at least, which agree with each other: a stop
/// that took two surfaces for one tells of a plane in between, and is surer of it than those that saw less. Only where
/// no other sighting could be the wrong one, and nobody matched by hand. Returns how many were left open: the map is to
/// be adjusted again.
int openContradictions(BuildingMap& map);

}  // namespace planewright
