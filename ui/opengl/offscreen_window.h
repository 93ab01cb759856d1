// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <vtkSmartPointer.h>

#include "ui/opengl/any_gl_window.h"
#include "ui/opengl/offscreen_context.h"

namespace planewright {

/// A window of VTK without a display, over a context of its own.
class OffscreenWindow : public AnyGlWindow {
public:
    static OffscreenWindow* New();
    vtkTypeMacro(OffscreenWindow, AnyGlWindow);
    OffscreenWindow(const OffscreenWindow&) = delete;
    OffscreenWindow& operator=(const OffscreenWindow&) = delete;

    /// Opens a window of this size [pixels]. Errors: NoRenderer.
    static Result<vtkSmartPointer<OffscreenWindow>> open(OffscreenRenderer renderer, int width, int height);

    void MakeCurrent() override;
    bool IsCurrent() override;

protected:
    OffscreenWindow() = default;
    ~OffscreenWindow() override;

private:
    std::unique_ptr<OffscreenContext> context_;
};

}  // namespace planewright
