// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <vtk_glew.h>
// vtk_glew.h must come before whatever else includes OpenGL.

#include <vtkObjectFactory.h>

#include "tests/benchmarks/charts/offscreen_window.h"

namespace planewright {

vtkStandardNewMacro(OffscreenWindow);

OffscreenWindow::~OffscreenWindow()
{
    if (context_ && context_->makeCurrent())
        ReleaseGraphicsResources(this);
    Finalize();
}

bool OffscreenWindow::open(int width, int height)
{
    context_ = OsmesaContext::create();
    if (!context_ || !context_->makeCurrent())
        return false;
    SetOwnContext(1);
    SetFrameBlitModeToNoBlit();
    SetReadyForRendering(true);
    SetSize(width, height);
    SetMultiSamples(0);
    OpenGLInitContext();
    OpenGLInitState();
    return Initialized != 0;
}

void OffscreenWindow::MakeCurrent()
{
    if (context_)
        context_->makeCurrent();
}

void OffscreenWindow::OpenGLInitContext()
{
    if (Initialized != 0)
        return;
    // glewInit() loads all functions before it looks for GLX, which is not there.
    const GLenum result = glewInit();
    GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    Initialized = GlewInitValid && GLEW_VERSION_3_2 ? 1 : 0;
    MaximumHardwareLineWidth = 1.0F;
}

}  // namespace planewright
