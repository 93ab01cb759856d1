// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <utility>

#include "tests/core/segments/drawn_slice.h"
#include "ui/common/slice_sketch.h"

namespace planewright {

/// A corner of a room with a pillar before its back wall and beams that go out of a door, at step 62: segments,
/// discarded pieces, breakpoints and split points.
inline std::shared_ptr<SliceSketch> madeSketch(Theme theme = Theme::Light)
{
    ScanSlice slice = drawn(emptySlice(0.0, degrees(0.5), 361), {{{2.0, -1.0}, {2.0, 3.0}},
                                                                 {{2.0, 3.0}, {-1.0, 3.0}},
                                                                 {{-2.0, 3.0}, {-3.0, 2.0}},
                                                                 {{-3.0, 2.0}, {-3.0, -1.0}},
                                                                 {{0.35, 1.6}, {0.18, 1.6}}});
    slice.step = 62;
    slice.tilt = degrees(81.9);
    Parameters parameters;
    parameters.noise = kFineNoise;
    auto sketch = std::make_shared<SliceSketch>();
    sketch->sensor = {0.05, 0.1, 30.0};
    sketch->trace = traceSlice(slice, sketch->sensor, parameters);
    sketch->slice = std::make_shared<ScanSlice>(std::move(slice));
    for (const TracedPiece& piece : sketch->trace.pieces) {
        sketch->colours.push_back(piece.segment >= 0 ? planeColour(piece.segment, PlanePalette::Normal, theme)
                                                     : themeColours(theme).unfitted);
        sketch->owners.push_back(piece.segment == 0 ? "P03" : std::string{});
    }
    return sketch;
}

}  // namespace planewright
