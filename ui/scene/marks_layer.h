// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <set>
#include <vector>
#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include "ui/common/beam_run.h"
#include "ui/common/layer_settings.h"
#include "ui/common/shown_map.h"
#include "ui/scene/scene_geometry.h"

namespace planewright {

/// A measurement to draw: a line between two points.
struct MeasuredLine {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
};

/// The echoes of a piece in the scan [m]; none where its slice is not there.
std::vector<Eigen::Vector3d> pointsOf(const BeamRun& piece, const ShownMap& map);

/// What is there to orient oneself: the scanner, the fan of the current slice, a grid of 2 m on the ground, lines of
/// measurements, and the points of pieces that were discarded and are chosen.
class MarksLayer {
public:
    explicit MarksLayer(vtkRenderer* renderer);

    /// `bounds` are those of what was scanned [m]; the grid lies at its bottom.
    void update(const ShownMap& map, const Eigen::AlignedBox3d& bounds, const LayerSettings& settings, Theme theme,
                const std::vector<MeasuredLine>& measured, const std::set<BeamRun>& pieces, double pixelRatio);

private:
    vtkSmartPointer<vtkActor> grid_;
    vtkSmartPointer<vtkActor> sensor_;
    vtkSmartPointer<vtkActor> fan_;
    vtkSmartPointer<vtkActor> measured_;
    vtkSmartPointer<vtkActor> pieces_;
};

}  // namespace planewright
