// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/view3d.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>

#include "ui/view3d/overlay_widget.h"

namespace planewright {

namespace {

constexpr int kRestMilliseconds = 200;  // until full detail after the last movement
constexpr int kHoverMilliseconds = 60;

}  // namespace

View3d::View3d(QWidget* parent)
    : QWidget(parent),
      glass_(new OverlayWidget(
          [this](QPainter& painter) {
              paintOverlay(painter, size(), scene_, overlay_);
              handles_.paint(painter, size(), scene_.camera(), scene_.theme());
          },
          this))
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
        fitUnasked();
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
    emit clipBoxChanged();
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

void View3d::setPlaced(const std::optional<PlacedShape>& shape)
{
    handles_.setShape(shape);
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
    setCamera(namedView(view, scene_.framing(), aspect(), scene_.camera()));
}

void View3d::fitAll()
{
    setCamera(fitted(scene_.camera(), scene_.framing(), aspect()));
    framed_ = false;
}

void View3d::fitSelection()
{
    const Eigen::AlignedBox3d box = scene_.selectedBounds();
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

void View3d::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (presenter_)
        presenter_->widget().setGeometry(rect());
    glass_->setGeometry(rect());
    if (!framed_ && height() > 0)
        fitUnasked();
}

void View3d::fitUnasked()
{
    scene_.setCamera(fitted(scene_.camera(), scene_.framing(), aspect()));
    emit cameraFitted();
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
    const QSize desktop = (QSizeF(size) / pixelRatio).toSize();
    paintOverlay(painter, desktop, scene_, content);
    handles_.paint(painter, desktop, scene_.camera(), scene_.theme());
    return image;
}

}  // namespace planewright
