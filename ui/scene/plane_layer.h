// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <set>
#include <vector>
#include <vtkRenderer.h>

#include "ui/common/shown_map.h"
#include "ui/scene/colouring.h"
#include "ui/scene/scene_geometry.h"

namespace planewright {

/// Planes as translucent areas with outlines. Areas are drawn from back to front, so that they need no depth peeling.
class PlaneLayer {
public:
    explicit PlaneLayer(vtkRenderer* renderer);

    void update(const ShownMap& map, const Colouring& colouring, const LayerSettings& settings, Theme theme,
                const std::set<PlaneId>& selected, PlaneId hovered, double pixelRatio);

    /// Orders the areas for a camera at `eye` that looks along `forward`; `parallel` where depth is along that only.
    void sortFor(const Eigen::Vector3d& eye, const Eigen::Vector3d& forward, bool parallel);

private:
    struct Area {
        Triangle corners;
        Rgb colour;
        double opacity;
    };

    std::vector<Area> areas_;
    vtkSmartPointer<vtkActor> fill_;
    vtkSmartPointer<vtkActor> outlines_;
    vtkSmartPointer<vtkActor> selected_;
    vtkSmartPointer<vtkActor> selectedInner_;
};

}  // namespace planewright
