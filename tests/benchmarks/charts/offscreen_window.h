// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vtkGenericOpenGLRenderWindow.h>

#include "tests/benchmarks/charts/osmesa_context.h"

namespace planewright {

/// A VTK render window without a display; read its pixels with GetPixelData().
class OffscreenWindow : public vtkGenericOpenGLRenderWindow {
public:
    static OffscreenWindow* New();
    vtkTypeMacro(OffscreenWindow, vtkGenericOpenGLRenderWindow);

    OffscreenWindow(const OffscreenWindow&) = delete;
    OffscreenWindow& operator=(const OffscreenWindow&) = delete;

    /// Makes the context and loads the OpenGL functions. False where that fails.
    bool open(int width, int height);

    void OpenGLInitContext() override;
    void MakeCurrent() override;
    bool IsCurrent() override { return context_ != nullptr; }
    int SupportsOpenGL() override { return 1; }

protected:
    OffscreenWindow() = default;
    ~OffscreenWindow() override;

private:
    std::unique_ptr<OsmesaContext> context_;
};

}  // namespace planewright
