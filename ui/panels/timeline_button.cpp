// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/timeline_button.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QAction>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyleOptionToolButton>

#include "ui/theme/motion.h"

namespace planewright {

namespace {

constexpr double kGlyph = 12.0;                     // side of a sign [px]
constexpr int kButtonSide = 28;                     // [px]
constexpr int kBeats = 24;                          // of a pulse
constexpr std::chrono::milliseconds kBeatTime{50};  // a pulse lasts 1.2 s
const QColor kLiveStrong(0x8a, 0x5a, 0x00);         // white on it is 5.9 : 1
const QColor kLiveWeak(0x6b, 0x46, 0x00);           // white on it is 8.4 : 1

/// A triangle that points right, or left, in a square of side 1 around the middle.
void addTriangle(QPainterPath& path, double from, double to)
{
    path.moveTo(from, -0.5);
    path.lineTo(to, 0.0);
    path.lineTo(from, 0.5);
    path.closeSubpath();
}

void addBar(QPainterPath& path, double left, double width)
{
    path.addRect(QRectF(left, -0.5, width, 1.0));
}

QPainterPath filledGlyph(TimelineGlyph glyph, bool isOn)
{
    QPainterPath path;
    constexpr double kBar = 0.16;
    switch (glyph) {
        case TimelineGlyph::First:
            addBar(path, -0.5, kBar);
            addTriangle(path, 0.45, -0.3);
            break;
        case TimelineGlyph::Last:
            addTriangle(path, -0.45, 0.3);
            addBar(path, 0.5 - kBar, kBar);
            break;
        case TimelineGlyph::Back:
            addTriangle(path, 0.15, -0.5);
            addBar(path, 0.28, kBar);
            break;
        case TimelineGlyph::Forward:
            addBar(path, -0.28 - kBar, kBar);
            addTriangle(path, -0.15, 0.5);
            break;
        case TimelineGlyph::Play:
            if (isOn) {
                addBar(path, -0.4, 0.28);
                addBar(path, 0.12, 0.28);
            } else {
                addTriangle(path, -0.35, 0.55);
            }
            break;
        default:
            break;
    }
    return path;
}

/// Signs that are lines.
QPainterPath drawnGlyph(TimelineGlyph glyph)
{
    QPainterPath path;
    if (glyph == TimelineGlyph::Earlier || glyph == TimelineGlyph::Later) {
        const double tip = glyph == TimelineGlyph::Later ? 0.22 : -0.22;
        path.moveTo(-tip, -0.42);
        path.lineTo(tip, 0.0);
        path.lineTo(-tip, 0.42);
    } else if (glyph == TimelineGlyph::Loop) {
        constexpr double kFrom = 60.0;
        constexpr double kSpan = 290.0;
        const QRectF circle(-0.45, -0.45, 0.9, 0.9);
        path.arcMoveTo(circle, kFrom);
        path.arcTo(circle, kFrom, -kSpan);
        const QPointF end = path.currentPosition();
        path.moveTo(end + QPointF(-0.3, -0.08));
        path.lineTo(end);
        path.lineTo(end + QPointF(0.02, -0.36));
    }
    return path;
}

/// A button answers Space while it has the keyboard, whatever else Space does around it.
bool takesSpace(QEvent* event)
{
    if (event->type() != QEvent::ShortcutOverride || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Space)
        return false;
    event->accept();
    return true;
}

void setUpTimelineButton(QToolButton& button, QAction* action)
{
    button.setDefaultAction(action);
    button.setObjectName(action->objectName() + QStringLiteral("Button"));
    button.setAccessibleName(QString(action->text()).remove(QLatin1Char('&')));
    button.setFocusPolicy(Qt::TabFocus);
    button.setAutoRaise(true);
}

}  // namespace

TimelineButton::TimelineButton(TimelineGlyph glyph, QAction* action, QWidget* parent)
    : QToolButton(parent), glyph_(glyph)
{
    setUpTimelineButton(*this, action);
}

QSize TimelineButton::sizeHint() const
{
    return {kButtonSide, kButtonSide};
}

bool TimelineButton::event(QEvent* event)
{
    return takesSpace(event) || QToolButton::event(event);
}

void TimelineButton::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    option.text.clear();
    option.icon = {};
    style()->drawComplexControl(QStyle::CC_ToolButton, &option, &painter, this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(QRectF(rect()).center());
    painter.scale(kGlyph, kGlyph);
    const QColor colour = palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::ButtonText);
    painter.fillPath(filledGlyph(glyph_, isChecked()), colour);
    constexpr double kLine = 0.15;
    painter.strokePath(drawnGlyph(glyph_), QPen(colour, kLine, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

LiveButton::LiveButton(QAction* action, QWidget* parent) : QToolButton(parent)
{
    setUpTimelineButton(*this, action);
    pulse_.setInterval(kBeatTime);
    connect(&pulse_, &QTimer::timeout, this, [this] {
        beat_ = (beat_ + 1) % kBeats;
        update();
    });
}

void LiveButton::setCalling(bool calls)
{
    if (calls == calls_)
        return;
    calls_ = calls;
    beat_ = 0;
    if (calls && !isMotionReduced())
        pulse_.start();
    else
        pulse_.stop();
    update();
}

QSize LiveButton::sizeHint() const
{
    constexpr int kPadding = 24;
    return {fontMetrics().horizontalAdvance(text()) + kPadding, kButtonSide};
}

bool LiveButton::event(QEvent* event)
{
    return takesSpace(event) || QToolButton::event(event);
}

void LiveButton::paintEvent(QPaintEvent* event)
{
    if (!calls_) {
        QToolButton::paintEvent(event);
        return;
    }
    const double share = 0.5 + 0.5 * std::cos(2.0 * std::numbers::pi * beat_ / kBeats);
    const auto mixed = [&](int strong, int weak) { return static_cast<int>(weak + share * (strong - weak)); };
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(mixed(kLiveStrong.red(), kLiveWeak.red()), mixed(kLiveStrong.green(), kLiveWeak.green()),
                            mixed(kLiveStrong.blue(), kLiveWeak.blue())));
    constexpr double kRound = 4.0;
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), kRound, kRound);
    painter.setPen(Qt::white);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.drawText(rect(), Qt::AlignCenter, text());
    if (hasFocus()) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

}  // namespace planewright
