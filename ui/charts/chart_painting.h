// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QFont>
#include <QPainter>
#include <QPalette>

#include "ui/common/chart.h"

namespace planewright {

/// Where the numbers of a chart are in its picture.
struct PlotFrame {
    QRectF area;  ///< between the axes [px]
    double lowX = 0.0;
    double highX = 1.0;
    double lowY = 0.0;
    double highY = 1.0;

    bool isEmpty() const { return area.isEmpty(); }
    double pixelX(double x) const { return area.left() + (x - lowX) / (highX - lowX) * area.width(); }
    double pixelY(double y) const { return area.bottom() - (y - lowY) / (highY - lowY) * area.height(); }
    QPointF pixel(double x, double y) const { return {pixelX(x), pixelY(y)}; }
};

/// Colours and letters of a chart.
struct ChartLook {
    QPalette palette;
    QFont font;
};

/// Draws a chart with title, key and axes into a rectangle whose top left is the painter's origin; a chart without
/// numbers has axes and says what it waits for. Takes a few milliseconds for a thousand steps.
PlotFrame paintChart(QPainter& painter, const QSizeF& size, const Chart& chart, const ChartLook& look);

/// The colour of a series.
QColor seriesColour(const ChartSeries& series, const QPalette& palette);

}  // namespace planewright
