// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/opengl/offscreen_context.h"

#include "ui/opengl/opengl_source.h"

namespace planewright {

Result<std::unique_ptr<OffscreenContext>> makeOffscreenContext(OffscreenRenderer renderer)
{
    if (renderer == OffscreenRenderer::Egl)
        return makeEglContext();
    auto osmesa = makeOsmesaContext();
    if (osmesa || renderer == OffscreenRenderer::Osmesa || openGlSource() == OpenGlSource::Osmesa)
        return osmesa;
    auto egl = makeEglContext();
    if (egl)
        return egl;
    return fail(ErrorCode::NoRenderer,
                "Nothing here can draw without a display. " + osmesa.error().message + " " + egl.error().message);
}

}  // namespace planewright
