// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Core>

#include "ui/common/palette.h"

namespace planewright {

/// Coloured points, lines or triangles that become the geometry of one actor at once.
class SceneGeometry {
public:
    /// Colours have an opacity of 0 to 1 where `translucent`.
    explicit SceneGeometry(bool translucent = false);

    void addPoint(const Eigen::Vector3d& point, Rgb colour);
    void addLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Rgb colour);
    void addTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, Rgb colour,
                     double opacity);

    /// Makes this the geometry of an actor that makeActor() made.
    void give(vtkActor* actor) const;

private:
    vtkIdType addVertex(const Eigen::Vector3d& point, Rgb colour, double opacity);

    bool translucent_;
    vtkNew<vtkFloatArray> coordinates_;
    vtkNew<vtkUnsignedCharArray> colours_;
    vtkNew<vtkCellArray> verts_;
    vtkNew<vtkCellArray> lines_;
    vtkNew<vtkCellArray> triangles_;
};

/// An actor without light that shows its geometry's own colours.
vtkSmartPointer<vtkActor> makeActor();

/// Pulls an actor's lines and points in front of areas at the same place, and of lines of a lower rank.
void drawInFront(vtkActor* actor, int rank = 1);

}  // namespace planewright
