// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "ui/common/palette.h"

namespace planewright {

/// What the 3D view is made of; each layer can be shown or not.
enum class Layer { Points, FittedSegments, Clusters, Planes, Unfitted, Uncertainty, Sensor };
inline constexpr std::size_t kLayers = 7;
inline constexpr std::array<std::string_view, kLayers> kLayerNames{
    "Points", "Segments", "Clusters", "Planes", "Unfitted segments", "Uncertainty", "Sensor and grid"};

/// What the colours of points and segments tell.
enum class ColourBy { Plane, Cluster, Step, Class, Height, Uniform };
inline constexpr std::size_t kColourings = 6;
inline constexpr std::array<std::string_view, kColourings> kColourByNames{"plane", "cluster", "step",
                                                                          "class", "height",  "one colour"};

/// What the colours of planes tell in a map of several stops.
enum class MapColourBy { Stop, Floor, Class, Uncertainty };
inline constexpr std::size_t kMapColourings = 4;
inline constexpr std::array<std::string_view, kMapColourings> kMapColourByNames{"stop", "floor", "class",
                                                                                "uncertainty"};

/// How a layer is drawn.
struct LayerStyle {
    bool visible = true;
    double opacity = 1.0;  ///< 0 to 1
    double size = 1.0;     ///< of points and lines [px at 96 dpi]

    friend bool operator==(const LayerStyle&, const LayerStyle&) = default;
};

/// How the whole scene is drawn.
struct LayerSettings {
    std::array<LayerStyle, kLayers> styles{{{true, 1.0, 2.0},
                                            {true, 1.0, 2.0},
                                            {true, 0.9, 3.0},
                                            {true, 0.35, 2.0},
                                            {true, 1.0, 2.0},
                                            {false, 0.6, 1.0},
                                            {true, 1.0, 1.0}}};
    ColourBy colourBy = ColourBy::Plane;
    PlanePalette palette = PlanePalette::Normal;
    bool labels = true;  ///< names on planes
    MapColourBy mapColourBy = MapColourBy::Stop;

    LayerStyle& operator[](Layer layer) { return styles[static_cast<std::size_t>(layer)]; }
    const LayerStyle& operator[](Layer layer) const { return styles[static_cast<std::size_t>(layer)]; }
    friend bool operator==(const LayerSettings&, const LayerSettings&) = default;
};

}  // namespace planewright
