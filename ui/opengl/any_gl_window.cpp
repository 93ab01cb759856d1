// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <vtk_glew.h>
// vtk_glew.h must come before whatever else includes OpenGL.

#include <vtkObjectFactory.h>

#include "ui/opengl/any_gl_window.h"

namespace planewright {

vtkStandardNewMacro(AnyGlWindow);

void AnyGlWindow::OpenGLInitContext()
{
    if (Initialized)
        return;
    // glewInit() loads all functions before it looks for GLX, which EGL and OSMesa do without.
    const GLenum result = glewInit();
    GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    Initialized = GlewInitValid && GLEW_VERSION_3_2;
    MaximumHardwareLineWidth = 1.0F;
}

}  // namespace planewright
