// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vtkRenderer.h>

#include "ui/common/shown_building.h"
#include "ui/scene/scene_geometry.h"

namespace planewright {

/// Colours of the way from stop to stop: as the map has it, and as odometry alone has it.
Rgb correctedWayColour(Theme theme);
Rgb rawWayColour(Theme theme);

/// The way from stop to stop, floor by floor: corrected with a dot for each stop, and by odometry alone.
class TrajectoryLayer {
public:
    explicit TrajectoryLayer(vtkRenderer* renderer);

    /// Null: there is none.
    void update(const ShownBuilding* building, Theme theme, double pixelRatio);

private:
    vtkSmartPointer<vtkActor> raw_;
    vtkSmartPointer<vtkActor> corrected_;
};

}  // namespace planewright
