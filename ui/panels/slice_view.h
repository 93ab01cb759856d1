// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <set>

#include <QWidget>

#include "ui/models/slice_model.h"

namespace planewright {

/// A slice in the laser's own frame, ahead upwards: points, pieces, breakpoints and split points over rings of range
/// and lines of bearing.
///
/// The wheel zooms to the pointer and dragging pans; with the keyboard + and −, the arrow keys, and F to fit.
class SliceView : public QWidget {
    Q_OBJECT

public:
    /// The model must live as long as this.
    explicit SliceView(SliceModel& model, QWidget* parent = nullptr);

    /// Segments that are marked, and the row that is looked at in the table, −1 for none.
    void setSelected(std::set<SegmentId> segments);
    void setRow(int row);

    /// Shows all of the slice, now and whenever another comes, until somebody zooms or pans.
    void fit();
    /// Nearer by this factor, with the point under a place staying where it is.
    void zoom(double factor, const QPointF& about);

    QPointF pixelOf(const Eigen::Vector2d& point) const;
    Eigen::Vector2d pointOf(const QPointF& pixel) const;
    /// The row of what is drawn at a place; nothing where there is nothing.
    std::optional<int> rowAt(const QPointF& pixel) const;

    QSize minimumSizeHint() const override { return {160, 100}; }
    QSize sizeHint() const override { return {400, 180}; }

signals:
    /// Somebody has clicked on a row's part; on nothing: −1. `add`: with Ctrl.
    void rowChosen(int row, bool add);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void takeSlice();
    void paintGrid(QPainter& painter) const;
    void paintPieces(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintRow(QPainter& painter) const;
    void pan(const QPointF& by);

    SliceModel& model_;
    std::set<SegmentId> selected_;
    int row_ = -1;
    Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();  // of the picture [m]
    double scale_ = 40.0;                               // [px/m]
    bool fits_ = true;
    std::optional<QPointF> pressed_;
    QPointF last_;
    bool dragged_ = false;
};

}  // namespace planewright
