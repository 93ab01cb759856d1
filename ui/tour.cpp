// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/tour.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace planewright {

namespace {

constexpr int kWidth = 280;  // [px]
constexpr int kGap = 8;      // between call-out and what it points at [px]

/// Where a call-out has room beside a rectangle, inside another; at the foot of a rectangle that is much larger, and on
/// one beside which there is no room.
QPoint besideOf(const QRect& target, const QSize& size, const QRect& room)
{
    if (target.width() > 2 * size.width() && target.height() > 2 * size.height())
        return {target.center().x() - size.width() / 2, target.bottom() - size.height() - 4 * kGap};
    const int y = std::clamp(target.center().y() - size.height() / 2, room.top() + kGap,
                             std::max(room.top() + kGap, room.bottom() - size.height() - kGap));
    const int x = std::clamp(target.center().x() - size.width() / 2, room.left() + kGap,
                             std::max(room.left() + kGap, room.right() - size.width() - kGap));
    for (const QPoint& place : {QPoint(target.left() - size.width() - kGap, y), QPoint(target.right() + kGap, y),
                                QPoint(x, target.bottom() + kGap), QPoint(x, target.top() - size.height() - kGap)}) {
        if (room.contains(QRect(place, size)))
            return place;
    }
    return {x, y};
}

}  // namespace

Tour::Tour(QWidget* window)
    : QFrame(window),
      text_(new QLabel(this)),
      count_(new QLabel(this)),
      next_(new QPushButton(this)),
      ring_(new QFrame(window))
{
    setObjectName(QStringLiteral("tour"));
    setAccessibleName(tr("Quick tour"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setFixedWidth(kWidth);
    // White on this is 7.2:1.
    setStyleSheet(QStringLiteral("#tour { background: #1f4e8c; border-radius: 6px; } #tour QLabel { color: white; }"));
    ring_->setObjectName(QStringLiteral("tourRing"));
    ring_->setStyleSheet(QStringLiteral("#tourRing { border: 3px solid #1f4e8c; border-radius: 4px; }"));
    ring_->setAttribute(Qt::WA_TransparentForMouseEvents);
    ring_->hide();
    text_->setObjectName(QStringLiteral("tourText"));
    text_->setWordWrap(true);
    next_->setObjectName(QStringLiteral("tourNext"));
    auto* close = new QPushButton(tr("End"), this);
    close->setObjectName(QStringLiteral("tourEnd"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(count_, 1);
    buttons->addWidget(close);
    buttons->addWidget(next_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->addWidget(text_);
    layout->addLayout(buttons);
    connect(next_, &QPushButton::clicked, this, [this] {
        ++current_;
        goOn();
    });
    connect(close, &QPushButton::clicked, this, &Tour::end);
    hide();
}

void Tour::start(std::vector<Stop> stops)
{
    stops_ = std::move(stops);
    current_ = 0;
    window()->installEventFilter(this);
    goOn();
}

void Tour::end()
{
    current_ = stops_.size();
    window()->removeEventFilter(this);
    ring_->hide();
    hide();
}

void Tour::goOn()
{
    while (current_ < stops_.size() && (stops_[current_].target == nullptr || !stops_[current_].target->isVisible()))
        ++current_;
    if (current_ >= stops_.size()) {
        end();
        return;
    }
    text_->setText(stops_[current_].text);
    count_->setText(tr("%1 of %2").arg(current_ + 1).arg(stops_.size()));
    next_->setText(current_ + 1 < stops_.size() ? tr("Next") : tr("Done"));
    show();
    place();
    next_->setFocus();
}

void Tour::place()
{
    QWidget* target = current_ < stops_.size() ? stops_[current_].target.data() : nullptr;
    if (target == nullptr)
        return;
    const QRect there(target->mapTo(window(), QPoint(0, 0)), target->size());
    resize(kWidth, layout()->heightForWidth(kWidth));
    move(besideOf(there, size(), window()->rect()));
    ring_->setGeometry(there);
    ring_->show();
    ring_->raise();
    raise();
}

bool Tour::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
        QMetaObject::invokeMethod(this, &Tour::place, Qt::QueuedConnection);
    return QFrame::eventFilter(watched, event);
}

void Tour::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        end();
    else
        QFrame::keyPressEvent(event);
}

}  // namespace planewright
