// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "ui/panels/timeline_strip.h"

namespace planewright {

namespace {

constexpr double kLargestMark = 8.0;  // [px]
constexpr double kSmallestMark = 2.0;
constexpr double kTickSpace = 44.0;  // between two numbers of the ruler [px]

struct LaneColours {
    Rgb light;
    Rgb dark;
};

constexpr std::array<LaneColours, kTimelineLanes> kLaneColours{{{{0x60, 0x65, 0x6d}, {0xaa, 0xaf, 0xb7}},
                                                                {{0x4a, 0x72, 0x9e}, {0x7f, 0xa8, 0xd4}},
                                                                {{0x1b, 0x7a, 0x6e}, {0x57, 0xc4, 0xb5}},
                                                                {{0x1b, 0x7a, 0x36}, {0x6a, 0xd0, 0x84}},
                                                                {{0x86, 0x3a, 0x9c}, {0xd0, 0x8b, 0xe6}},
                                                                {{0xb3, 0x26, 0x1e}, {0xff, 0x8a, 0x80}},
                                                                {{0x8a, 0x5a, 0x00}, {0xf0, 0xb9, 0x5a}}}};

QColor timelineShade(Rgb colour, double alpha = 1.0)
{
    QColor shaded(colour.red, colour.green, colour.blue);
    shaded.setAlphaF(static_cast<float>(alpha));
    return shaded;
}

/// The mark of a lane around a point, of this width and height [px].
QPainterPath markOf(TimelineLane lane, QPointF at, double width, double height)
{
    QPainterPath path;
    const double w = width / 2.0;
    const double h = height / 2.0;
    switch (lane) {
        case TimelineLane::Fits:
            path.addEllipse(at, w, h);
            break;
        case TimelineLane::SplitMerge:
            path.addPolygon(
                QPolygonF({at + QPointF(0.0, -h), at + QPointF(w, 0.0), at + QPointF(0.0, h), at + QPointF(-w, 0.0)}));
            path.closeSubpath();
            break;
        case TimelineLane::Faults:
            path.addPolygon(QPolygonF({at + QPointF(0.0, -h), at + QPointF(w, h), at + QPointF(-w, h)}));
            path.closeSubpath();
            break;
        case TimelineLane::Edits:  // a pencil that points down to the left
            path.addPolygon(QPolygonF({at + QPointF(-w, h), at + QPointF(-0.7 * w, 0.25 * h), at + QPointF(0.5 * w, -h),
                                       at + QPointF(w, -0.5 * h), at + QPointF(-0.25 * w, 0.7 * h)}));
            path.closeSubpath();
            break;
        default:
            break;
    }
    return path;
}

/// How far numbers on the ruler are apart, 1, 2 or 5 times a power of ten, so that they have room.
int tickStep(double columnWidth)
{
    for (int power = 1;; power *= 10) {
        for (const int factor : {1, 2, 5}) {
            if (factor * power * columnWidth >= kTickSpace)
                return factor * power;
        }
    }
}

}  // namespace

QString timelineLaneName(TimelineLane lane)
{
    switch (lane) {
        case TimelineLane::Ruler:
            return TimelineStrip::tr("step");
        case TimelineLane::PointCount:
            return TimelineStrip::tr("returns");
        case TimelineLane::SegmentCount:
            return TimelineStrip::tr("segments");
        case TimelineLane::Fits:
            return TimelineStrip::tr("fit");
        case TimelineLane::SplitMerge:
            return TimelineStrip::tr("split, merge");
        case TimelineLane::Faults:
            return TimelineStrip::tr("faults");
        case TimelineLane::Edits:
            break;
    }
    return TimelineStrip::tr("edits");
}

Rgb timelineColour(TimelineLane lane, Theme theme)
{
    const LaneColours& colours = kLaneColours[static_cast<std::size_t>(lane)];
    return theme == Theme::Dark ? colours.dark : colours.light;
}

Rgb liveEdgeColour(Theme theme)
{
    return theme == Theme::Dark ? Rgb{0xff, 0xb9, 0x38} : Rgb{0xa8, 0x6a, 0x00};
}

void TimelineStrip::drawEmpty(QPainter& painter) const
{
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(kMargin, 0, -kMargin, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Every step of a scan appears here, to be looked at again.") +
                         (hint_.isEmpty() ? QString() : QLatin1Char(' ') + hint_));
}

void TimelineStrip::drawLanes(QPainter& painter) const
{
    drawLabels(painter);
    drawRuler(painter);
    drawBars(painter, TimelineLane::PointCount, &TimelineColumn::points);
    drawBars(painter, TimelineLane::SegmentCount, &TimelineColumn::segments);
    drawMarks(painter);
    drawBookmarks(painter);
}

void TimelineStrip::drawLabels(QPainter& painter) const
{
    painter.setFont(smallFont());
    QColor line = palette().color(QPalette::WindowText);
    constexpr float kFaint = 0.18F;
    line.setAlphaF(kFaint);
    for (std::size_t number = 0; number < kTimelineLanes; ++number) {
        const auto lane = static_cast<TimelineLane>(number);
        const QRect area = laneRect(lane);
        const QRect label(kMargin, area.top(), area.left() - 2 * kMargin, area.height());
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(label, Qt::AlignLeft | Qt::AlignVCenter, timelineLaneName(lane));
        painter.setPen(line);
        painter.drawLine(area.left(), area.bottom(), area.right(), area.bottom());
        painter.setRenderHint(QPainter::Antialiasing);
        const QPointF at(label.right() - kLargestMark / 2.0, area.center().y() + 0.5);
        painter.fillPath(markOf(lane, at, kLargestMark, kLargestMark), timelineShade(timelineColour(lane, theme())));
        painter.setRenderHint(QPainter::Antialiasing, false);
    }
}

void TimelineStrip::drawRuler(QPainter& painter) const
{
    const QRect area = laneRect(TimelineLane::Ruler);
    const int each = tickStep(columnRect(0).width());
    painter.setFont(smallFont());
    const int known = static_cast<int>(columns_.size());
    for (int place = 0; place < count(); ++place) {
        // What is yet to come is numbered on from the last.
        const int step =
            place < known ? columns_[static_cast<std::size_t>(place)].step : columns_.back().step + 1 + place - known;
        if (step < 0 || ((step + 1) % each != 0 && step != 0) || (place >= known && columns_.back().step < 0))
            continue;
        const double x = columnRect(place).center().x();
        painter.setPen(timelineShade(timelineColour(TimelineLane::Ruler, theme())));
        painter.drawLine(QPointF(x, area.bottom() - 2), QPointF(x, area.bottom()));
        constexpr int kNumberWidth = 40;
        const QRect number(std::clamp(static_cast<int>(x) - kNumberWidth / 2, area.left() - kMargin,
                                      std::max(area.left(), area.right() + kMargin - kNumberWidth)),
                           area.top(), kNumberWidth, area.height() - 2);
        // The first number only where the next leaves room for it.
        if (step == 0 && each > 1 && each * columnRect(0).width() < kTickSpace)
            continue;
        painter.setPen(palette().color(QPalette::Text));
        const Qt::Alignment side = number.left() == area.left() - kMargin ? Qt::AlignLeft : Qt::AlignHCenter;
        painter.drawText(number, static_cast<int>(side | Qt::AlignVCenter), QString::number(step + 1));
    }
}

void TimelineStrip::drawBars(QPainter& painter, TimelineLane lane, int TimelineColumn::*value) const
{
    int largest = 1;
    for (const TimelineColumn& column : columns_)
        largest = std::max(largest, column.*value);
    const QRect area = laneRect(lane).adjusted(0, 1, 0, -1);
    const QColor colour = timelineShade(timelineColour(lane, theme()));
    const auto fill = [&](double left, double right, int most) {
        if (most == 0)
            return;
        const double high = std::max(1.0, static_cast<double>(area.height()) * most / largest);
        painter.fillRect(QRectF(left, area.bottom() + 1 - high, right - left, high), colour);
    };
    const int known = static_cast<int>(columns_.size());
    const double each = columnRect(0).width();
    if (each >= 1.0) {
        const double gap = each >= 3.0 ? 1.0 : 0.0;
        for (int place = 0; place < known; ++place) {
            const double left = std::round(area.left() + each * place);
            const double right = std::round(area.left() + each * (place + 1));
            fill(left, right - gap, columns_[static_cast<std::size_t>(place)].*value);
        }
        return;
    }
    for (int x = 0; x < area.width(); ++x) {
        const int from = static_cast<int>(std::floor(x / each));
        const int to = std::min(known, static_cast<int>(std::ceil((x + 1) / each)));
        int most = 0;
        for (int place = from; place < to; ++place)
            most = std::max(most, columns_[static_cast<std::size_t>(place)].*value);
        fill(area.left() + x, area.left() + x + 1, most);
    }
}

void TimelineStrip::drawMarks(QPainter& painter) const
{
    int mostOperations = 1;
    for (const TimelineColumn& column : columns_)
        mostOperations = std::max(mostOperations, column.operations());
    painter.setRenderHint(QPainter::Antialiasing);
    for (const TimelineLane lane :
         {TimelineLane::Fits, TimelineLane::SplitMerge, TimelineLane::Faults, TimelineLane::Edits}) {
        const QRect area = laneRect(lane);
        const QColor colour = timelineShade(timelineColour(lane, theme()));
        constexpr double kPale = 0.45;
        const QColor pale = timelineShade(timelineColour(lane, theme()), kPale);
        // Marks of a schedule have so many columns between them that they need not be narrower than three of them.
        constexpr double kColumnsApart = 4.0;
        const double width = std::clamp(kColumnsApart * columnRect(0).width(), kSmallestMark + 1.0, kLargestMark);
        const double high = area.height() - 2.0;
        for (std::size_t place = 0; place < columns_.size(); ++place) {
            const TimelineColumn& column = columns_[place];
            const QPointF at(columnRect(static_cast<int>(place)).center().x(), area.center().y() + 0.5);
            const auto draw = [&](double w, double h, const QColor& with) {
                painter.fillPath(markOf(lane, at, w, h), with);
            };
            if (lane == TimelineLane::Fits) {
                if (column.fitted > 0)
                    draw(width, std::min(width, high), colour);
                else if (column.fits)
                    draw(width / 2.0, width / 2.0, pale);
            } else if (lane == TimelineLane::SplitMerge) {
                if (const int operations = column.operations(); operations > 0)
                    draw(width, 4.0 + (high - 4.0) * operations / mostOperations, colour);
                else if (column.splitsAndMerges)
                    draw(width / 2.0, width / 2.0, pale);
            } else if (lane == TimelineLane::Faults ? !column.faults.empty() : !column.edits.empty()) {
                draw(kLargestMark, std::min(kLargestMark, high), colour);
            }
        }
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void TimelineStrip::drawBookmarks(QPainter& painter) const
{
    const QRect area = laneRect(TimelineLane::Ruler);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const int place : bookmarks_) {
        if (place >= static_cast<int>(columns_.size()))
            continue;
        const double x = columnRect(place).center().x();
        const double top = area.top() + 1.0;
        QPainterPath flag;
        constexpr double kLong = 8.0;
        constexpr double kHigh = 7.0;
        flag.addPolygon(QPolygonF({{x, top},
                                   {x + kLong, top},
                                   {x + kLong - 3.0, top + kHigh / 2.0},
                                   {x + kLong, top + kHigh},
                                   {x, top + kHigh}}));
        flag.closeSubpath();
        const QColor colour = palette().color(QPalette::Highlight);
        painter.strokePath(flag, QPen(palette().color(QPalette::Base), 2.0));
        painter.fillPath(flag, colour);
        painter.fillRect(QRectF(x - 0.75, top, 1.5, area.height() - 1.0), colour);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void TimelineStrip::drawLoop(QPainter& painter) const
{
    if (!loop_)
        return;
    const double left = columnRect(loop_->first).left();
    const double right = columnRect(loop_->second).right();
    QColor band = palette().color(QPalette::Highlight);
    painter.fillRect(QRectF(left, 0.0, 2.0, height()), band);
    painter.fillRect(QRectF(right - 2.0, 0.0, 2.0, height()), band);
    constexpr float kThin = 0.14F;
    band.setAlphaF(kThin);
    painter.fillRect(QRectF(left, 0.0, right - left, height()), band);
    constexpr float kThick = 0.3F;
    band.setAlphaF(kThick);
    const QRect ruler = laneRect(TimelineLane::Ruler);
    painter.fillRect(QRectF(left, ruler.top(), right - left, ruler.height()), band);
}

void TimelineStrip::drawLiveEdge(QPainter& painter) const
{
    if (!looksBack_)
        return;
    const double from = columnRect(place_).right();
    const double to = columnRect(static_cast<int>(columns_.size()) - 1).right();
    constexpr double kThin = 0.18;
    constexpr double kEdge = 4.0;
    if (to > from)
        painter.fillRect(QRectF(from, 0.0, to - from, height()), timelineShade(liveEdgeColour(theme()), kThin));
    painter.fillRect(QRectF(to - kEdge / 2.0, 0.0, kEdge, height()), timelineShade(liveEdgeColour(theme())));
}

void TimelineStrip::drawPlayhead(QPainter& painter) const
{
    const int known = static_cast<int>(columns_.size());
    if (hovered_ >= 0 && hovered_ < known && hovered_ != place_) {
        QColor hover = palette().color(QPalette::Text);
        constexpr float kThin = 0.35F;
        hover.setAlphaF(kThin);
        painter.fillRect(QRectF(columnRect(hovered_).center().x() - 0.5, 0.0, 1.0, height()), hover);
    }
    if (place_ < 0 || place_ >= known)
        return;
    const double x = std::round(columnRect(place_).center().x());
    const QColor colour = palette().color(QPalette::Text);
    // A rim of the background keeps it apart from whatever it stands on.
    painter.fillRect(QRectF(x - 2.0, 0.0, 4.0, height()), palette().base());
    painter.fillRect(QRectF(x - 1.0, 0.0, 2.0, height()), colour);
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr double kHead = 6.0;
    QPainterPath head;
    head.addPolygon(QPolygonF({{x - kHead, 0.0}, {x + kHead, 0.0}, {x, kHead + 2.0}}));
    head.closeSubpath();
    painter.strokePath(head, QPen(palette().color(QPalette::Base), 2.0));
    painter.fillPath(head, colour);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace planewright
