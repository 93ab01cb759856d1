// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/slice_view.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

namespace planewright {

namespace {

constexpr double kLeastScale = 0.5;  // [px/m]
constexpr double kMostScale = 5000.0;
constexpr double kZoomStep = 1.25;
constexpr double kPanStep = 40.0;    // [px]
constexpr double kNearPixels = 8.0;  // of what the pointer means
constexpr double kMargin = 18.0;     // around a slice that fits [px]

double distanceToLine(const QPointF& p, const QPointF& a, const QPointF& b)
{
    const QPointF along = b - a;
    const double squared = QPointF::dotProduct(along, along);
    const double t = squared > 0.0 ? std::clamp(QPointF::dotProduct(p - a, along) / squared, 0.0, 1.0) : 0.0;
    const QPointF off = p - (a + t * along);
    return std::hypot(off.x(), off.y());
}

}  // namespace

SliceView::SliceView(SliceModel& model, QWidget* parent) : QWidget(parent), model_(model)
{
    setObjectName(QStringLiteral("sliceView"));
    setAccessibleName(tr("Drawing of the slice"));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    connect(&model_, &QAbstractItemModel::modelReset, this, &SliceView::takeSlice);
    takeSlice();
}

void SliceView::takeSlice()
{
    row_ = -1;
    setAccessibleDescription(model_.summary());
    if (fits_)
        fit();
    update();
}

void SliceView::setSelected(std::set<SegmentId> segments)
{
    selected_ = std::move(segments);
    update();
}

void SliceView::setRow(int row)
{
    row_ = row;
    update();
}

void SliceView::fit()
{
    fits_ = true;
    update();
    if (!model_.sketch() || !model_.sketch()->slice)
        return;
    const SliceSketch& sketch = *model_.sketch();
    Eigen::Vector2d low = Eigen::Vector2d::Zero();
    Eigen::Vector2d high = Eigen::Vector2d::Zero();
    for (int beam = 0; beam < static_cast<int>(sketch.slice->ranges.size()); ++beam) {
        if (!sketch.hasEcho(beam))
            continue;
        low = low.cwiseMin(sketch.pointAt(beam));
        high = high.cwiseMax(sketch.pointAt(beam));
    }
    const Eigen::Vector2d span = (high - low).cwiseMax(0.1);
    centre_ = 0.5 * (low + high);
    scale_ = std::clamp(std::min((width() - 2.0 * kMargin) / span.x(), (height() - 2.0 * kMargin) / span.y()),
                        kLeastScale, kMostScale);
}

void SliceView::zoom(double factor, const QPointF& about)
{
    const Eigen::Vector2d there = pointOf(about);
    scale_ = std::clamp(scale_ * factor, kLeastScale, kMostScale);
    centre_ += there - pointOf(about);
    fits_ = false;
    update();
}

void SliceView::pan(const QPointF& by)
{
    centre_ += Eigen::Vector2d{-by.x(), by.y()} / scale_;
    fits_ = false;
    update();
}

QPointF SliceView::pixelOf(const Eigen::Vector2d& point) const
{
    const Eigen::Vector2d off = scale_ * (point - centre_);
    return {0.5 * width() + off.x(), 0.5 * height() - off.y()};
}

Eigen::Vector2d SliceView::pointOf(const QPointF& pixel) const
{
    return centre_ + Eigen::Vector2d{pixel.x() - 0.5 * width(), 0.5 * height() - pixel.y()} / scale_;
}

std::optional<int> SliceView::rowAt(const QPointF& pixel) const
{
    if (!model_.sketch() || !model_.sketch()->slice)
        return std::nullopt;
    const SliceSketch& sketch = *model_.sketch();
    const SliceTrace& trace = sketch.trace;
    std::optional<int> found;
    double least = kNearPixels;
    // Marks are smaller than lines, and come first where both are as near.
    const auto take = [&](double distance, SlicePart part, std::size_t number) {
        if (distance < least) {
            least = distance;
            found = model_.rowOf(part, number);
        }
    };
    const auto toBeam = [&](int beam) {
        const QPointF off = pixelOf(sketch.pointAt(beam)) - pixel;
        return std::hypot(off.x(), off.y());
    };
    for (std::size_t i = 0; i < trace.splits.size(); ++i)
        take(toBeam(trace.splits[i].beam) - 3.0, SlicePart::Split, i);
    for (std::size_t i = 0; i < trace.joins.size(); ++i)
        take(std::min(toBeam(trace.joins[i].before), toBeam(trace.joins[i].after)) - 2.0, SlicePart::Join, i);
    for (std::size_t i = 0; i < trace.breaks.size(); ++i)
        take(std::min(toBeam(trace.breaks[i].before), toBeam(trace.breaks[i].after)) - 2.0, SlicePart::Break, i);
    for (std::size_t i = 0; i < trace.pieces.size(); ++i) {
        const TracedPiece& piece = trace.pieces[i];
        take(distanceToLine(pixel, pixelOf(sketch.pointAt(piece.firstBeam)), pixelOf(sketch.pointAt(piece.lastBeam))),
             SlicePart::Piece, i);
    }
    return found;
}

void SliceView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setRenderHint(QPainter::Antialiasing);
    const bool hasSlice = model_.sketch() && model_.sketch()->slice;
    paintGrid(painter);
    if (hasSlice) {
        paintPieces(painter);
        paintMarks(painter);
        paintRow(painter);
    } else {
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(rect().adjusted(8, 0, -8, 0), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No slice yet. It appears with the first step."));
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
        painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
    }
}

void SliceView::resizeEvent(QResizeEvent*)
{
    if (fits_)
        fit();
}

void SliceView::wheelEvent(QWheelEvent* event)
{
    zoom(std::pow(kZoomStep, event->angleDelta().y() / 120.0), event->position());
    event->accept();
}

void SliceView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)
        return;
    pressed_ = last_ = event->position();
    dragged_ = event->button() == Qt::MiddleButton;
}

void SliceView::mouseMoveEvent(QMouseEvent* event)
{
    if (!pressed_)
        return;
    dragged_ = dragged_ || (event->position() - *pressed_).manhattanLength() >= QApplication::startDragDistance();
    if (!dragged_)
        return;
    pan(event->position() - last_);
    last_ = event->position();
}

void SliceView::mouseReleaseEvent(QMouseEvent* event)
{
    if (pressed_ && !dragged_)
        emit rowChosen(rowAt(event->position()).value_or(-1), event->modifiers().testFlag(Qt::ControlModifier));
    pressed_.reset();
}

void SliceView::keyPressEvent(QKeyEvent* event)
{
    const QPointF middle(0.5 * width(), 0.5 * height());
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoom(kZoomStep, middle);
        case Qt::Key_Minus:
            return zoom(1.0 / kZoomStep, middle);
        case Qt::Key_Left:
            return pan({kPanStep, 0.0});
        case Qt::Key_Right:
            return pan({-kPanStep, 0.0});
        case Qt::Key_Up:
            return pan({0.0, kPanStep});
        case Qt::Key_Down:
            return pan({0.0, -kPanStep});
        case Qt::Key_F:
            return fit();
        default:
            QWidget::keyPressEvent(event);
    }
}

bool SliceView::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto row = rowAt(help->pos());
        QToolTip::showText(
            help->globalPos(),
            row ? model_.sentence(*row) : tr("Wheel or + and −: zoom. Drag or arrow keys: move. F: show all."), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool bare = !(static_cast<QKeyEvent*>(event)->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
        for (const int mine : {Qt::Key_Plus, Qt::Key_Equal, Qt::Key_Minus, Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,
                               Qt::Key_Down, Qt::Key_F}) {
            if (bare && key == mine) {
                event->accept();
                return true;
            }
        }
    }
    return QWidget::event(event);
}

}  // namespace planewright
