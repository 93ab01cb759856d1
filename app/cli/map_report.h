// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/mapping/map_floors.h"

namespace planewright {

/// Every stop of a map in a row: where it is, how well that is known and what it rests on, and its planes.
std::string mapTable(std::span<const MappedFloor> floors, std::span<const StopScan> stops);

/// What a person must know who uses the map: stops that are left out, or that planes alone do not place.
std::vector<std::string> mapWarnings(std::span<const MappedFloor> floors, std::span<const StopScan> stops);

}  // namespace planewright
