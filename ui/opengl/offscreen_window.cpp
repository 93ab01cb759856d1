// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/opengl/offscreen_window.h"

#include <utility>
#include <vtkObjectFactory.h>

namespace planewright {

vtkStandardNewMacro(OffscreenWindow);

Result<vtkSmartPointer<OffscreenWindow>> OffscreenWindow::open(OffscreenRenderer renderer, int width, int height)
{
    auto context = makeOffscreenContext(renderer);
    if (!context)
        return tl::unexpected{context.error()};
    auto window = vtkSmartPointer<OffscreenWindow>::New();
    window->context_ = std::move(*context);
    if (!window->context_->makeCurrent())
        return fail(ErrorCode::NoRenderer, "The OpenGL context without a display cannot be used.");
    window->SetOwnContext(1);
    window->SetFrameBlitModeToNoBlit();
    window->SetReadyForRendering(true);
    window->SetSize(width, height);
    window->SetMultiSamples(0);
    window->OpenGLInitContext();
    if (!window->isUsable())
        return fail(ErrorCode::NoRenderer, "The renderer without a display is older than OpenGL 3.2.");
    window->OpenGLInitState();
    return window;
}

OffscreenWindow::~OffscreenWindow()
{
    if (context_ && context_->makeCurrent())
        ReleaseGraphicsResources(this);
    Finalize();
}

void OffscreenWindow::MakeCurrent()
{
    if (context_)
        context_->makeCurrent();
}

bool OffscreenWindow::IsCurrent()
{
    return context_ && context_->isCurrent();
}

}  // namespace planewright
