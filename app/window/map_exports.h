// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include <QString>

#include "app/window/building_maker.h"
#include "core/types/error.h"

namespace planewright {

/// What can be exported of a map.
enum class MapExport { MapPlanes, MapPoses, MapPlan };

/// Suffixes of a kind's files, the usual one first; none: any name will do.
std::span<const std::string_view> suffixesOf(MapExport kind);

/// What writes a part of a map to a file, whose suffix says how: the same bytes as `planewright-cli map` writes of the
/// same stops. A plan is of the floor, cut so high above it [m]; an SVG at 1:100. An existing file is replaced once the
/// new one is complete. To be called on any thread; its errors: NotWritten. Errors: Usage for another suffix.
Result<std::function<Result<void>()>> exportOf(const std::shared_ptr<const BuiltMap>& map, MapExport kind,
                                               const QString& file, int floor, double cutHeight);

}  // namespace planewright
