// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace planewright {

/// VTK's window over a context of someone else's, whatever made that context: GLX, EGL or OSMesa.
class AnyGlWindow : public vtkGenericOpenGLRenderWindow {
public:
    static AnyGlWindow* New();
    vtkTypeMacro(AnyGlWindow, vtkGenericOpenGLRenderWindow);
    AnyGlWindow(const AnyGlWindow&) = delete;
    AnyGlWindow& operator=(const AnyGlWindow&) = delete;

    /// Loads the OpenGL functions of the current context. VTK's own version takes GLEW's missing GLX for a failure.
    void OpenGLInitContext() override;

    /// True once OpenGLInitContext() has found OpenGL 3.2 or newer.
    bool isUsable() const { return Initialized; }

protected:
    AnyGlWindow() = default;
    ~AnyGlWindow() override = default;
};

}  // namespace planewright
