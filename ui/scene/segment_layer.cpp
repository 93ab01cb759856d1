// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/segment_layer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vtkProperty.h>

#include <Eigen/Eigenvalues>

namespace planewright {

namespace {

constexpr double kDash = 0.06;        // of unfitted segments [m]
constexpr double kMostDashes = 64.0;  // of one segment
constexpr double kFreshWidth = 2.0;   // times that of other segments
constexpr double kSigmas = 2.0;       // that an ellipsoid shows

void addDashes(SceneGeometry& geometry, const LineSegment& segment, Rgb colour)
{
    const double dashes = std::clamp(std::floor(segment.length() / (2.0 * kDash)), 1.0, kMostDashes);
    const Eigen::Vector3d along = segment.end - segment.start;
    for (double i = 0.0; i < dashes; i += 1.0)
        geometry.addLine(segment.start + (i + 0.2) / dashes * along, segment.start + (i + 0.8) / dashes * along,
                         colour);
}

/// The surface of kSigmas standard deviations around a point.
void addEllipsoid(SceneGeometry& geometry, const Eigen::Vector3d& centre, const Eigen::Matrix3d& covariance, Rgb colour,
                  double opacity)
{
    constexpr int kAround = 16;
    constexpr int kUp = 8;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
    const Eigen::Matrix3d shape = axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
    const auto at = [&](int around, int up) -> Eigen::Vector3d {
        const double longitude = 2.0 * std::numbers::pi * around / kAround;
        const double latitude = std::numbers::pi * (static_cast<double>(up) / kUp - 0.5);
        return centre +
               kSigmas * (shape * Eigen::Vector3d{std::cos(latitude) * std::cos(longitude),
                                                  std::cos(latitude) * std::sin(longitude), std::sin(latitude)});
    };
    for (int around = 0; around < kAround; ++around) {
        for (int up = 0; up < kUp; ++up) {
            geometry.addTriangle(at(around, up), at(around + 1, up), at(around + 1, up + 1), colour, opacity);
            geometry.addTriangle(at(around, up), at(around + 1, up + 1), at(around, up + 1), colour, opacity);
        }
    }
}

void style(vtkActor* actor, bool visible, double width, double opacity)
{
    actor->SetVisibility(visible);
    actor->GetProperty()->SetLineWidth(static_cast<float>(width));
    actor->GetProperty()->SetOpacity(opacity);
}

}  // namespace

SegmentLayer::SegmentLayer(vtkRenderer* renderer)
{
    for (auto* actor : {&unfitted_, &clustered_, &fitted_, &fresh_, &selected_, &selectedInner_, &ellipsoids_}) {
        *actor = makeActor();
        drawInFront(*actor);
        renderer->AddActor(*actor);
    }
    drawInFront(selected_, 2);
    drawInFront(selectedInner_, 3);
    ellipsoids_->ForceTranslucentOn();
}

void SegmentLayer::update(const ShownMap& map, const SegmentOwners& owners, const Colouring& colouring,
                          const LayerSettings& settings, Theme theme, const std::set<SegmentId>& selected,
                          double pixelRatio)
{
    SceneGeometry fitted;
    SceneGeometry clustered;
    SceneGeometry unfitted;
    SceneGeometry fresh;
    SceneGeometry outer;
    SceneGeometry inner;
    SceneGeometry ellipsoids(true);
    const ThemeColours& colours = themeColours(theme);
    for (std::size_t slice = 0; slice < owners.slices(); ++slice) {
        for (const LineSegment& segment : map.snapshot->segments.slice(slice)) {
            const auto index = static_cast<std::size_t>(segment.id.index);
            const int plane = owners.planeAt(slice, index);
            const ClusterId cluster = owners.clusterAt(slice, index);
            if (plane >= 0 && map.planes[static_cast<std::size_t>(plane)].hidden)
                continue;
            const Rgb colour = colouring.of(plane, cluster, segment.id.step, segment.midpoint().z());
            if (plane >= 0)
                fitted.addLine(segment.start, segment.end, colour);
            else if (settings[Layer::Unfitted].visible)
                addDashes(unfitted, segment, settings.colourBy == ColourBy::Uniform ? colours.unfitted : colour);
            if (cluster != kNoCluster)
                clustered.addLine(segment.start, segment.end, planeColour(cluster, settings.palette, theme));
            if (segment.id.step == map.step && !map.finished)
                fresh.addLine(segment.start, segment.end, colour);
            if (selected.contains(segment.id)) {
                outer.addLine(segment.start, segment.end, colours.selection);
                inner.addLine(segment.start, segment.end, colours.selectionInner);
                const double opacity = settings[Layer::Uncertainty].opacity;
                addEllipsoid(ellipsoids, segment.start, segment.startCovariance, colours.sensor, opacity);
                addEllipsoid(ellipsoids, segment.end, segment.endCovariance, colours.sensor, opacity);
            }
        }
    }
    fitted.give(fitted_);
    clustered.give(clustered_);
    unfitted.give(unfitted_);
    fresh.give(fresh_);
    outer.give(selected_);
    inner.give(selectedInner_);
    ellipsoids.give(ellipsoids_);

    const LayerStyle& segments = settings[Layer::FittedSegments];
    const LayerStyle& leftOver = settings[Layer::Unfitted];
    const LayerStyle& clusters = settings[Layer::Clusters];
    style(fitted_, segments.visible, segments.size * pixelRatio, segments.opacity);
    style(fresh_, segments.visible, kFreshWidth * segments.size * pixelRatio, 1.0);
    style(unfitted_, leftOver.visible, leftOver.size * pixelRatio, leftOver.opacity);
    style(clustered_, clusters.visible, clusters.size * pixelRatio, clusters.opacity);
    style(selected_, true, 6.0 * pixelRatio, 1.0);
    style(selectedInner_, true, 2.0 * pixelRatio, 1.0);
    ellipsoids_->SetVisibility(settings[Layer::Uncertainty].visible);
}

}  // namespace planewright
