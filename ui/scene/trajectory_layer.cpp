// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/trajectory_layer.h"

#include <map>
#include <vtkProperty.h>

namespace planewright {

namespace {

constexpr double kWayWidth = 3.0;       // [px]
constexpr double kRawWayWidth = 2.0;    // [px]
constexpr double kStopPointSize = 9.0;  // [px]

/// Adds the way through a floor's stops as far as `poseOf` knows them.
template <class PoseOf>
void addWay(SceneGeometry& geometry, const ShownBuilding& building, Rgb colour, bool withDots, PoseOf poseOf)
{
    std::map<int, Eigen::Vector3d> last;  // by floor
    for (const ShownStop& stop : building.stops) {
        const std::optional<Pose> pose = stop.isOmitted() ? std::nullopt : poseOf(stop);
        if (!pose)
            continue;
        if (const auto before = last.find(stop.floor); before != last.end())
            geometry.addLine(before->second, pose->translation, colour);
        last[stop.floor] = pose->translation;
        if (withDots)
            geometry.addPoint(pose->translation, colour);
    }
}

}  // namespace

Rgb correctedWayColour(Theme theme)
{
    return theme == Theme::Light ? Rgb{0xc0, 0x20, 0x20} : Rgb{0xff, 0x6b, 0x5e};
}

Rgb rawWayColour(Theme theme)
{
    return themeColours(theme).text;
}

TrajectoryLayer::TrajectoryLayer(vtkRenderer* renderer)
{
    for (auto* actor : {&raw_, &corrected_}) {
        *actor = makeActor();
        renderer->AddActor(*actor);
        drawInFront(*actor, 2);
        (*actor)->SetVisibility(false);
    }
}

void TrajectoryLayer::update(const ShownBuilding* building, Theme theme, double pixelRatio)
{
    for (const auto& actor : {raw_, corrected_})
        actor->SetVisibility(building != nullptr);
    if (building == nullptr)
        return;
    SceneGeometry raw;
    addWay(raw, *building, rawWayColour(theme), false, [](const ShownStop& stop) { return stop.raw; });
    raw.give(raw_);
    SceneGeometry corrected;
    addWay(corrected, *building, correctedWayColour(theme), true,
           [](const ShownStop& stop) { return stop.isPlaced ? std::optional(stop.pose) : std::nullopt; });
    corrected.give(corrected_);
    raw_->GetProperty()->SetLineWidth(static_cast<float>(kRawWayWidth * pixelRatio));
    corrected_->GetProperty()->SetLineWidth(static_cast<float>(kWayWidth * pixelRatio));
    corrected_->GetProperty()->SetPointSize(static_cast<float>(kStopPointSize * pixelRatio));
}

}  // namespace planewright
