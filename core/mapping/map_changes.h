// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/mapping/building_map.h"

namespace planewright {

/// Makes two planes of a map one: the second keeps its number and loses its sightings to the first.
void mergePlanes(BuildingMap& map, std::size_t kept, std::size_t gone);

/// Moves stops by errors ξ about the origin, T ← exp(ξ) T, and each plane with the stop that saw it first.
void moveStops(BuildingMap& map, std::span<const Vector6d> corrections);

/// Adds a sighting to a plane and fuses the parameters; the covariance stays the better one of both, since the errors
/// of stops that stand near to each other are not independent.
void addSighting(BuildingMap& map, std::size_t plane, const Sighting& sighting);

/// Adds a plane that one stop saw, and gives its number.
std::size_t addPlane(BuildingMap& map, const Sighting& sighting);

/// How far a stop's plane, where the stop stands, is from a plane of the map; both taken as independent: 3 expected.
double chiSquareOf(const BuildingMap& map, const Sighting& sighting, std::size_t plane);

/// True where somebody said that a sighting belongs to a plane.
bool isByHand(const BuildingMap& map, std::size_t plane);

/// Takes a sighting off its plane.
void removeSighting(BuildingMap& map, const Sighting& sighting);

}  // namespace planewright
