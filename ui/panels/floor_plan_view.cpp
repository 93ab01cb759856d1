// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/floor_plan_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>

#include "ui/models/number_text.h"

namespace planewright {

namespace {

constexpr double kPlanMargin = 24.0;  // [px]
constexpr double kPlanBar = 90.0;     // longest length of the bar [px]
constexpr int kMostGridLines = 40;

/// 1, 2 or 5 times a power of ten, not more than this.
double roundStep(double most)
{
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double times : {5.0, 2.0}) {
        if (times * power <= most)
            return times * power;
    }
    return power;
}

/// From metres to pixels of a widget.
struct PlanScale {
    QPointF origin;
    double pixels = 1.0;  ///< a metre

    QPointF operator()(const Eigen::Vector2d& place) const
    {
        return {origin.x() + pixels * place.x(), origin.y() - pixels * place.y()};
    }
};

PlanScale planScale(const FloorPlanSketch& sketch, const QRectF& room)
{
    const Eigen::Vector2d size = (sketch.highest - sketch.lowest).cwiseMax(1.0);
    const Eigen::Vector2d middle = 0.5 * (sketch.highest + sketch.lowest);
    PlanScale scale;
    scale.pixels = std::max(std::min(room.width() / size.x(), room.height() / size.y()), 0.1);
    scale.origin = {room.center().x() - scale.pixels * middle.x(), room.center().y() + scale.pixels * middle.y()};
    return scale;
}

void drawPlanGrid(QPainter& painter, const FloorPlanSketch& sketch, const PlanScale& scale, const QColor& colour)
{
    painter.setPen(QPen(colour, 1.0));
    const double extent = (sketch.highest - sketch.lowest).maxCoeff();
    const double step = std::max(1.0, 2.0 * roundStep(std::max(extent / kMostGridLines, 0.5)));
    const Eigen::Vector2d from = (sketch.lowest / step).array().floor() * step;
    const Eigen::Vector2d to = (sketch.highest / step).array().ceil() * step;
    for (double x = from.x(); x <= to.x() + 1e-9; x += step)
        painter.drawLine(scale({x, from.y()}), scale({x, to.y()}));
    for (double y = from.y(); y <= to.y() + 1e-9; y += step)
        painter.drawLine(scale({from.x(), y}), scale({to.x(), y}));
}

void drawPlanBar(QPainter& painter, const PlanScale& scale, const QRectF& widget, const QColor& colour)
{
    const double length = roundStep(kPlanBar / scale.pixels);
    const QPointF left(widget.left() + 8.0, widget.bottom() - 8.0);
    const QPointF right = left + QPointF(scale.pixels * length, 0.0);
    painter.setPen(QPen(colour, 2.0));
    painter.drawLine(left, right);
    painter.drawText(right + QPointF(6.0, 4.0), QStringLiteral("%1 m").arg(length));
}

}  // namespace

FloorPlanView::FloorPlanView(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("floorPlanView"));
    setAccessibleName(tr("Floor plan"));
    setMinimumSize(160, 120);
}

void FloorPlanView::setSketch(FloorPlanSketch sketch)
{
    sketch_ = std::move(sketch);
    setAccessibleDescription(
        tr("%1, %2 from above")
            .arg(countText(static_cast<qsizetype>(sketch_.lines.size()), tr("line"), tr("lines")),
                 countText(static_cast<qsizetype>(sketch_.stops.size()), tr("stop"), tr("stops"))));
    update();
}

void FloorPlanView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    const QColor text = palette().text().color();
    if (sketch_.lines.empty()) {
        painter.setPen(text);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Nothing stands at this height; choose another one."));
        return;
    }
    const bool isDark = palette().base().color().lightness() < 128;
    const PlanScale scale =
        planScale(sketch_, QRectF(rect()).adjusted(kPlanMargin, kPlanMargin, -kPlanMargin, -kPlanMargin));
    drawPlanGrid(painter, sketch_, scale, isDark ? QColor(0x45, 0x45, 0x48) : QColor(0xdd, 0xdd, 0xdd));
    QColor faint = text;
    faint.setAlphaF(0.65F);
    for (const FloorPlanSketch::Line& line : sketch_.lines) {
        painter.setPen(QPen(line.isWall ? text : faint, line.isWall ? 2.0 : 1.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(scale(line.from), scale(line.to));
    }
    const QColor mark = isDark ? QColor(0xff, 0x6b, 0x5e) : QColor(0xc0, 0x20, 0x20);
    for (const PlanStop& stop : sketch_.stops) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(mark);
        painter.drawEllipse(scale(stop.place), 3.0, 3.0);
        painter.setPen(mark);
        painter.drawText(scale(stop.place) + QPointF(4.0, -4.0), QString::number(stop.number));
    }
    drawPlanBar(painter, scale, rect(), text);
}

}  // namespace planewright
