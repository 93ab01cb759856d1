// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/map_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkPlaneCollection.h>

namespace planewright {

namespace {

/// Of a map of several stops: of its planes, its stops and where odometry has them.
Eigen::AlignedBox3d boundsOfBuilding(const ShownMap& map)
{
    Eigen::AlignedBox3d bounds;
    for (const ShownPlane& plane : map.planes) {
        for (const Outline::Polygon& part : plane.outline->outline.parts) {
            for (const Eigen::Vector3d& corner : part.ring)
                bounds.extend(corner);
        }
    }
    for (const ShownStop& stop : map.building->stops) {
        if (stop.isPlaced)
            bounds.extend(stop.pose.translation);
        if (stop.raw)
            bounds.extend(stop.raw->translation);
    }
    return bounds;
}

/// Of the segments, and not of the points.
Eigen::AlignedBox3d boundsOf(const ShownMap& map)
{
    Eigen::AlignedBox3d bounds;
    if (map.building)
        return boundsOfBuilding(map);
    if (!map.snapshot)
        return bounds;
    const SegmentLog& log = map.snapshot->segments;
    for (std::size_t slice = 0; slice < log.slices(); ++slice) {
        for (const LineSegment& segment : log.slice(slice)) {
            bounds.extend(segment.start);
            bounds.extend(segment.end);
        }
    }
    return bounds;
}

constexpr double kLeftOut = 0.01;  // of the segments' ends, at either end of an axis

/// As MapScene::framing().
Eigen::AlignedBox3d framingOf(const ShownMap& map)
{
    Eigen::AlignedBox3d framing;
    if (map.building)
        return boundsOfBuilding(map);
    if (!map.snapshot)
        return framing;
    const SegmentLog& log = map.snapshot->segments;
    std::array<std::vector<double>, 3> ends;
    for (std::size_t slice = 0; slice < log.slices(); ++slice) {
        for (const LineSegment& segment : log.slice(slice)) {
            for (int axis = 0; axis < 3; ++axis) {
                ends[static_cast<std::size_t>(axis)].push_back(segment.start[axis]);
                ends[static_cast<std::size_t>(axis)].push_back(segment.end[axis]);
            }
        }
    }
    if (ends[0].empty())
        return framing;
    const auto left = static_cast<std::ptrdiff_t>(kLeftOut * static_cast<double>(ends[0].size()));
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double>& along = ends[static_cast<std::size_t>(axis)];
        std::nth_element(along.begin(), along.begin() + left, along.end());
        framing.min()[axis] = along[static_cast<std::size_t>(left)];
        std::nth_element(along.begin(), along.end() - 1 - left, along.end());
        framing.max()[axis] = *(along.end() - 1 - left);
    }
    for (const ShownPlane& plane : map.planes) {
        if (plane.hidden || !plane.outline)
            continue;
        for (const Outline::Polygon& part : plane.outline->outline.parts) {
            for (const Eigen::Vector3d& corner : part.ring)
                framing.extend(corner);
        }
    }
    return framing;
}

}  // namespace

MapScene::MapScene()
    : points_(renderer_), segments_(renderer_), marks_(renderer_), trajectory_(renderer_), planes_(renderer_)
{
    renderer_->GradientBackgroundOn();
    renderer_->SetTwoSidedLighting(false);
    renderer_->SetLightFollowCamera(false);
    renderer_->AutomaticLightCreationOff();
}

void MapScene::setMap(std::shared_ptr<const ShownMap> map)
{
    map_ = map ? std::move(map) : std::make_shared<const ShownMap>();
    owners_ = SegmentOwners(*map_);
    bounds_ = boundsOf(*map_);
    framing_ = framingOf(*map_);
    if (map_->building || layers_.colourBy == ColourBy::Height || layers_.colourBy == ColourBy::Class)
        ++coloursVersion_;
    changed_ = true;
}

void MapScene::setLayers(const LayerSettings& settings)
{
    if (settings.colourBy != layers_.colourBy || settings.palette != layers_.palette ||
        settings.mapColourBy != layers_.mapColourBy)
        ++coloursVersion_;
    layers_ = settings;
    changed_ = true;
}

void MapScene::setTheme(Theme theme)
{
    theme_ = theme;
    ++coloursVersion_;
    changed_ = true;
}

void MapScene::setSelection(const SceneSelection& selection)
{
    changed_ = changed_ || !(selection == selection_);
    selection_ = selection;
}

void MapScene::setMeasurements(const std::vector<MeasuredLine>& lines)
{
    measured_ = lines;
    changed_ = true;
}

void MapScene::setClipBox(const std::optional<Eigen::AlignedBox3d>& box)
{
    clipBox_ = box;
    changed_ = true;
}

void MapScene::setPixelRatio(double ratio)
{
    changed_ = changed_ || ratio != pixelRatio_;
    pixelRatio_ = ratio;
}

void MapScene::setCamera(const ViewCamera& camera)
{
    camera_ = camera;
}

void MapScene::update()
{
    if (changed_) {
        const Colouring colouring(*map_, layers_, theme_);
        LayerSettings scaled = layers_;
        scaled[Layer::Points].size *= pixelRatio_;
        points_.update(*map_, owners_, colouring, scaled, coloursVersion_);
        segments_.update(*map_, owners_, colouring, layers_, theme_, selection_.segments, pixelRatio_);
        planes_.update(*map_, colouring, layers_, theme_, selection_.planes, selection_.hovered, pixelRatio_);
        marks_.update(*map_, bounds_, layers_, theme_, measured_, selection_.pieces, pixelRatio_);
        trajectory_.update(map_->building.get(), theme_, pixelRatio_);
        clip();
        const ThemeColours& colours = themeColours(theme_);
        const auto share = [](std::uint8_t channel) { return channel / 255.0; };
        renderer_->SetBackground(share(colours.background.red), share(colours.background.green),
                                 share(colours.background.blue));
        renderer_->SetBackground2(share(colours.backgroundTop.red), share(colours.backgroundTop.green),
                                  share(colours.backgroundTop.blue));
        changed_ = false;
    }
    planes_.sortFor(camera_.eye(), camera_.forward(), camera_.parallel);
    apply(camera_, bounds_, renderer_->GetActiveCamera());
}

void MapScene::clip()
{
    vtkNew<vtkPlaneCollection> planes;
    if (clipBox_) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const double side : {1.0, -1.0}) {
                const Eigen::Vector3d origin = side > 0.0 ? clipBox_->min() : clipBox_->max();
                std::array<double, 3> normal{};
                normal[static_cast<std::size_t>(axis)] = side;
                vtkNew<vtkPlane> plane;
                plane->SetOrigin(origin.x(), origin.y(), origin.z());
                plane->SetNormal(normal.data());
                planes->AddItem(plane);
            }
        }
    }
    vtkActorCollection* actors = renderer_->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
        actor->GetMapper()->SetClippingPlanes(clipBox_ ? planes.Get() : nullptr);
}

std::vector<SceneLabel> MapScene::labels() const
{
    std::vector<SceneLabel> labels;
    if (!layers_.labels || !layers_[Layer::Planes].visible)
        return labels;
    if (map_->building) {
        for (const ShownStop& stop : map_->building->stops) {
            if (stop.isPlaced)
                labels.push_back({stop.pose.translation, std::to_string(stop.number), correctedWayColour(theme_)});
        }
    }
    const Colouring colouring(*map_, layers_, theme_);
    const auto seen = [&](const Plane& plane, const Outline& outline) {
        if (camera_.parallel)
            return outline.area * std::abs(plane.normal.dot(camera_.forward()));
        const Eigen::Vector3d sight = outline.centroid - camera_.eye();
        return outline.area * std::abs(plane.normal.dot(sight)) / std::max(std::pow(sight.norm(), 3), 1e-9);
    };
    for (std::size_t i = 0; i < map_->planes.size(); ++i) {
        const ShownPlane& plane = map_->planes[i];
        if (plane.hidden || !plane.outline || plane.outline->outline.parts.empty() ||
            (map_->building && !selection_.planes.contains(plane.plane->id)))
            continue;
        std::array<char, 16> number{};
        std::snprintf(number.data(), number.size(), "P%02d", plane.plane->id);
        std::string text = number.data();
        if (!plane.name.empty())
            text += " " + plane.name;
        else if (!plane.className.empty())
            text += " " + plane.className;
        labels.push_back({plane.outline->outline.centroid, std::move(text), colouring.ofPlane(static_cast<int>(i)),
                          selection_.planes.contains(plane.plane->id), seen(*plane.plane, plane.outline->outline)});
    }
    std::stable_sort(labels.begin(), labels.end(),
                     [](const SceneLabel& a, const SceneLabel& b) { return a.seen > b.seen; });
    return labels;
}

Eigen::AlignedBox3d MapScene::selectedBounds() const
{
    Eigen::AlignedBox3d box;
    const ShownMap& map = *map_;
    for (const ShownPlane& plane : map.planes) {
        if (!selection_.planes.contains(plane.plane->id) || !plane.outline)
            continue;
        for (const Outline::Polygon& part : plane.outline->outline.parts) {
            for (const Eigen::Vector3d& corner : part.ring)
                box.extend(corner);
        }
    }
    for (const SegmentId& id : selection_.segments) {
        const std::size_t slice = map.snapshot ? map.snapshot->segments.find(id.step) : 0;
        if (!map.snapshot || slice >= map.snapshot->segments.slices())
            continue;
        box.extend(map.snapshot->segments[id].start);
        box.extend(map.snapshot->segments[id].end);
    }
    for (const BeamRun& piece : selection_.pieces) {
        for (const Eigen::Vector3d& point : pointsOf(piece, map))
            box.extend(point);
    }
    return box;
}

std::vector<LegendEntry> MapScene::legend(std::size_t most) const
{
    return Colouring(*map_, layers_, theme_).legend(most);
}

}  // namespace planewright
