// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"
#include "ui/common/shown_map.h"

namespace planewright {

/// What the window shows of a simulated scan with the settings of a name, up to and with a step; −1 for all of it and
/// the last pass.
inline std::shared_ptr<const ShownMap> shownRoom(const std::string& scene, int untilStep = -1,
                                                 const std::string& settings = "table8")
{
    constexpr std::uint64_t kSeed = 7;
    const SimulatedScan scan =
        simulate(*makeScene(scene, kSeed), *acquisitionSettings(settings), *simulationNoise("default"), kSeed);
    Parameters parameters;
    apply(methodPresets().front(), parameters);
    auto map = std::make_shared<ShownMap>();
    map->sensor = sensorOf(scan.recording.description);
    map->plannedSteps = static_cast<int>(scan.recording.slices.size());
    PlaneExtractor extractor(map->sensor, parameters);
    for (const ScanSlice& slice : scan.recording.slices) {
        if (untilStep >= 0 && slice.step > untilStep)
            break;
        map->snapshot = extractor.step(slice);
        map->slices.push_back(std::make_shared<ScanSlice>(slice));
        map->step = slice.step;
    }
    if (untilStep < 0) {
        map->snapshot = extractor.finish();
        map->finished = true;
    }
    for (const auto& plane : map->snapshot->planes)
        map->planes.push_back({plane, "", "", false, false, filledOutlineOf(*plane, map->snapshot->segments)});
    return map;
}

}  // namespace planewright
