// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/scene_geometry.h"

#include <algorithm>
#include <cmath>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace planewright {

SceneGeometry::SceneGeometry(bool translucent) : translucent_(translucent)
{
    coordinates_->SetNumberOfComponents(3);
    colours_->SetNumberOfComponents(translucent ? 4 : 3);
}

vtkIdType SceneGeometry::addVertex(const Eigen::Vector3d& point, Rgb colour, double opacity)
{
    coordinates_->InsertNextTuple3(point.x(), point.y(), point.z());
    if (translucent_)
        colours_->InsertNextTuple4(colour.red, colour.green, colour.blue,
                                   std::round(255.0 * std::clamp(opacity, 0.0, 1.0)));
    else
        colours_->InsertNextTuple3(colour.red, colour.green, colour.blue);
    return colours_->GetNumberOfTuples() - 1;
}

void SceneGeometry::addPoint(const Eigen::Vector3d& point, Rgb colour)
{
    const vtkIdType id = addVertex(point, colour, 1.0);
    verts_->InsertNextCell(1, &id);
}

void SceneGeometry::addLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Rgb colour)
{
    const vtkIdType ids[]{addVertex(from, colour, 1.0), addVertex(to, colour, 1.0)};
    lines_->InsertNextCell(2, ids);
}

void SceneGeometry::addTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                Rgb colour, double opacity)
{
    const vtkIdType ids[]{addVertex(a, colour, opacity), addVertex(b, colour, opacity), addVertex(c, colour, opacity)};
    triangles_->InsertNextCell(3, ids);
}

void SceneGeometry::give(vtkActor* actor) const
{
    vtkNew<vtkPoints> points;
    points->SetData(coordinates_);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->GetPointData()->SetScalars(colours_);
    data->SetVerts(verts_);
    data->SetLines(lines_);
    data->SetPolys(triangles_);
    static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(data);
}

vtkSmartPointer<vtkActor> makeActor()
{
    auto actor = vtkSmartPointer<vtkActor>::New();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(vtkSmartPointer<vtkPolyData>::New());
    mapper->SetStatic(true);
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    return actor;
}

void drawInFront(vtkActor* actor, int rank)
{
    const double units = -4.0 * rank;
    auto* mapper = actor->GetMapper();
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, units);
    mapper->SetRelativeCoincidentTopologyPointOffsetParameter(units);
}

}  // namespace planewright
