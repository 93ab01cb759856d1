// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <QImage>
#include <QWidget>

#include "ui/charts/chart_painting.h"

namespace planewright {

/// One chart with the cursor at the step that is looked at. A click goes to the step that it is on.
///
/// The chart is drawn when it is seen, once for all positions of the cursor.
class ChartView : public QWidget {
    Q_OBJECT

public:
    explicit ChartView(QWidget* parent = nullptr);

    void setChart(Chart chart);
    const Chart& chart() const { return chart_; }

    /// The place in the history that is looked at; −1 for none.
    void setPlace(int place);
    /// The point of the chart that stands for it; nothing where there is none.
    std::optional<std::size_t> cursor() const;

    /// Where the numbers are; empty before it was painted.
    const PlotFrame& frame() const { return frame_; }
    /// How long drawing the chart took last [ms].
    double drawingTime() const { return drawingTime_; }

    QSize sizeHint() const override { return {360, 160}; }
    QSize minimumSizeHint() const override { return {220, 120}; }

signals:
    void placeChosen(int place);
    /// A double click or Return: this chart alone is wanted, or all of them again.
    void enlargeRequested();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    std::optional<std::size_t> pointAt(const QPointF& place) const;
    QPointF pixelOf(std::size_t point) const;
    QString textOf(std::size_t point) const;
    void draw();
    void drawCursor(QPainter& painter) const;
    void describe();

    Chart chart_;
    int place_ = -1;
    QImage image_;
    bool due_ = true;
    PlotFrame frame_;
    double drawingTime_ = 0.0;
};

}  // namespace planewright
