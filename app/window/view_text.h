// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <set>

#include <QString>

#include "core/types/line_segment.h"
#include "core/types/plane.h"
#include "ui/common/layer_settings.h"
#include "ui/scene/camera_motion.h"

namespace planewright {

/// What is chosen in a map.
struct ChosenParts {
    std::set<PlaneId> planes;
    std::set<SegmentId> segments;
};

// What is kept of a view, as texts that settings and recordings hold. Reading trusts nothing: a text that is not whole
// and in range gives nothing.

/// Target [m], distance [m], heading, elevation and view angle [rad], and 1 for parallel projection.
QString textOf(const ViewCamera& camera);
std::optional<ViewCamera> cameraOf(const QString& text);

/// JSON; without the palette, which is the user's and not the scan's.
QString textOf(const LayerSettings& layers);
std::optional<LayerSettings> layersOf(const QString& text);

/// "63.3": step and index.
std::optional<SegmentId> segmentIdOf(const QString& text);

/// JSON: `{"planes":[3,7],"segments":["63.3"]}`.
QString textOf(const ChosenParts& chosen);
std::optional<ChosenParts> chosenOf(const QString& text);

}  // namespace planewright
