// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/charts/chart_view.h"

#include <algorithm>
#include <cmath>

#include <QElapsedTimer>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QToolTip>

#include "ui/models/number_text.h"

namespace planewright {

namespace {

constexpr double kNear = 40.0;  // of a point that is meant [px]

}  // namespace

ChartView::ChartView(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::CrossCursor);
}

void ChartView::setChart(Chart chart)
{
    chart_ = std::move(chart);
    setObjectName(QString::fromStdString(chart_.id));
    due_ = true;
    describe();
    update();
}

void ChartView::setPlace(int place)
{
    if (place == place_)
        return;
    place_ = place;
    describe();
    update();
}

/// The last pass is no step: its cursor is at the step before.
std::optional<std::size_t> ChartView::cursor() const
{
    const auto after = std::upper_bound(chart_.places.begin(), chart_.places.end(), place_);
    if (place_ < 0 || after == chart_.places.begin())
        return std::nullopt;
    return static_cast<std::size_t>(after - chart_.places.begin()) - 1;
}

void ChartView::describe()
{
    setAccessibleName(QString::fromStdString(chart_.title));
    const auto at = cursor();
    setAccessibleDescription(at                 ? textOf(*at)
                             : chart_.isEmpty() ? tr("Data appears with the first slice.")
                                                : QString::fromStdString(chart_.note));
}

QString ChartView::textOf(std::size_t point) const
{
    QStringList parts;
    for (const ChartSeries& one : chart_.series) {
        if (one.style == ChartSeries::Style::Limit || one.style == ChartSeries::Style::Fit || point >= one.y.size())
            continue;
        const bool whole = one.y[point] == std::floor(one.y[point]);
        parts << tr("%1 %2 %3")
                     .arg(QString::fromStdString(one.name), numberText(one.y[point], whole ? 0 : 2),
                          QString::fromStdString(chart_.yTitle))
                     .trimmed();
    }
    const QString x = numberText(chart_.series.front().x[point], 0);
    return (chart_.overSteps ? tr("Step %1: ").arg(x) : tr("%1 %2: ").arg(x, QString::fromStdString(chart_.xTitle))) +
           parts.join(QStringLiteral(", "));
}

QPointF ChartView::pixelOf(std::size_t point) const
{
    const ChartSeries& first = chart_.series.front();
    double y = first.y[point];
    if (first.style == ChartSeries::Style::Stacked) {
        for (std::size_t i = 1; i < chart_.series.size(); ++i)
            y += chart_.series[i].style == ChartSeries::Style::Stacked ? chart_.series[i].y[point] : 0.0;
    }
    return frame_.pixel(first.x[point], y);
}

/// Over steps the nearest step, wherever the pointer is above it; otherwise the nearest point.
std::optional<std::size_t> ChartView::pointAt(const QPointF& place) const
{
    if (chart_.places.empty() || frame_.isEmpty())
        return std::nullopt;
    std::optional<std::size_t> nearest;
    double least = chart_.overSteps ? 1e9 : kNear;
    for (std::size_t i = 0; i < chart_.places.size(); ++i) {
        const QPointF off = pixelOf(i) - place;
        const double distance = chart_.overSteps ? std::abs(off.x()) : std::hypot(off.x(), off.y());
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    const bool isInside = frame_.area.adjusted(-6.0, -6.0, 6.0, 20.0).contains(place);
    return isInside ? nearest : std::nullopt;
}

void ChartView::draw()
{
    QElapsedTimer clock;
    clock.start();
    const double ratio = devicePixelRatioF();
    image_ = QImage((QSizeF(size()) * ratio).toSize().expandedTo({1, 1}), QImage::Format_RGB32);
    image_.setDevicePixelRatio(ratio);
    QPainter painter(&image_);
    frame_ = paintChart(painter, QSizeF(size()), chart_, {palette(), font()});
    due_ = false;
    drawingTime_ = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
}

void ChartView::drawCursor(QPainter& painter) const
{
    const auto at = cursor();
    if (!at || frame_.isEmpty())
        return;
    const QPointF place = pixelOf(*at);
    const QColor line = palette().color(QPalette::Highlight);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(line, 2.0));
    if (chart_.overSteps)
        painter.drawLine(QPointF(place.x(), frame_.area.top()), QPointF(place.x(), frame_.area.bottom()));
    if (!std::isfinite(place.y()))
        return;
    painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
    painter.setBrush(line);
    painter.drawEllipse(place, 4.5, 4.5);
}

void ChartView::paintEvent(QPaintEvent*)
{
    if (due_ || image_.size() != (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1}))
        draw();
    QPainter painter(this);
    painter.drawImage(QPoint(0, 0), image_);
    drawCursor(painter);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
        painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
    }
}

void ChartView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto point = pointAt(event->position()))
        emit placeChosen(chart_.places[*point]);
}

void ChartView::mouseDoubleClickEvent(QMouseEvent*)
{
    emit enlargeRequested();
}

void ChartView::keyPressEvent(QKeyEvent* event)
{
    const auto count = static_cast<int>(chart_.places.size());
    const int at = cursor() ? static_cast<int>(*cursor()) : -1;
    int wanted = -1;
    switch (event->key()) {
        case Qt::Key_Left:
            wanted = std::max(0, at - 1);
            break;
        case Qt::Key_Right:
            wanted = std::min(count - 1, at + 1);
            break;
        case Qt::Key_Home:
            wanted = 0;
            break;
        case Qt::Key_End:
            wanted = count - 1;
            break;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            emit enlargeRequested();
            return;
        default:
            QWidget::keyPressEvent(event);
            return;
    }
    if (wanted >= 0 && wanted < count)
        emit placeChosen(chart_.places[static_cast<std::size_t>(wanted)]);
}

bool ChartView::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto point = pointAt(help->pos());
        QToolTip::showText(help->globalPos(),
                           point ? textOf(*point)
                           : chart_.places.empty()
                               ? QString::fromStdString(chart_.note)
                               : tr("Click: go to the step. Double click: this chart alone (Return)."),
                           this);
        return true;
    }
    // Keys that mean a step here mean something else in the window.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isMine = key->key() == Qt::Key_Left || key->key() == Qt::Key_Right || key->key() == Qt::Key_Home ||
                            key->key() == Qt::Key_End;
        if (isMine && key->modifiers() == Qt::NoModifier) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void ChartView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::StyleChange) {
        due_ = true;
        update();
    }
    QWidget::changeEvent(event);
}

}  // namespace planewright
