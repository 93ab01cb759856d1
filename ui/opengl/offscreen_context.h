// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "core/types/error.h"

namespace planewright {

/// An OpenGL context that needs no display. It has no picture of its own worth reading: VTK draws into its frame
/// buffers.
class OffscreenContext {
public:
    virtual ~OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    virtual bool makeCurrent() = 0;
    virtual bool isCurrent() const = 0;

protected:
    OffscreenContext() = default;
};

/// What draws without a display.
enum class OffscreenRenderer { Auto, Osmesa, Egl };

/// Makes a context. Auto tries OSMesa, then EGL without a surface. Errors (NoRenderer) name what was tried and what to
/// install.
Result<std::unique_ptr<OffscreenContext>> makeOffscreenContext(OffscreenRenderer renderer);

Result<std::unique_ptr<OffscreenContext>> makeOsmesaContext();
Result<std::unique_ptr<OffscreenContext>> makeEglContext();

}  // namespace planewright
