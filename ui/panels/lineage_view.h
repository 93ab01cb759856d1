// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <set>

#include <QAbstractScrollArea>

#include "ui/common/palette.h"
#include "ui/models/lineage_chart.h"

namespace planewright {

/// A family of planes as bars over the steps, as thick as they have segments, with joints where planes were split and
/// merged. Arrow keys go from event to event and from plane to plane.
class LineageView : public QAbstractScrollArea {
    Q_OBJECT

public:
    explicit LineageView(QWidget* parent = nullptr);

    void setChart(LineageChart chart);
    const LineageChart& chart() const { return chart_; }
    /// The moment that is looked at: a line over all bars; −1 for none.
    void setPlayhead(int moment);
    /// Planes whose bars stand out.
    void setChosen(std::set<PlaneId> planes);
    void setPlanePalette(PlanePalette palette);

    /// The event that the arrow keys have come to.
    std::optional<std::size_t> currentEvent() const { return current_; }
    void setCurrentEvent(std::optional<std::size_t> event);

    /// Where an event and a moment of a plane's life are drawn, in the viewport.
    QPoint placeOf(std::size_t event) const;
    QPoint placeOf(PlaneId plane, int moment) const;

signals:
    /// Somebody has clicked an event or come to it with a key.
    void eventChosen(std::size_t event);
    /// Somebody has clicked a bar: its plane, and the step there, −1 for the forced last pass.
    void planeChosen(planewright::PlaneId plane, int step);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    double xOf(int moment) const;
    int momentAt(double x) const;
    double yOf(std::size_t bar) const;
    double thicknessOf(int segments) const;
    std::optional<std::size_t> eventAt(const QPointF& place) const;
    std::optional<std::size_t> barAt(const QPointF& place) const;
    QString tipAt(const QPointF& place) const;
    void goTo(std::optional<std::size_t> event);
    void updateScrollBar();

    void drawAxis(QPainter& painter) const;
    void drawBar(QPainter& painter, std::size_t place) const;
    void drawJoints(QPainter& painter) const;
    void drawEvents(QPainter& painter) const;

    LineageChart chart_;
    std::set<PlaneId> chosen_;
    int playhead_ = -1;
    std::optional<std::size_t> current_;
    PlanePalette planePalette_ = PlanePalette::Normal;
};

}  // namespace planewright
