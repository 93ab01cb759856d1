// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/gl_presenter.h"

#include <vtkCallbackCommand.h>
#include <vtkOpenGLState.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

namespace planewright {

GlPresenter::GlPresenter(MapScene& scene, std::size_t pointBudget, QWidget* parent)
    : QOpenGLWidget(parent), scene_(scene), window_(vtkSmartPointer<AnyGlWindow>::New()), pointBudget_(pointBudget)
{
    QSurfaceFormat wanted = QSurfaceFormat::defaultFormat();
    wanted.setRenderableType(QSurfaceFormat::OpenGL);
    wanted.setVersion(3, 2);
    wanted.setProfile(QSurfaceFormat::CoreProfile);
    wanted.setDepthBufferSize(24);
    setFormat(wanted);
    setAttribute(Qt::WA_TransparentForMouseEvents);

    window_->SetReadyForRendering(false);
    window_->SetOwnContext(0);
    window_->SetMultiSamples(0);
    window_->SetFrameBlitModeToBlitToCurrent();
    window_->AddRenderer(scene_.renderer());
    struct Calls {
        static void makeCurrent(vtkObject*, unsigned long, void* self, void*)
        {
            // Qt's makeCurrent also binds its own frame buffer, which VTK must not lose hold of while it draws.
            auto* presenter = static_cast<GlPresenter*>(self);
            if (presenter->isValid() && QOpenGLContext::currentContext() != presenter->context())
                presenter->makeCurrent();
        }
        static void isCurrent(vtkObject*, unsigned long, void* self, void* answer)
        {
            auto* presenter = static_cast<GlPresenter*>(self);
            *static_cast<bool*>(answer) =
                presenter->context() != nullptr && QOpenGLContext::currentContext() == presenter->context();
        }
        static void supportsOpenGl(vtkObject*, unsigned long, void*, void* answer) { *static_cast<int*>(answer) = 1; }
    };
    const auto observe = [this](unsigned long event, void (*call)(vtkObject*, unsigned long, void*, void*)) {
        vtkNew<vtkCallbackCommand> command;
        command->SetCallback(call);
        command->SetClientData(this);
        window_->AddObserver(event, command);
    };
    observe(vtkCommand::WindowMakeCurrentEvent, &Calls::makeCurrent);
    observe(vtkCommand::WindowIsCurrentEvent, &Calls::isCurrent);
    observe(vtkCommand::WindowSupportsOpenGLEvent, &Calls::supportsOpenGl);
}

/// The base class destroys the context, and its signal must not find an object that is half gone.
GlPresenter::~GlPresenter()
{
    disconnect(contextGone_);
    if (isValid()) {
        makeCurrent();
        cleanUp();
        doneCurrent();
    }
    window_->RemoveRenderer(scene_.renderer());
}

void GlPresenter::cleanUp()
{
    window_->Finalize();
    window_->SetReadyForRendering(false);
}

QSize GlPresenter::sizeInPixels() const
{
    return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

/// Called again where the widget gets another context.
void GlPresenter::initializeGL()
{
    contextGone_ = connect(
        context(), &QOpenGLContext::aboutToBeDestroyed, this,
        [this] {
            makeCurrent();
            cleanUp();
            doneCurrent();
        },
        Qt::DirectConnection);
    window_->SetReadyForRendering(true);
    window_->SetForceMaximumHardwareLineWidth(1);
    window_->OpenGLInitContext();
}

void GlPresenter::requestPicture(Detail detail)
{
    detail_ = detail;
    update();
}

void GlPresenter::setSmoothEdges(bool smooth)
{
    constexpr int kSamples = 4;
    window_->SetMultiSamples(smooth ? kSamples : 0);
    update();
}

/// Puts what VTK drew where Qt shows it, opaque.
void GlPresenter::bindOutput()
{
    makeCurrent();
    QOpenGLFunctions* gl = context()->functions();
    gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void GlPresenter::paintGL()
{
    if (!window_->isUsable())
        return;
    const QSize size = sizeInPixels();
    vtkOpenGLState* state = window_->GetState();
    state->Reset();
    state->Push();
    state->vtkglDepthFunc(GL_LEQUAL);  // Qt leaves GL_LESS
    window_->SetSize(size.width(), size.height());
    scene_.setPixelRatio(devicePixelRatioF());
    scene_.setPointBudget(detail_ == Detail::Moving ? pointBudget_ : 0);
    drawScene(scene_, *window_);
    bindOutput();
    state->Reset();
    state->Pop();
}

QImage GlPresenter::picture(QSize size, double pixelRatio)
{
    if (!isValid() || !window_->isUsable())
        return {};
    makeCurrent();
    vtkOpenGLState* state = window_->GetState();
    state->Reset();
    state->Push();
    state->vtkglDepthFunc(GL_LEQUAL);
    window_->SetFrameBlitModeToNoBlit();
    window_->SetSize(size.width(), size.height());
    scene_.setPixelRatio(pixelRatio);
    scene_.setPointBudget(0);
    drawScene(scene_, *window_);
    QImage image = pictureOf(*window_);
    window_->SetFrameBlitModeToBlitToCurrent();
    state->Reset();
    state->Pop();
    doneCurrent();
    requestPicture(Detail::Full);
    return image;
}

QString GlPresenter::rendererName() const
{
    return QString::fromLatin1(window_->ReportCapabilities()).section('\n', 0, 3);
}

}  // namespace planewright
