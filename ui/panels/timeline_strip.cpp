// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/timeline_strip.h"

#include <algorithm>
#include <cmath>

#include <QContextMenuEvent>
#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleOptionFocusRect>
#include <QToolTip>

#include "ui/theme/theme.h"

namespace planewright {

namespace {

constexpr double kLabelSize = 0.84;  // of the font

}  // namespace

TimelineStrip::TimelineStrip(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("timelineStrip"));
    setAccessibleName(tr("Steps of the scan"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void TimelineStrip::setColumns(std::vector<TimelineColumn> columns, int expected)
{
    columns_ = std::move(columns);
    expected_ = expected;
    hovered_ = std::min(hovered_, static_cast<int>(columns_.size()) - 1);
    forgetPicture();
}

void TimelineStrip::setPlace(int place)
{
    if (place == place_)
        return;
    place_ = place;
    setAccessibleDescription(place >= 0 && place < static_cast<int>(columns_.size()) ? tipAt(place) : QString());
    update();
}

void TimelineStrip::setLoop(std::optional<std::pair<int, int>> loop)
{
    loop_ = loop;
    update();
}

void TimelineStrip::setBookmarks(std::set<int> bookmarks)
{
    bookmarks_ = std::move(bookmarks);
    forgetPicture();
}

void TimelineStrip::setHint(const QString& hint)
{
    hint_ = hint;
    forgetPicture();
    update();
}

void TimelineStrip::setLooksBack(bool looksBack)
{
    looksBack_ = looksBack;
    update();
}

void TimelineStrip::forgetPicture()
{
    picture_ = {};
    update();
}

Theme TimelineStrip::theme() const
{
    return themeOf(palette());
}

int TimelineStrip::count() const
{
    return std::max(static_cast<int>(columns_.size()), expected_);
}

QFont TimelineStrip::smallFont() const
{
    QFont small = font();
    if (small.pixelSize() > 0)
        small.setPixelSize(std::max(8, static_cast<int>(std::lround(kLabelSize * small.pixelSize()))));
    else
        small.setPointSizeF(kLabelSize * small.pointSizeF());
    return small;
}

int TimelineStrip::labelWidth() const
{
    const QFontMetrics metrics(smallFont());
    int widest = 0;
    for (std::size_t lane = 0; lane < kTimelineLanes; ++lane)
        widest = std::max(widest, metrics.horizontalAdvance(timelineLaneName(static_cast<TimelineLane>(lane))));
    constexpr int kForMark = 18;
    return widest + kForMark + kMargin;
}

QSize TimelineStrip::minimumSizeHint() const
{
    constexpr int kFewestColumns = 200;  // [px]
    const int line = QFontMetrics(smallFont()).height();
    return {labelWidth() + kFewestColumns, static_cast<int>(kTimelineLanes) * line};
}

/// Bars and splits take what is more than the least.
const TimelineStrip::Places& TimelineStrip::places() const
{
    if (places_)
        return *places_;
    constexpr std::array<double, kTimelineLanes> kShares{0.0, 0.35, 0.35, 0.0, 0.3, 0.0, 0.0};
    const double least = QFontMetrics(smallFont()).height();
    const double line = std::min(least, static_cast<double>(height()) / kTimelineLanes);
    const double more = std::max(0.0, height() - line * kTimelineLanes);
    Places places;
    places.left = labelWidth();
    double top = 0.0;
    for (std::size_t lane = 0; lane < kTimelineLanes; ++lane) {
        places.tops[lane] = static_cast<int>(std::lround(top));
        top += line + kShares[lane] * more;
    }
    places.tops[kTimelineLanes] = height();
    return places_.emplace(places);
}

QRect TimelineStrip::laneRect(TimelineLane lane) const
{
    const auto& [left, tops] = places();
    const auto number = static_cast<std::size_t>(lane);
    return {left, tops[number], std::max(1, width() - left - kMargin), tops[number + 1] - tops[number]};
}

QRectF TimelineStrip::columnRect(int place) const
{
    const QRect ruler = laneRect(TimelineLane::Ruler);
    const double each = static_cast<double>(ruler.width()) / std::max(1, count());
    return {ruler.left() + each * place, 0.0, each, static_cast<double>(height())};
}

int TimelineStrip::placeAt(double x) const
{
    if (columns_.empty())
        return -1;
    const QRect ruler = laneRect(TimelineLane::Ruler);
    const double share = (x - ruler.left()) / ruler.width();
    return std::clamp(static_cast<int>(std::floor(share * count())), 0, static_cast<int>(columns_.size()) - 1);
}

QString TimelineStrip::tipAt(int place) const
{
    return timelineTip(columns_[static_cast<std::size_t>(place)], bookmarks_.contains(place), planned_);
}

void TimelineStrip::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    if (columns_.empty()) {
        drawEmpty(painter);
    } else {
        const double ratio = devicePixelRatioF();
        if (picture_.isNull()) {
            picture_ = QPixmap((QSizeF(size()) * ratio).toSize());
            picture_.setDevicePixelRatio(ratio);
            picture_.fill(Qt::transparent);
            QPainter lanes(&picture_);
            drawLanes(lanes);
        }
        drawLoop(painter);
        painter.drawPixmap(0, 0, picture_);
        drawLiveEdge(painter);
        drawPlayhead(painter);
    }
    if (hasFocus()) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        focus.backgroundColor = palette().color(QPalette::Base);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

void TimelineStrip::mousePressEvent(QMouseEvent* event)
{
    const QPointF at = event->position();
    const QRect ruler = laneRect(TimelineLane::Ruler);
    if (event->button() != Qt::LeftButton || columns_.empty() || at.x() < ruler.left())
        return;
    dragFrom_ = placeAt(at.x());
    if (event->modifiers().testFlag(Qt::ShiftModifier) && at.y() < ruler.bottom() + 1) {
        drag_ = Drag::Loop;
        return;
    }
    drag_ = Drag::Scrub;
    emit placeChosen(dragFrom_);
}

void TimelineStrip::mouseMoveEvent(QMouseEvent* event)
{
    if (columns_.empty())
        return;
    const QPointF at = event->position();
    const int place = placeAt(at.x());
    if (drag_ == Drag::Scrub && place != place_)
        emit placeChosen(place);
    if (drag_ == Drag::Loop && place != dragFrom_)
        emit loopChosen(std::pair(std::min(place, dragFrom_), std::max(place, dragFrom_)));
    const bool isOver = at.x() >= laneRect(TimelineLane::Ruler).left();
    hovered_ = isOver ? place : -1;
    update();
    if (isOver)
        QToolTip::showText(event->globalPosition().toPoint(), tipAt(place), this);
    else
        QToolTip::hideText();
}

void TimelineStrip::mouseReleaseEvent(QMouseEvent* event)
{
    if (drag_ == Drag::Loop && placeAt(event->position().x()) == dragFrom_)
        emit loopChosen({});
    drag_ = Drag::None;
}

void TimelineStrip::leaveEvent(QEvent* /*event*/)
{
    hovered_ = -1;
    update();
}

void TimelineStrip::contextMenuEvent(QContextMenuEvent* event)
{
    if (columns_.empty())
        return;
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const int place = byKey ? std::max(0, place_) : placeAt(event->pos().x());
    emit menuRequested(place, byKey ? mapToGlobal(columnRect(place).center().toPoint()) : event->globalPos());
}

void TimelineStrip::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::StyleChange) {
        places_.reset();
        forgetPicture();
    }
    QWidget::changeEvent(event);
}

void TimelineStrip::resizeEvent(QResizeEvent* event)
{
    places_.reset();
    forgetPicture();
    QWidget::resizeEvent(event);
}

}  // namespace planewright
