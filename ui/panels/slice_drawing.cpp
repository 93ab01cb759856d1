// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// What SliceView paints.

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "core/types/angle.h"
#include "ui/models/number_text.h"
#include "ui/panels/slice_view.h"
#include "ui/theme/theme.h"

namespace planewright {

namespace {

constexpr double kPixelsOfRing = 45.0;  // at least, from ring to ring
constexpr double kSpokeStep = 30.0;     // [°]

QColor drawnColour(Rgb rgb)
{
    return {rgb.red, rgb.green, rgb.blue};
}

/// A round number of metres of which one is at least so long [m].
double ringStep(double least)
{
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * decade >= least)
            return digit * decade;
    }
    return 10.0 * decade;
}

}  // namespace

/// Rings of range and lines of bearing, as far as they are seen.
void SliceView::paintGrid(QPainter& painter) const
{
    const ThemeColours& colours = themeColours(themeOf(palette()));
    const QPointF sensor = pixelOf({0.0, 0.0});
    double farthest = 0.0;
    for (const QPoint& corner : {rect().topLeft(), rect().topRight(), rect().bottomLeft(), rect().bottomRight()})
        farthest = std::max(farthest, pointOf(corner).norm());
    const Eigen::Vector2d low = pointOf(rect().bottomLeft());
    const Eigen::Vector2d high = pointOf(rect().topRight());
    const double nearest = Eigen::Vector2d::Zero().cwiseMax(low).cwiseMin(high).norm();
    const double step = ringStep(kPixelsOfRing / scale_);
    const double firstRing = std::max(1.0, std::ceil(nearest / step)) * step;
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    const QFontMetricsF metrics(font());
    const QColor grid = drawnColour(colours.grid);
    const QColor text = palette().color(QPalette::PlaceholderText);

    painter.setBrush(Qt::NoBrush);
    for (double range = firstRing; range <= farthest; range += step) {
        painter.setPen(QPen(grid, 1.0));
        painter.drawEllipse(sensor, range * scale_, range * scale_);
    }
    for (double bearing = 0.0; bearing < 360.0; bearing += kSpokeStep) {
        const Eigen::Vector2d ray{std::cos(degrees(bearing)), std::sin(degrees(bearing))};
        painter.setPen(QPen(grid, 1.0));
        painter.drawLine(sensor, pixelOf(farthest * ray));
        // Its name stands where it leaves the picture.
        const QRectF inside = QRectF(rect()).adjusted(14.0, 8.0, -14.0, -8.0);
        double seen = 0.0;
        for (double range = farthest; range > 0.0; range -= 0.02 * farthest) {
            if (inside.contains(pixelOf(range * ray))) {
                seen = range;
                break;
            }
        }
        if (seen * scale_ < 30.0)
            continue;
        const QString name = QStringLiteral("%1°").arg(bearing);
        const QPointF place = pixelOf(seen * ray);
        painter.setPen(text);
        painter.drawText(QRectF(place.x() - 24.0, place.y() - 9.0, 48.0, 18.0), Qt::AlignCenter, name);
    }
    painter.setPen(text);
    for (double range = firstRing; range <= farthest; range += step) {
        const QPointF place = pixelOf({range, 0.0});
        const QString name = tr("%1 m").arg(numberText(range, decimals));
        painter.drawText(QPointF(place.x() - 0.5 * metrics.horizontalAdvance(name), place.y() + metrics.ascent() + 1.0),
                         name);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(drawnColour(colours.sensor));
    painter.drawEllipse(sensor, 4.0, 4.0);
}

void SliceView::paintPieces(QPainter& painter) const
{
    const SliceSketch& sketch = *model_.sketch();
    const ThemeColours& colours = themeColours(themeOf(palette()));
    for (std::size_t i = 0; i < sketch.trace.pieces.size(); ++i) {
        const TracedPiece& piece = sketch.trace.pieces[i];
        const QColor colour = drawnColour(piece.segment >= 0 ? sketch.colours[i] : colours.unfitted);
        const QLineF line(pixelOf(sketch.pointAt(piece.firstBeam)), pixelOf(sketch.pointAt(piece.lastBeam)));
        if (piece.segment >= 0 && selected_.contains(sketch.idOf(piece))) {
            painter.setPen(QPen(drawnColour(colours.selection), 9.0, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(line);
            painter.setPen(QPen(drawnColour(colours.selectionInner), 6.0, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(line);
        }
        painter.setPen(QPen(colour, piece.segment >= 0 ? 2.5 : 1.5, piece.segment >= 0 ? Qt::SolidLine : Qt::DashLine,
                            Qt::FlatCap));
        painter.drawLine(line);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        for (int beam = piece.firstBeam; beam <= piece.lastBeam; ++beam) {
            if (sketch.hasEcho(beam))
                painter.drawEllipse(pixelOf(sketch.pointAt(beam)), 1.6, 1.6);
        }
        if (piece.segment >= 0)
            continue;
        const QPointF middle = line.center();
        painter.setPen(QPen(palette().color(QPalette::Text), 1.6));
        painter.drawLine(middle + QPointF(-3.5, -3.5), middle + QPointF(3.5, 3.5));
        painter.drawLine(middle + QPointF(-3.5, 3.5), middle + QPointF(3.5, -3.5));
    }
}

void SliceView::paintMarks(QPainter& painter) const
{
    const SliceSketch& sketch = *model_.sketch();
    const QColor text = palette().color(QPalette::Text);
    const QColor base = palette().color(QPalette::Base);
    for (const TracedBreak& gap : sketch.trace.breaks) {
        const QPointF before = pixelOf(sketch.pointAt(gap.before));
        const QPointF after = pixelOf(sketch.pointAt(gap.after));
        painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1.0, Qt::DotLine));
        painter.drawLine(before, after);
        painter.setPen(QPen(text, 1.3));
        painter.setBrush(base);
        for (const QPointF& end : {before, after})
            painter.drawRect(QRectF(end.x() - 2.5, end.y() - 2.5, 5.0, 5.0));
    }
    for (const TracedJoin& join : sketch.trace.joins) {
        painter.setPen(QPen(text, 1.3));
        painter.setBrush(Qt::NoBrush);
        const QPointF middle = 0.5 * (pixelOf(sketch.pointAt(join.before)) + pixelOf(sketch.pointAt(join.after)));
        painter.drawEllipse(middle, 5.0, 5.0);
    }
    for (const TracedSplit& split : sketch.trace.splits) {
        const QPointF at = pixelOf(sketch.pointAt(split.beam));
        painter.setPen(QPen(base, 1.0));
        painter.setBrush(text);
        painter.drawPolygon(
            QPolygonF{{at + QPointF(0, -4), at + QPointF(4, 0), at + QPointF(0, 4), at + QPointF(-4, 0)}});
    }
}

/// What is looked at in the table has a ring around it.
void SliceView::paintRow(QPainter& painter) const
{
    if (row_ < 0 || row_ >= model_.rowCount())
        return;
    const SliceSketch& sketch = *model_.sketch();
    const SliceModel::Row& row = model_.rowAt(row_);
    QRectF around;
    const auto take = [&](int beam) {
        const QPointF at = pixelOf(sketch.pointAt(beam));
        around = around.united(QRectF(at.x() - 9.0, at.y() - 9.0, 18.0, 18.0));
    };
    if (row.part == SlicePart::Piece) {
        take(sketch.trace.pieces[row.number].firstBeam);
        take(sketch.trace.pieces[row.number].lastBeam);
    } else if (row.part == SlicePart::Break) {
        take(sketch.trace.breaks[row.number].before);
        take(sketch.trace.breaks[row.number].after);
    } else if (row.part == SlicePart::Split) {
        take(sketch.trace.splits[row.number].beam);
    } else {
        take(sketch.trace.joins[row.number].before);
        take(sketch.trace.joins[row.number].after);
    }
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(around, 9.0, 9.0);
}

}  // namespace planewright
