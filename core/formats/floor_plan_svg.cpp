// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/floor_plan_svg.h"

#include <ostream>
#include <string>
#include <vector>

#include "core/formats/number_text.h"
#include "core/formats/room_drawings.h"
#include "core/formats/svg_drawing.h"
#include "core/formats/written.h"
#include "core/geometry/cut_outline.h"

namespace planewright {

namespace {

constexpr std::string_view kPlanStyles =
    "svg{background:#fff}"
    "path{fill:none;stroke:#000;stroke-width:1;stroke-linecap:round}"
    ".wall{stroke-width:2}.other{stroke:#555}.grid{stroke:#ddd;stroke-width:.5}"
    ".stop{fill:#c22;stroke:none}"
    "text{font:12px sans-serif;fill:#000}.number{font-size:9px;fill:#c22}";

struct CutLine {
    std::string style;
    Eigen::Vector2d from;
    Eigen::Vector2d to;
};

}  // namespace

Result<void> writeFloorPlanSvg(std::ostream& out, std::span<const PlaneResult> planes, double height,
                               double denominator, std::span<const Eigen::Vector2d> stops)
{
    const Eigen::Vector2d forward = squaredDirection(planes);
    const Eigen::Vector2d right{forward.y(), -forward.x()};
    const auto seen = [&](const Eigen::Vector2d& place) {
        return Eigen::Vector2d{right.dot(place), forward.dot(place)};
    };
    Eigen::Vector2d lowest = Eigen::Vector2d::Zero();
    Eigen::Vector2d highest = Eigen::Vector2d::Zero();
    const auto cover = [&](const Eigen::Vector2d& place) {
        lowest = lowest.cwiseMin(place);
        highest = highest.cwiseMax(place);
        return place;
    };
    std::vector<CutLine> lines;
    for (const PlaneResult& plane : planes) {
        const std::string style = plane.className == "wall" ? "wall cut" : "other cut";
        for (const PlanLine& line : cutAtHeight(plane.outline, plane.plane->normal, height))
            lines.push_back({style, cover(seen(line.from)), cover(seen(line.to))});
    }
    std::vector<Eigen::Vector2d> places;
    for (const Eigen::Vector2d& stop : stops)
        places.push_back(cover(seen(stop)));

    SvgDrawing drawing = SvgDrawing::atScale(lowest, highest, denominator);
    drawing.grid();
    for (const CutLine& line : lines)
        drawing.line(line.style, line.from, line.to);
    constexpr double kDot = 2.5;  // [px]
    const Eigen::Vector2d aside{0.0, 9.0 / drawing.pixelsPerMetre()};
    for (std::size_t i = 0; i < places.size(); ++i) {
        drawing.dot("stop", places[i], kDot);
        drawing.label("number", places[i] + aside, std::to_string(i));
    }
    out << std::move(drawing).take("Plan 1:" + formatNumber(denominator), kPlanStyles);
    return written(out);
}

}  // namespace planewright
