// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/map_exports.h"

#include <algorithm>

#include "app/cli/output_file.h"
#include "app/files/file_kind.h"
#include "app/files/scan_results.h"
#include "core/formats/trajectory_tum.h"

namespace planewright {

namespace {

constexpr double kPlanScale = 100.0;

}  // namespace

std::span<const std::string_view> suffixesOf(MapExport kind)
{
    switch (kind) {
        case MapExport::MapPlanes:
            return kPlanesSuffixes;
        case MapExport::MapPlan:
            return kMapPlanSuffixes;
        case MapExport::MapPoses:
            break;
    }
    return {};
}

Result<std::function<Result<void>()>> exportOf(const std::shared_ptr<const BuiltMap>& map, MapExport kind,
                                               const QString& file, int floor, double cutHeight)
{
    const std::string path = file.toStdString();
    const auto whole = [path](const std::function<Result<void>(std::ostream&)>& write) {
        return OutputFile::writeWhole(path, true, write);
    };
    if (kind == MapExport::MapPoses)
        return [map, whole] {
            return whole([&](std::ostream& out) { return writeTrajectoryTum(out, posesOfFloors(map->floors)); });
        };
    const auto suffix = suffixOf(path, suffixesOf(kind), "the export");
    if (!suffix)
        return tl::unexpected{suffix.error()};
    if (kind == MapExport::MapPlanes)
        return [map, whole, suffix = *suffix] {
            ScanResults results;
            results.parameters = map->parameters;
            results.planes = map->planes;
            return whole([&](std::ostream& out) { return planesWriter(suffix)(out, results); });
        };
    const auto plan = std::ranges::find(map->plans, floor, &FloorPlan::floor);
    if (plan == map->plans.end())
        return fail(ErrorCode::Usage, "The map has no floor " + std::to_string(floor) + "; choose one of its floors.");
    FloorPlan cut = *plan;
    cut.height += cutHeight;
    return [cut, whole, suffix = *suffix] {
        return whole([&](std::ostream& out) { return writeFloorPlan(out, suffix, cut, kPlanScale); });
    };
}

}  // namespace planewright
