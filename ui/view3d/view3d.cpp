// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/view3d.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/view3d/overlay_widget.h"
#include "ui/view3d/pointer_tip.h"

namespace planewright {

namespace {

constexpr int kRestMilliseconds = 200;  // until full detail after the last movement
constexpr int kHoverMilliseconds = 60;
constexpr double kClickPixels = 4.0;  // a press that moves less is a click
constexpr double kPickPixels = 6.0;
constexpr double kZoomOfNotch = 1.2;

}  // namespace

View3d::View3d(QWidget* parent)
    : QWidget(parent),
      glass_(new OverlayWidget([this](QPainter& painter) { paintOverlay(painter, size(), scene_, overlay_); }, this))
{
    setObjectName(QStringLiteral("view3d"));
    setAccessibleName(tr("3D view"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(320, 240);
    restTimer_.setSingleShot(true);
    restTimer_.setInterval(kRestMilliseconds);
    connect(&restTimer_, &QTimer::timeout, this, [this] { request(Detail::Full); });
    hoverTimer_.setSingleShot(true);
    hoverTimer_.setInterval(kHoverMilliseconds);
    connect(&hoverTimer_, &QTimer::timeout, this, &View3d::hoverNow);
    connect(&walkKeys_, &WalkKeys::walked, this,
            [this](double right, double ahead, double up) { moveCamera(walked(scene_.camera(), right, ahead, up)); });
    scene_.setCamera(namedView(NamedView::Iso, {}, 1.6, {}));
}

View3d::~View3d() = default;

Result<void> View3d::present(const PresenterSettings& settings)
{
    auto made = makePresenter(scene_, settings, this);
    if (!made)
        return tl::unexpected{made.error()};
    presenter_ = std::move(*made);
    presented_ = settings;
    presenter_->widget().setGeometry(rect());
    presenter_->widget().lower();
    presenter_->widget().show();
    return {};
}

void View3d::request(Detail detail)
{
    if (presenter_)
        presenter_->requestPicture(detail);
    glass_->update();
}

void View3d::setPointBudget(std::size_t points)
{
    if (presenter_)
        presenter_->setPointBudget(points);
}

void View3d::setSmoothEdges(bool smooth)
{
    if (presenter_)
        presenter_->setSmoothEdges(smooth);
}

/// While slices arrive the view moves; full detail comes when it rests.
void View3d::setMap(std::shared_ptr<const ShownMap> map)
{
    const bool wasEmpty = scene_.bounds().isEmpty();
    scene_.setMap(std::move(map));
    if (scene_.bounds().isEmpty())
        framed_ = framed_ && !wasEmpty;
    else if (!framed_)
        scene_.setCamera(fitted(scene_.camera(), scene_.bounds(), aspect()));
    request(Detail::Moving);
    restTimer_.start();
}

void View3d::setLayers(const LayerSettings& settings)
{
    scene_.setLayers(settings);
    request(Detail::Full);
}

void View3d::setTheme(Theme theme)
{
    scene_.setTheme(theme);
    request(Detail::Full);
}

void View3d::setSelection(const SceneSelection& selection)
{
    SceneSelection with = selection;
    with.hovered = scene_.selection().hovered;
    scene_.setSelection(with);
    request(Detail::Full);
}

void View3d::setMeasurements(const std::vector<MeasuredLine>& lines)
{
    scene_.setMeasurements(lines);
    request(Detail::Full);
}

void View3d::setClipBox(const std::optional<Eigen::AlignedBox3d>& box)
{
    scene_.setClipBox(box);
    request(Detail::Full);
}

void View3d::setOverlay(const OverlayContent& content)
{
    const QString tip = overlay_.tip;
    const QPoint place = overlay_.tipPlace;
    const QSize corner = overlay_.corner;
    overlay_ = content;
    overlay_.tip = tip;
    overlay_.tipPlace = place;
    overlay_.corner = corner;
    glass_->update();
}

void View3d::keepCornerFree(QSize corner)
{
    overlay_.corner = corner;
    glass_->update();
}

void View3d::setCamera(const ViewCamera& camera)
{
    framed_ = true;
    scene_.setCamera(camera);
    request(Detail::Full);
    emit cameraChanged();
}

void View3d::moveCamera(const ViewCamera& camera)
{
    framed_ = true;
    scene_.setCamera(camera);
    request(Detail::Moving);
    restTimer_.start();
    emit cameraChanged();
}

double View3d::aspect() const
{
    return height() > 0 ? static_cast<double>(width()) / height() : 1.0;
}

void View3d::showNamed(NamedView view)
{
    setCamera(namedView(view, scene_.bounds(), aspect(), scene_.camera()));
}

void View3d::fitAll()
{
    setCamera(fitted(scene_.camera(), scene_.bounds(), aspect()));
    framed_ = false;
}

void View3d::fitSelection()
{
    Eigen::AlignedBox3d box;
    const ShownMap& map = scene_.map();
    for (const ShownPlane& plane : map.planes) {
        if (!scene_.selection().planes.contains(plane.plane->id) || !plane.outline)
            continue;
        for (const Outline::Polygon& part : plane.outline->outline.parts) {
            for (const Eigen::Vector3d& corner : part.ring)
                box.extend(corner);
        }
    }
    for (const SegmentId& id : scene_.selection().segments) {
        const std::size_t slice = map.snapshot ? map.snapshot->segments.find(id.step) : 0;
        if (!map.snapshot || slice >= map.snapshot->segments.slices())
            continue;
        box.extend(map.snapshot->segments[id].start);
        box.extend(map.snapshot->segments[id].end);
    }
    if (!box.isEmpty())
        setCamera(fitted(scene_.camera(), box, aspect()));
}

void View3d::setParallel(bool parallel)
{
    ViewCamera camera = scene_.camera();
    camera.parallel = parallel;
    setCamera(camera);
}

void View3d::setWalkMode(bool on)
{
    walking_ = on;
    walkKeys_.releaseAll();
}

void View3d::setMeasuring(bool on)
{
    measuring_ = on;
    setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
}

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

void View3d::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (presenter_)
        presenter_->widget().setGeometry(rect());
    glass_->setGeometry(rect());
    if (!framed_ && height() > 0)
        scene_.setCamera(fitted(scene_.camera(), scene_.bounds(), aspect()));
}

void View3d::mousePressEvent(QMouseEvent* event)
{
    pressed_ = last_ = event->position();
    dragged_ = false;
    const bool pan = event->button() == Qt::MiddleButton ||
                     (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ShiftModifier));
    drag_ = pan ? Drag::Pan : event->button() == Qt::LeftButton ? Drag::Rotate : Drag::None;
    pivot_.reset();
    if (drag_ == Drag::Rotate) {
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

void View3d::keyPressEvent(QKeyEvent* event)
{
    if (!walking_ || !walkKeys_.press(event->key()))
        QWidget::keyPressEvent(event);
}

void View3d::keyReleaseEvent(QKeyEvent* event)
{
    if (!event->isAutoRepeat())
        walkKeys_.release(event->key());
    QWidget::keyReleaseEvent(event);
}

void View3d::focusOutEvent(QFocusEvent* event)
{
    walkKeys_.releaseAll();
    QWidget::focusOutEvent(event);
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

QImage View3d::picture(QSize size, double pixelRatio)
{
    if (!presenter_)
        return {};
    QImage image = presenter_->picture(size, pixelRatio);
    if (image.isNull())
        return image;
    image.setDevicePixelRatio(pixelRatio);
    QPainter painter(&image);
    painter.setFont(font());
    OverlayContent content = overlay_;
    content.tip.clear();
    content.corner = {};
    paintOverlay(painter, (QSizeF(size) / pixelRatio).toSize(), scene_, content);
    return image;
}

}  // namespace planewright
