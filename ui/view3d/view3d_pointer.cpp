// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/view3d/overlay_widget.h"
#include "ui/view3d/pointer_tip.h"
#include "ui/view3d/view3d.h"

namespace planewright {

namespace {

constexpr double kClickPixels = 4.0;  // a press that moves less is a click
constexpr double kPickPixels = 6.0;
constexpr double kHandlePixels = 12.0;
constexpr double kZoomOfNotch = 1.2;

}  // namespace

Eigen::Vector2d View3d::inPicture(const QPointF& place) const
{
    const double h = std::max(1, height());
    return {(place.x() - width() / 2.0) / h, (height() / 2.0 - place.y()) / h};
}

Ray View3d::rayAt(const QPointF& place) const
{
    const Eigen::Vector2d at = inPicture(place);
    return rayThrough(scene_.camera(), at.x(), at.y());
}

/// What Passing::seen gives for so many pixels.
double View3d::tolerance(double pixels) const
{
    const ViewCamera& camera = scene_.camera();
    const double metres = camera.heightAtTarget() / std::max(1, height()) * pixels;
    return camera.parallel ? metres : metres / camera.distance;
}

std::optional<Picked> View3d::pickedAt(const QPointF& place) const
{
    return pick(scene_, rayAt(place), tolerance(kPickPixels));
}

void View3d::mousePressEvent(QMouseEvent* event)
{
    pressed_ = last_ = event->position();
    dragged_ = false;
    const bool pan = event->button() == Qt::MiddleButton ||
                     (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ShiftModifier));
    drag_ = pan ? Drag::Pan : event->button() == Qt::LeftButton ? Drag::Rotate : Drag::None;
    pivot_.reset();
    if (drag_ == Drag::Rotate &&
        handles_.take(scene_.camera(), inPicture(pressed_), kHandlePixels / std::max(1, height()))) {
        drag_ = Drag::Handle;
        emit handleTaken();
    } else if (drag_ == Drag::Rotate) {
        if (const auto picked = pickedAt(event->position()))
            pivot_ = picked->place;
    }
}

void View3d::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF moved = event->position() - last_;
    if (drag_ == Drag::None || event->buttons() == Qt::NoButton) {
        last_ = event->position();
        hoverTimer_.start();
        return;
    }
    if (!dragged_ && (event->position() - pressed_).manhattanLength() < kClickPixels)
        return;
    dragged_ = true;
    last_ = event->position();
    if (drag_ == Drag::Handle) {
        if (const auto motion = handles_.motionTo(rayAt(last_)))
            emit handleMoved(*motion);
        return;
    }
    const double right = moved.x() / std::max(1, height());
    const double down = moved.y() / std::max(1, height());
    if (drag_ == Drag::Pan)
        moveCamera(panned(scene_.camera(), right, down));
    else
        moveCamera(pivot_ ? rotatedAbout(scene_.camera(), *pivot_, right, down)
                          : rotated(scene_.camera(), right, down));
}

void View3d::mouseReleaseEvent(QMouseEvent* event)
{
    const bool click = drag_ == Drag::Rotate && !dragged_ && event->button() == Qt::LeftButton;
    drag_ = Drag::None;
    handles_.letGo();
    if (dragged_) {
        restTimer_.start();
        return;
    }
    if (!click)
        return;
    if (measuring_) {
        auto picked = pickPoint(scene_, rayAt(event->position()), tolerance(kPickPixels));
        const auto area = pickedAt(event->position());
        if (picked && area)
            picked->plane = area->plane;
        if (picked || area)
            emit pointPicked(picked ? *picked : *area);
        return;
    }
    emit clicked(pickedAt(event->position()), event->modifiers().testFlag(Qt::ControlModifier));
}

void View3d::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto picked = pickedAt(event->position()))
        setCamera(centredOn(scene_.camera(), picked->place));
}

void View3d::wheelEvent(QWheelEvent* event)
{
    const double notches = event->angleDelta().y() / 120.0;
    if (notches == 0.0)
        return;
    const Eigen::Vector2d at = inPicture(event->position());
    moveCamera(zoomed(scene_.camera(), std::pow(kZoomOfNotch, -notches), at.x(), at.y()));
    event->accept();
}

void View3d::hoverNow()
{
    const auto picked = pickedAt(last_);
    const PlaneId plane = picked ? picked->plane : kNoPlane;
    emit pointerMoved(picked ? std::optional{picked->place} : std::nullopt);
    overlay_.tip = picked ? pointerTip(*picked, scene_.map()) : QString();
    overlay_.tipPlace = last_.toPoint();
    if (plane != scene_.selection().hovered) {
        SceneSelection selection = scene_.selection();
        selection.hovered = plane;
        scene_.setSelection(selection);
        request(Detail::Full);
        emit hovered(plane);
    } else {
        glass_->update();
    }
}

void View3d::leaveEvent(QEvent* event)
{
    hoverTimer_.stop();
    overlay_.tip.clear();
    emit pointerMoved(std::nullopt);
    glass_->update();
    QWidget::leaveEvent(event);
}

}  // namespace planewright
