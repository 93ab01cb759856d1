// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/plane_layer.h"

#include <algorithm>
#include <utility>
#include <vtkProperty.h>

namespace planewright {

namespace {

constexpr double kSelectedOpacity = 0.55;

void addRing(SceneGeometry& geometry, const std::vector<Eigen::Vector3d>& ring, Rgb colour)
{
    for (std::size_t i = 0; i < ring.size(); ++i)
        geometry.addLine(ring[i], ring[(i + 1) % ring.size()], colour);
}

void addOutline(SceneGeometry& geometry, const Outline& outline, Rgb colour)
{
    for (const Outline::Polygon& part : outline.parts) {
        addRing(geometry, part.ring, colour);
        for (const auto& hole : part.holes)
            addRing(geometry, hole, colour);
    }
}

}  // namespace

PlaneLayer::PlaneLayer(vtkRenderer* renderer)
{
    for (auto* actor : {&outlines_, &selected_, &selectedInner_, &fill_}) {
        *actor = makeActor();
        renderer->AddActor(*actor);
    }
    drawInFront(outlines_, 1);
    drawInFront(selected_, 2);
    drawInFront(selectedInner_, 3);
    fill_->ForceTranslucentOn();
}

void PlaneLayer::update(const ShownMap& map, const Colouring& colouring, const LayerSettings& settings, Theme theme,
                        const std::set<PlaneId>& selected, PlaneId hovered, double pixelRatio)
{
    const LayerStyle& style = settings[Layer::Planes];
    const ThemeColours& colours = themeColours(theme);
    SceneGeometry outlines;
    SceneGeometry outer;
    SceneGeometry inner;
    areas_.clear();
    for (std::size_t i = 0; i < map.planes.size(); ++i) {
        const ShownPlane& plane = map.planes[i];
        if (plane.hidden || !plane.outline)
            continue;
        const bool marked = selected.contains(plane.plane->id);
        const Rgb colour = colouring.ofPlane(static_cast<int>(i));
        const double opacity = marked                       ? std::max(kSelectedOpacity, style.opacity)
                               : plane.plane->id == hovered ? std::min(1.0, style.opacity + 0.1)
                                                            : style.opacity;
        for (const Triangle& triangle : plane.outline->triangles)
            areas_.push_back({triangle, colour, opacity});
        addOutline(outlines, plane.outline->outline, colour);
        if (marked) {
            addOutline(outer, plane.outline->outline, colours.selection);
            addOutline(inner, plane.outline->outline, colours.selectionInner);
        }
    }
    outlines.give(outlines_);
    outer.give(selected_);
    inner.give(selectedInner_);
    for (const auto& actor : {outlines_, selected_, selectedInner_, fill_})
        actor->SetVisibility(style.visible);
    outlines_->GetProperty()->SetLineWidth(static_cast<float>(style.size * pixelRatio));
    selected_->GetProperty()->SetLineWidth(static_cast<float>((style.size + 4.0) * pixelRatio));
    selectedInner_->GetProperty()->SetLineWidth(static_cast<float>(style.size * pixelRatio));
}

void PlaneLayer::sortFor(const Eigen::Vector3d& eye, const Eigen::Vector3d& forward, bool parallel)
{
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(areas_.size());
    for (std::size_t i = 0; i < areas_.size(); ++i) {
        const Triangle& corners = areas_[i].corners;
        const Eigen::Vector3d offset = (corners[0] + corners[1] + corners[2]) / 3.0 - eye;
        order.emplace_back(parallel ? -forward.dot(offset) : -offset.squaredNorm(), i);
    }
    std::sort(order.begin(), order.end());
    SceneGeometry fill(true);
    for (const auto& [depth, i] : order)
        fill.addTriangle(areas_[i].corners[0], areas_[i].corners[1], areas_[i].corners[2], areas_[i].colour,
                         areas_[i].opacity);
    fill.give(fill_);
}

}  // namespace planewright
