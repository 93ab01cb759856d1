// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/image_presenter.h"

#include <QPainter>

namespace planewright {

ImagePresenter::ImagePresenter(MapScene& scene, vtkSmartPointer<OffscreenWindow> window, std::size_t pointBudget,
                               QWidget* parent)
    : QWidget(parent), scene_(scene), window_(std::move(window)), partwise_(scene, *window_), pointBudget_(pointBudget)
{
    window_->AddRenderer(scene_.renderer());
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    partTimer_.setInterval(0);
    connect(&partTimer_, &QTimer::timeout, this, &ImagePresenter::drawPart);
}

ImagePresenter::~ImagePresenter()
{
    window_->MakeCurrent();
    window_->RemoveRenderer(scene_.renderer());
}

QSize ImagePresenter::sizeInPixels() const
{
    const QSize size = (QSizeF(this->size()) * devicePixelRatioF()).toSize();
    return size.expandedTo({1, 1});
}

void ImagePresenter::requestPicture(Detail detail)
{
    partTimer_.stop();
    partwise_.stop();
    due_ = true;
    detail_ = detail;
    update();
}

/// Full detail of many points is left to the timer; until it is done the picture stays that of before, or shows a part
/// of the points.
void ImagePresenter::drawNow(Detail detail)
{
    const QSize size = sizeInPixels();
    window_->MakeCurrent();
    window_->SetSize(size.width(), size.height());
    scene_.setPixelRatio(devicePixelRatioF());
    scene_.setPointBudget(0);
    scene_.update();
    const bool inParts = scene_.points().points() > 2 * pointBudget_;
    if (detail == Detail::Full && inParts && image_.size() == size) {
        partwise_.begin(2 * pointBudget_);
        partTimer_.start();
        return;
    }
    scene_.setPointBudget(detail == Detail::Moving || inParts ? pointBudget_ : 0);
    drawScene(scene_, *window_);
    image_ = pictureOf(*window_);
    image_.setDevicePixelRatio(devicePixelRatioF());
    if (detail == Detail::Full && inParts) {
        due_ = true;
        QMetaObject::invokeMethod(
            this, [this] { update(); }, Qt::QueuedConnection);
    }
}

void ImagePresenter::drawPart()
{
    window_->MakeCurrent();
    if (!partwise_.drawNext())
        return;
    partTimer_.stop();
    image_ = pictureOf(*window_);
    image_.setDevicePixelRatio(devicePixelRatioF());
    update();
}

void ImagePresenter::paintEvent(QPaintEvent*)
{
    if (due_) {
        due_ = false;
        drawNow(detail_);
    }
    QPainter painter(this);
    painter.drawImage(QPoint(0, 0), image_);
}

void ImagePresenter::resizeEvent(QResizeEvent*)
{
    requestPicture(Detail::Full);
}

QImage ImagePresenter::picture(QSize size, double pixelRatio)
{
    partTimer_.stop();
    partwise_.stop();
    window_->MakeCurrent();
    window_->SetSize(size.width(), size.height());
    scene_.setPixelRatio(pixelRatio);
    scene_.setPointBudget(0);
    drawScene(scene_, *window_);
    QImage image = pictureOf(*window_);
    requestPicture(Detail::Full);
    return image;
}

QString ImagePresenter::rendererName() const
{
    return QString::fromLatin1(window_->ReportCapabilities()).section('\n', 0, 3);
}

}  // namespace planewright
