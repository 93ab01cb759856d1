// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/opengl/offscreen_window.h"
#include "ui/view3d/presenter.h"
#include "ui/view3d/scene_picture.h"

namespace planewright {

/// Shows a scene as an image that a window without a display draws.
class ImagePresenter : public QWidget, public Presenter {
    Q_OBJECT

public:
    ImagePresenter(MapScene& scene, vtkSmartPointer<OffscreenWindow> window, std::size_t pointBudget, QWidget* parent);
    ~ImagePresenter() override;

    QWidget& widget() override { return *this; }
    void requestPicture(Detail detail) override;
    void setPointBudget(std::size_t points) override { pointBudget_ = points; }
    void setSmoothEdges(bool) override {}
    QImage picture(QSize size, double pixelRatio) override;
    QString rendererName() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QSize sizeInPixels() const;
    void drawNow(Detail detail);
    void drawPart();

    MapScene& scene_;
    vtkSmartPointer<OffscreenWindow> window_;
    PartwiseDrawing partwise_;
    std::size_t pointBudget_;
    QImage image_;
    bool due_ = true;
    Detail detail_ = Detail::Full;
    QTimer partTimer_;
};

}  // namespace planewright
