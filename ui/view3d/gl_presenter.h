// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vtkSmartPointer.h>

#include <QMetaObject>
#include <QOpenGLWidget>
#include <QTimer>

#include "ui/opengl/any_gl_window.h"
#include "ui/view3d/presenter.h"
#include "ui/view3d/scene_picture.h"

namespace planewright {

/// Shows a scene by OpenGL.
class GlPresenter : public QOpenGLWidget, public Presenter {
    Q_OBJECT

public:
    GlPresenter(MapScene& scene, std::size_t pointBudget, QWidget* parent);
    ~GlPresenter() override;

    QWidget& widget() override { return *this; }
    void requestPicture(Detail detail) override;
    void setPointBudget(std::size_t points) override { pointBudget_ = points; }
    void setSmoothEdges(bool smooth) override;
    QImage picture(QSize size, double pixelRatio) override;
    QString rendererName() const override;

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void cleanUp();
    QSize sizeInPixels() const;
    void bindOutput();
    void useSamples();
    void draw(const QSize& size);
    void drawPart();

    MapScene& scene_;
    vtkSmartPointer<AnyGlWindow> window_;
    PartwiseDrawing partwise_;
    std::size_t pointBudget_;
    Detail detail_ = Detail::Full;
    bool isSmooth_ = false;
    bool isSlow_ = false;   ///< OpenGL in software: full detail is drawn part by part
    bool isWhole_ = false;  ///< what was drawn part by part is what is to be seen
    QSize drawn_;           ///< size of the picture that is seen [pixels]
    QMetaObject::Connection contextGone_;
};

}  // namespace planewright
