// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/geometry/sensor_model.h"
#include "core/types/plane.h"
#include "core/types/scan_slice.h"
#include "core/types/snapshot.h"
#include "ui/common/filled_outline.h"
#include "ui/common/shown_building.h"

namespace planewright {

/// A plane with what the operator has made of it.
struct ShownPlane {
    std::shared_ptr<const Plane> plane;
    std::string name;       ///< empty until someone names it
    std::string className;  ///< floor, ceiling, wall, …
    bool hidden = false;
    bool locked = false;
    /// Null until it was worked out, and of an earlier revision until that is done again.
    std::shared_ptr<const FilledOutline> outline;
};

/// What the window shows of a scan at one moment: immutable, shared, and sharing with the moment before.
struct ShownMap {
    std::shared_ptr<const Snapshot> snapshot;              ///< null before the first step
    std::vector<ShownPlane> planes;                        ///< in order of id, after the operator's edits
    std::vector<std::shared_ptr<const ScanSlice>> slices;  ///< up to the snapshot's step
    SensorModel sensor;                                    ///< of the slices
    int step = -1;                                         ///< the newest slice's; −1 before the first
    int plannedSteps = 0;                                  ///< 0 where nobody knows
    bool finished = false;                                 ///< the forced last pass has been made
    std::shared_ptr<const ShownBuilding> building;         ///< of a map of several stops, which has no slices
};

}  // namespace planewright
