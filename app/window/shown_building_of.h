// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "app/window/building_maker.h"
#include "ui/common/shown_map.h"

namespace planewright {

/// What the window shows of a map whose `stops`, `floors` and `planes` are there. `allStops` are as many as there would
/// be after the last one; `edits` are those in force.
std::shared_ptr<const ShownMap> shownMapOf(const BuiltMap& built, std::span<const StopInput> omitted,
                                           std::span<const MapEdit> edits, std::size_t allStops);

}  // namespace planewright
