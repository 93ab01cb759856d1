// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/floor_plan_svg.h"

#include <ostream>
#include <string>

#include "core/formats/floor_plan_sketch.h"
#include "core/formats/number_text.h"
#include "core/formats/svg_drawing.h"
#include "core/formats/written.h"

namespace planewright {

namespace {

constexpr std::string_view kPlanStyles =
    "svg{background:#fff}"
    "path{fill:none;stroke:#000;stroke-width:1;stroke-linecap:round}"
    ".wall{stroke-width:2}.other{stroke:#555}.grid{stroke:#ddd;stroke-width:.5}"
    ".stop{fill:#c22;stroke:none}"
    "text{font:12px sans-serif;fill:#000}.number{font-size:9px;fill:#c22}";

}  // namespace

Result<void> writeFloorPlanSvg(std::ostream& out, std::span<const PlaneResult> planes, double height,
                               double denominator, std::span<const PlanStop> stops)
{
    const FloorPlanSketch sketch = floorPlanSketch(planes, height, stops);
    SvgDrawing drawing = SvgDrawing::atScale(sketch.lowest, sketch.highest, denominator);
    drawing.grid();
    for (const FloorPlanSketch::Line& line : sketch.lines)
        drawing.line(line.isWall ? "wall cut" : "other cut", line.from, line.to);
    constexpr double kDot = 2.5;  // [px]
    const Eigen::Vector2d aside{0.0, 9.0 / drawing.pixelsPerMetre()};
    for (const PlanStop& stop : sketch.stops) {
        drawing.dot("stop", stop.place, kDot);
        drawing.label("number", stop.place + aside, std::to_string(stop.number));
    }
    out << std::move(drawing).take("Plan 1:" + formatNumber(denominator), kPlanStyles);
    return written(out);
}

}  // namespace planewright
