// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace planewright {

/// What the 3D view can show, each on its own.
enum class Layer { Points, Segments, Clusters, Planes, Unfitted, Uncertainty, Sensor };
inline constexpr std::size_t kLayers = 7;
inline constexpr std::array<std::string_view, kLayers> kLayerNames{
    "Points", "Segments", "Clusters", "Planes", "Unfitted", "Uncertainty", "Sensor and grid"};

/// What gives points, segments and planes their colour.
enum class ColourBy { Plane, Cluster, Step, Class, Height, Uniform };
inline constexpr std::array<std::string_view, 6> kColourByNames{"Plane", "Cluster", "Step",
                                                                "Class", "Height",  "One colour"};

/// How one layer is drawn.
struct LayerStyle {
    bool visible = true;
    double opacity = 1.0;                 ///< 0 unseen to 1 solid
    double size = 2.0;                    ///< of points and lines [px]; of uncertainty, how many σ
    ColourBy colourBy = ColourBy::Plane;  ///< where the layer has colours of its own to choose (hasColourBy)

    friend bool operator==(const LayerStyle&, const LayerStyle&) = default;
};

/// True for the layers whose colours can be chosen: unfitted segments, uncertainty and grid have one colour.
constexpr bool hasColourBy(Layer layer)
{
    return layer == Layer::Points || layer == Layer::Segments || layer == Layer::Clusters || layer == Layer::Planes;
}

/// How the 3D view draws its layers, as one value.
struct LayerSettings {
    std::array<LayerStyle, kLayers> styles{{
        {.opacity = 0.6},                    // Points
        {},                                  // Segments
        {.colourBy = ColourBy::Cluster},     // Clusters
        {.opacity = 0.35, .size = 1.5},      // Planes
        {.opacity = 0.8, .size = 1.0},       // Unfitted
        {.visible = false, .opacity = 0.5},  // Uncertainty
        {.opacity = 0.8, .size = 1.0},       // Sensor and grid
    }};

    LayerStyle& operator[](Layer layer) { return styles[static_cast<std::size_t>(layer)]; }
    const LayerStyle& operator[](Layer layer) const { return styles[static_cast<std::size_t>(layer)]; }

    friend bool operator==(const LayerSettings&, const LayerSettings&) = default;
};

}  // namespace planewright
