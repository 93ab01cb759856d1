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
    : QOpenGLWidget(parent),
      scene_(scene),
      window_(vtkSmartPointer<AnyGlWindow>::New()),
      partwise_(scene, *window_),
      pointBudget_(pointBudget)
{
    // What is seen stays while the next picture is drawn part by part.
    setUpdateBehavior(QOpenGLWidget::PartialUpdate);
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
    const auto* name = reinterpret_cast<const char*>(context()->functions()->glGetString(GL_RENDERER));
    const QString renderer = QString::fromLatin1(name);
    isSlow_ = renderer.contains(QLatin1String("llvmpipe")) || renderer.contains(QLatin1String("softpipe"));
    drawn_ = {};
    useSamples();
}

void GlPresenter::requestPicture(Detail detail)
{
    detail_ = detail;
    partwise_.stop();
    isWhole_ = false;
    update();
}

void GlPresenter::setSmoothEdges(bool smooth)
{
    isSmooth_ = smooth;
    useSamples();
    requestPicture(Detail::Full);
}

/// Several samples a pixel would take two or three times as long in software.
void GlPresenter::useSamples()
{
    constexpr int kSamples = 4;
    window_->SetMultiSamples(isSmooth_ && !isSlow_ ? kSamples : 0);
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
    if (isWhole_ && size == drawn_)
        return;
    vtkOpenGLState* state = window_->GetState();
    state->Reset();
    state->Push();
    state->vtkglDepthFunc(GL_LEQUAL);  // Qt leaves GL_LESS
    draw(size);
    if (partwise_.isRunning())
        QMetaObject::invokeMethod(
            this, [this] { update(); }, Qt::QueuedConnection);
    else
        bindOutput();
    state->Reset();
    state->Pop();
}

/// Full detail of many points comes part by part where it would take long; until it is there the picture stays that of
/// before, or shows a part of the points.
void GlPresenter::draw(const QSize& size)
{
    if (partwise_.isRunning() && size == drawn_) {
        drawPart();
        return;
    }
    partwise_.stop();
    window_->SetSize(size.width(), size.height());
    scene_.setPixelRatio(devicePixelRatioF());
    scene_.setPointBudget(0);
    scene_.update();
    const bool inParts = isSlow_ && detail_ == Detail::Full && scene_.points().points() > 2 * pointBudget_;
    if (inParts && size == drawn_) {
        partwise_.begin(2 * pointBudget_);
        drawPart();
        return;
    }
    drawn_ = size;
    scene_.setPointBudget(detail_ == Detail::Moving || inParts ? pointBudget_ : 0);
    drawScene(scene_, *window_);
    if (inParts)
        QMetaObject::invokeMethod(
            this, [this] { update(); }, Qt::QueuedConnection);
}

void GlPresenter::drawPart()
{
    const bool last = partwise_.nextIsLast();
    if (!last)
        window_->SetFrameBlitModeToNoBlit();
    isWhole_ = partwise_.drawNext();
    window_->SetFrameBlitModeToBlitToCurrent();
}

QImage GlPresenter::picture(QSize size, double pixelRatio)
{
    if (!isValid() || !window_->isUsable())
        return {};
    makeCurrent();
    partwise_.stop();
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
