// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "ui/common/layer_settings.h"
#include "ui/common/palette.h"
#include "ui/common/shown_map.h"

namespace planewright {

/// The colour at a place of 0 to 1 on a scale from dark blue over green to yellow, even in lightness.
Rgb scaleColour(double place);

/// The colour of a plane's class.
Rgb classColour(const std::string& className, Theme theme);

/// A line of the legend: a colour and what it stands for.
struct LegendEntry {
    Rgb colour;
    std::string text;
};

/// Gives points and segments their colours.
class Colouring {
public:
    Colouring(const ShownMap& map, const LayerSettings& settings, Theme theme);

    /// The colour of a plane at its place among the map's planes.
    Rgb ofPlane(int place) const { return planes_[static_cast<std::size_t>(place)]; }

    /// The colour of a segment or of one of its points: `plane` is a place among the map's planes or −1, `height` [m].
    Rgb of(int plane, ClusterId cluster, int step, double height) const;

    /// What the legend says; at most this many lines, the last of which then counts the rest.
    std::vector<LegendEntry> legend(std::size_t most) const;

private:
    void colourBuilding();
    std::vector<LegendEntry> legendOfBuilding() const;

    const ShownMap* map_;
    ColourBy by_;
    MapColourBy mapBy_;
    PlanePalette palette_;
    Theme theme_;
    std::vector<Rgb> planes_;
    double lowest_ = 0.0;  // of what the scale runs over
    double highest_ = 1.0;
};

}  // namespace planewright
