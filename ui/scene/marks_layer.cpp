// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/marks_layer.h"

#include <algorithm>
#include <cmath>
#include <vtkProperty.h>

namespace planewright {

namespace {

constexpr double kGridStep = 2.0;  // [m], as in Fig. 10
constexpr double kMostGridLines = 200.0;
constexpr double kSensorSize = 0.12;  // half a side [m]
constexpr double kFanOpacity = 0.13;
constexpr double kChosenPointSize = 7.0;  // [px]

SceneGeometry gridGeometry(const Eigen::AlignedBox3d& bounds, Rgb colour)
{
    SceneGeometry grid;
    double step = kGridStep;
    while (bounds.sizes().head<2>().maxCoeff() / step > kMostGridLines)
        step *= 10.0;
    const auto down = [step](double value) { return step * std::floor(value / step); };
    const auto up = [step](double value) { return step * std::ceil(value / step); };
    const Eigen::Vector2d low{down(bounds.min().x()), down(bounds.min().y())};
    const Eigen::Vector2d high{up(bounds.max().x()), up(bounds.max().y())};
    const double z = bounds.min().z();
    for (double x = low.x(); x < high.x() + step / 2.0; x += step)
        grid.addLine({x, low.y(), z}, {x, high.y(), z}, colour);
    for (double y = low.y(); y < high.y() + step / 2.0; y += step)
        grid.addLine({low.x(), y, z}, {high.x(), y, z}, colour);
    return grid;
}

/// A cube around the pitch axis with an arrow that looks forward.
SceneGeometry sensorGeometry(Rgb colour)
{
    SceneGeometry sensor;
    const auto corner = [](int i) {
        return Eigen::Vector3d{(i & 1) != 0 ? kSensorSize : -kSensorSize, (i & 2) != 0 ? kSensorSize : -kSensorSize,
                               (i & 4) != 0 ? kSensorSize : -kSensorSize};
    };
    for (int i = 0; i < 8; ++i) {
        for (const int bit : {1, 2, 4}) {
            if ((i & bit) == 0)
                sensor.addLine(corner(i), corner(i | bit), colour);
        }
    }
    const Eigen::Vector3d tip{0.0, 4.0 * kSensorSize, 0.0};
    sensor.addLine({0.0, kSensorSize, 0.0}, tip, colour);
    for (const double side : {-1.0, 1.0})
        sensor.addLine(tip, {side * 0.6 * kSensorSize, 3.0 * kSensorSize, 0.0}, colour);
    return sensor;
}

/// The area that a slice's beams have swept.
SceneGeometry fanGeometry(const ScanSlice& slice, const SensorModel& sensor, Rgb colour)
{
    constexpr std::size_t kMostTriangles = 360;
    SceneGeometry fan(true);
    const std::size_t stride = 1 + slice.ranges.size() / kMostTriangles;
    std::optional<Eigen::Vector3d> last;
    for (std::size_t beam = 0; beam < slice.ranges.size(); beam += stride) {
        const double range = slice.ranges[beam];
        if (!sensor.hasEcho(range)) {
            last.reset();
            continue;
        }
        const double tilt = slice.tiltAt(beam);
        const Eigen::Vector3d point = toCartesian(range, slice.bearing(beam), tilt, sensor);
        if (last)
            fan.addTriangle(toCartesian(0.0, slice.bearing(beam), tilt, sensor), *last, point, colour, kFanOpacity);
        last = point;
    }
    return fan;
}

/// The echoes of pieces.
SceneGeometry piecesGeometry(const ShownMap& map, const std::set<BeamRun>& pieces, Rgb colour)
{
    SceneGeometry points;
    for (const BeamRun& piece : pieces) {
        for (const Eigen::Vector3d& point : pointsOf(piece, map))
            points.addPoint(point, colour);
    }
    return points;
}

}  // namespace

std::vector<Eigen::Vector3d> pointsOf(const BeamRun& piece, const ShownMap& map)
{
    std::vector<Eigen::Vector3d> points;
    const auto at = std::lower_bound(map.slices.begin(), map.slices.end(), piece.step,
                                     [](const auto& slice, int step) { return slice->step < step; });
    if (at == map.slices.end() || (*at)->step != piece.step)
        return points;
    const ScanSlice& slice = **at;
    const auto end = std::min(slice.ranges.size(), static_cast<std::size_t>(std::max(piece.lastBeam + 1, 0)));
    for (auto beam = static_cast<std::size_t>(std::max(piece.firstBeam, 0)); beam < end; ++beam) {
        if (map.sensor.hasEcho(slice.ranges[beam]))
            points.push_back(toCartesian(slice.ranges[beam], slice.bearing(beam), slice.tiltAt(beam), map.sensor));
    }
    return points;
}

MarksLayer::MarksLayer(vtkRenderer* renderer)
{
    for (auto* actor : {&grid_, &sensor_, &measured_, &pieces_, &fan_}) {
        *actor = makeActor();
        renderer->AddActor(*actor);
    }
    drawInFront(measured_);
    drawInFront(pieces_);
    fan_->ForceTranslucentOn();
}

void MarksLayer::update(const ShownMap& map, const Eigen::AlignedBox3d& bounds, const LayerSettings& settings,
                        Theme theme, const std::vector<MeasuredLine>& measured, const std::set<BeamRun>& pieces,
                        double pixelRatio)
{
    const ThemeColours& colours = themeColours(theme);
    const LayerStyle& style = settings[Layer::Sensor];
    const Eigen::AlignedBox3d shown =
        bounds.isEmpty() ? Eigen::AlignedBox3d{Eigen::Vector3d{-4.0, -4.0, -1.0}, Eigen::Vector3d{4.0, 4.0, 1.0}}
                         : bounds;
    gridGeometry(shown, colours.grid).give(grid_);
    sensorGeometry(colours.sensor).give(sensor_);
    const bool fan = style.visible && !map.finished && !map.slices.empty();
    if (fan)
        fanGeometry(*map.slices.back(), map.sensor, colours.sensor).give(fan_);
    SceneGeometry lines;
    for (const MeasuredLine& line : measured)
        lines.addLine(line.from, line.to, colours.selection);
    lines.give(measured_);
    piecesGeometry(map, pieces, colours.selection).give(pieces_);

    grid_->SetVisibility(style.visible);
    sensor_->SetVisibility(style.visible && !map.building);
    fan_->SetVisibility(fan);
    grid_->GetProperty()->SetOpacity(style.opacity);
    grid_->GetProperty()->SetLineWidth(static_cast<float>(style.size * pixelRatio));
    sensor_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * style.size * pixelRatio));
    measured_->GetProperty()->SetLineWidth(static_cast<float>(2.0 * pixelRatio));
    pieces_->GetProperty()->SetPointSize(static_cast<float>(kChosenPointSize * pixelRatio));
}

}  // namespace planewright
