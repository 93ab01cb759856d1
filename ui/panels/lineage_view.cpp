// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/lineage_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>
#include <QToolTip>

#include "core/types/plane_words.h"
#include "ui/models/decision_text.h"
#include "ui/models/number_text.h"
#include "ui/theme/theme.h"

namespace planewright {

namespace {

constexpr int kGutter = 46;       // for the names of planes [px]
constexpr int kRightMargin = 14;  // [px]
constexpr int kTopMargin = 6;     // [px]
constexpr int kBarRow = 28;       // [px]
constexpr int kAxisHeight = 22;   // [px]
constexpr double kThickest = 18.0;
constexpr double kThinnest = 4.0;
constexpr double kReach = 6.0;  // of a click beside a joint [px]
constexpr double kMark = 4.5;   // radius of an event [px]

QColor qColour(const Rgb& colour)
{
    return {colour.red, colour.green, colour.blue};
}

/// Steps between two numbers of the axis, so that they have room.
int tickStep(int steps, double width)
{
    constexpr double kRoom = 56.0;  // [px]
    for (const int every : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000}) {
        if (width * every / std::max(steps, 1) >= kRoom)
            return every;
    }
    return 10000;
}

}  // namespace

LineageView::LineageView(QWidget* parent) : QAbstractScrollArea(parent)
{
    setObjectName(QStringLiteral("lineageView"));
    setAccessibleName(tr("Lives of planes"));
    setAccessibleDescription(tr("Planes as bars over the steps; the table below tells the same in words."));
    setFocusPolicy(Qt::StrongFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setMouseTracking(true);
    verticalScrollBar()->setSingleStep(kBarRow);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, viewport(), qOverload<>(&QWidget::update));
}

void LineageView::setChart(LineageChart chart)
{
    if (current_ && (*current_ >= chart.events.size() || *current_ >= chart_.events.size() ||
                     !(chart.events[*current_] == chart_.events[*current_])))
        current_.reset();
    chart_ = std::move(chart);
    updateScrollBar();
    viewport()->update();
}

void LineageView::setPlayhead(int moment)
{
    playhead_ = moment;
    viewport()->update();
}

void LineageView::setChosen(std::set<PlaneId> planes)
{
    chosen_ = std::move(planes);
    viewport()->update();
}

void LineageView::setPlanePalette(PlanePalette palette)
{
    planePalette_ = palette;
    viewport()->update();
}

void LineageView::setCurrentEvent(std::optional<std::size_t> event)
{
    current_ = event;
    viewport()->update();
}

double LineageView::xOf(int moment) const
{
    const double width = viewport()->width() - kGutter - kRightMargin;
    return kGutter + width * moment / std::max(chart_.lastMoment(), 1);
}

int LineageView::momentAt(double x) const
{
    const double width = viewport()->width() - kGutter - kRightMargin;
    const double moment = (x - kGutter) / std::max(width, 1.0) * chart_.lastMoment();
    return std::clamp(static_cast<int>(std::lround(moment)), 0, std::max(chart_.lastMoment(), 0));
}

double LineageView::yOf(std::size_t bar) const
{
    return kTopMargin + kBarRow * (static_cast<double>(bar) + 0.5) - verticalScrollBar()->value();
}

double LineageView::thicknessOf(int segments) const
{
    return kThinnest +
           (kThickest - kThinnest) * std::sqrt(static_cast<double>(segments) / std::max(chart_.mostSegments, 1));
}

QPoint LineageView::placeOf(std::size_t event) const
{
    const FamilyEvent& happened = chart_.events[event];
    return placeOf(happened.plane, chart_.momentOf(happened.step));
}

QPoint LineageView::placeOf(PlaneId plane, int moment) const
{
    const auto bar = chart_.barOf(plane);
    return bar ? QPointF(xOf(moment), yOf(*bar)).toPoint() : QPoint();
}

std::optional<std::size_t> LineageView::eventAt(const QPointF& place) const
{
    // What was drawn last is on top.
    for (std::size_t event = chart_.events.size(); event-- > 0;) {
        const QPointF away = place - QPointF(placeOf(event));
        if (std::hypot(away.x(), away.y()) <= kReach + 1.0)
            return event;
    }
    for (const LifeJoint& joint : chart_.joints) {
        const double from = yOf(static_cast<std::size_t>(joint.from));
        const double to = yOf(static_cast<std::size_t>(joint.to));
        if (std::abs(place.x() - xOf(joint.moment)) <= kReach && place.y() >= std::min(from, to) &&
            place.y() <= std::max(from, to))
            return joint.event;
    }
    return std::nullopt;
}

std::optional<std::size_t> LineageView::barAt(const QPointF& place) const
{
    for (std::size_t bar = 0; bar < chart_.bars.size(); ++bar) {
        if (std::abs(place.y() - yOf(bar)) <= 0.5 * kBarRow && place.x() <= xOf(chart_.bars[bar].last) + kReach)
            return bar;
    }
    return std::nullopt;
}

QString LineageView::tipAt(const QPointF& place) const
{
    if (const auto event = eventAt(place))
        return tr("Step %1: %2").arg(stepText(chart_.events[*event].step), eventText(chart_.events[*event]));
    const auto bar = barAt(place);
    if (!bar)
        return {};
    const LifeBar& life = chart_.bars[*bar];
    const int moment = std::clamp(momentAt(place.x()), life.first, life.last);
    int segments = 0;
    for (const PlaneLife::Size& size : life.sizes)
        segments = size.step <= moment ? size.segments : segments;
    return tr("%1 at step %2: %3")
        .arg(QString::fromStdString(planeLabel(life.plane)), stepText(chart_.stepOf(moment)),
             countText(segments, tr("segment"), tr("segments")));
}

bool LineageView::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), viewport());
        return true;
    }
    if (event->type() == QEvent::MouseMove) {
        const QPointF place = static_cast<QMouseEvent*>(event)->position();
        viewport()->setCursor(eventAt(place) || barAt(place) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
    return QAbstractScrollArea::viewportEvent(event);
}

void LineageView::resizeEvent(QResizeEvent* event)
{
    QAbstractScrollArea::resizeEvent(event);
    updateScrollBar();
}

void LineageView::updateScrollBar()
{
    const int content = kTopMargin + kBarRow * static_cast<int>(chart_.bars.size()) + kAxisHeight;
    verticalScrollBar()->setRange(0, std::max(0, content - viewport()->height()));
    verticalScrollBar()->setPageStep(viewport()->height());
}

void LineageView::mousePressEvent(QMouseEvent* event)
{
    const QPointF place = event->position();
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto chosen = eventAt(place)) {
        goTo(chosen);
        return;
    }
    if (const auto bar = barAt(place)) {
        const LifeBar& life = chart_.bars[*bar];
        setCurrentEvent(std::nullopt);
        emit planeChosen(life.plane, chart_.stepOf(std::clamp(momentAt(place.x()), life.first, life.last)));
    }
}

void LineageView::goTo(std::optional<std::size_t> event)
{
    if (!event)
        return;
    setCurrentEvent(event);
    const int y = placeOf(*event).y();
    const int below = viewport()->height() - kAxisHeight - kBarRow / 2;
    if (y < kBarRow / 2)
        verticalScrollBar()->setValue(verticalScrollBar()->value() + y - kBarRow / 2);
    else if (y > below)
        verticalScrollBar()->setValue(verticalScrollBar()->value() + y - below);
    emit eventChosen(*event);
}

void LineageView::keyPressEvent(QKeyEvent* event)
{
    const std::size_t count = chart_.events.size();
    if (count == 0) {
        QAbstractScrollArea::keyPressEvent(event);
        return;
    }
    /// The event of the next plane up or down that is nearest in time.
    const auto beside = [&](int by) -> std::optional<std::size_t> {
        const auto own = chart_.barOf(chart_.events[*current_].plane);
        const int here = chart_.momentOf(chart_.events[*current_].step);
        for (int bar = static_cast<int>(own.value_or(0)) + by; bar >= 0 && bar < static_cast<int>(chart_.bars.size());
             bar += by) {
            std::optional<std::size_t> best;
            const auto away = [&](std::size_t i) { return std::abs(chart_.momentOf(chart_.events[i].step) - here); };
            for (std::size_t i = 0; i < count; ++i) {
                if (chart_.events[i].plane == chart_.bars[static_cast<std::size_t>(bar)].plane &&
                    (!best || away(i) < away(*best)))
                    best = i;
            }
            if (best)
                return best;
        }
        return std::nullopt;
    };
    switch (event->key()) {
        case Qt::Key_Home:
            goTo(0);
            break;
        case Qt::Key_End:
            goTo(count - 1);
            break;
        case Qt::Key_Right:
            goTo(current_ ? std::min(*current_ + 1, count - 1) : 0);
            break;
        case Qt::Key_Left:
            goTo(current_ ? *current_ - (*current_ > 0 ? 1 : 0) : count - 1);
            break;
        case Qt::Key_Up:
        case Qt::Key_Down:
            goTo(current_ ? beside(event->key() == Qt::Key_Up ? -1 : 1) : std::optional<std::size_t>(0));
            break;
        default:
            QAbstractScrollArea::keyPressEvent(event);
    }
}

void LineageView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Base));
    if (chart_.bars.empty())
        return;
    painter.save();
    painter.setClipRect(0, 0, viewport()->width(), viewport()->height() - kAxisHeight);
    for (std::size_t bar = 0; bar < chart_.bars.size(); ++bar)
        drawBar(painter, bar);
    drawJoints(painter);
    drawEvents(painter);
    painter.restore();
    drawAxis(painter);
    if (playhead_ >= 0) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
        painter.drawLine(QPointF(xOf(playhead_), 0.0), QPointF(xOf(playhead_), viewport()->height() - kAxisHeight));
    }
}

void LineageView::drawBar(QPainter& painter, std::size_t place) const
{
    const LifeBar& bar = chart_.bars[place];
    const double y = yOf(place);
    const bool isChosen = chosen_.contains(bar.plane);
    QFont labels = font();
    labels.setBold(isChosen);
    painter.setFont(labels);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(4.0, y - 0.5 * kBarRow, kGutter - 8.0, kBarRow), Qt::AlignVCenter | Qt::AlignLeft,
                     QString::fromStdString(planeLabel(bar.plane)));

    // Thick as it has segments, from one change to the next.
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    constexpr double kShortest = 3.0;  // [px]
    const double end = std::max(xOf(bar.last), xOf(bar.first) + kShortest);
    if (bar.sizes.empty())
        path.addRect(QRectF(xOf(bar.first), y - 0.5 * kThinnest, end - xOf(bar.first), kThinnest));
    for (std::size_t i = 0; i < bar.sizes.size(); ++i) {
        const double from = xOf(bar.sizes[i].step);
        const double to = i + 1 < bar.sizes.size() ? xOf(bar.sizes[i + 1].step) : end;
        const double thickness = thicknessOf(bar.sizes[i].segments);
        path.addRect(QRectF(from, y - 0.5 * thickness, std::max(to - from, 0.5), thickness));
    }
    const Theme theme = themeOf(palette());
    painter.fillPath(path, qColour(planeColour(bar.plane, planePalette_, theme)));
    if (isChosen) {
        painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
        painter.drawRect(
            QRectF(xOf(bar.first) - 2.0, y - 0.5 * kThickest - 2.0, end - xOf(bar.first) + 4.0, kThickest + 4.0));
    }
}

void LineageView::drawJoints(QPainter& painter) const
{
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
    for (const LifeJoint& joint : chart_.joints) {
        const double x = xOf(joint.moment);
        const double from = yOf(static_cast<std::size_t>(joint.from));
        const double to = yOf(static_cast<std::size_t>(joint.to));
        painter.drawLine(QPointF(x, from), QPointF(x, to));
        // An arrow to what it became.
        const double back = to > from ? -1.0 : 1.0;
        const QPointF tip(x, to + back * 2.0);
        QPolygonF arrow;
        arrow << tip << tip + QPointF(-4.0, back * 7.0) << tip + QPointF(4.0, back * 7.0);
        painter.setBrush(palette().color(QPalette::Text));
        painter.drawPolygon(arrow);
    }
}

void LineageView::drawEvents(QPainter& painter) const
{
    for (std::size_t i = 0; i < chart_.events.size(); ++i) {
        const QPointF place(placeOf(i));
        const bool isOver = chart_.events[i].kind == LifeEventKind::Deleted;
        painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
        painter.setBrush(palette().color(QPalette::Base));
        if (isOver) {
            painter.setPen(QPen(palette().color(QPalette::Text), 2.5));
            painter.drawLine(place - QPointF(kMark, kMark), place + QPointF(kMark, kMark));
            painter.drawLine(place - QPointF(kMark, -kMark), place + QPointF(kMark, -kMark));
        } else {
            painter.drawEllipse(place, kMark, kMark);
        }
        if (current_ == i) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(palette().color(QPalette::Highlight), 2.5));
            painter.drawEllipse(place, kMark + 4.0, kMark + 4.0);
        }
    }
}

void LineageView::drawAxis(QPainter& painter) const
{
    const int top = viewport()->height() - kAxisHeight;
    painter.setFont(font());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawLine(kGutter, top, viewport()->width() - kRightMargin, top);
    painter.drawText(QRect(4, top, kGutter - 8, kAxisHeight), Qt::AlignVCenter | Qt::AlignLeft, tr("step"));
    const int every = tickStep(chart_.lastMoment(), viewport()->width() - kGutter - kRightMargin);
    for (int step = every; step <= chart_.newestStep + 1; step += every) {
        const double x = xOf(step - 1);
        painter.drawLine(QPointF(x, top), QPointF(x, top + 4.0));
        constexpr double kHalf = 24.0;  // [px]
        const double left = std::min(x - kHalf, viewport()->width() - 2.0 * kHalf);
        const Qt::Alignment side = left < x - kHalf ? Qt::AlignRight : Qt::AlignHCenter;
        painter.drawText(QRectF(left, top + 3.0, 2.0 * kHalf, kAxisHeight - 3.0),
                         static_cast<int>(side | Qt::AlignVCenter), QString::number(step));
    }
}

}  // namespace planewright
