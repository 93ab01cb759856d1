// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <array>
#include <dlfcn.h>

#include "ui/opengl/offscreen_context.h"

namespace planewright {

namespace {

constexpr const char* kInstall = "EGL gives no OpenGL 3.3 without a surface: install libegl1 and libgl1-mesa-dri.";

/// EGL's library is loaded only where it is asked for: most machines draw by another way.
template <class Function>
Function* egl(const char* name)
{
    static void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    return library == nullptr ? nullptr : reinterpret_cast<Function*>(dlsym(library, name));
}

class EglContext : public OffscreenContext {
public:
    EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
    ~EglContext() override
    {
        egl<decltype(eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl<decltype(eglDestroyContext)>("eglDestroyContext")(display_, context_);
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    bool makeCurrent() override
    {
        return egl<decltype(eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) ==
               EGL_TRUE;
    }

    bool isCurrent() const override
    {
        return egl<decltype(eglGetCurrentContext)>("eglGetCurrentContext")() == context_;
    }

private:
    EGLDisplay display_;
    EGLContext context_;
};

}  // namespace

Result<std::unique_ptr<OffscreenContext>> makeEglContext()
{
    const auto address = egl<decltype(eglGetProcAddress)>("eglGetProcAddress");
    if (address == nullptr)
        return fail(ErrorCode::NoRenderer, "Cannot load libEGL.so.1: install the package libegl1.");
    const auto displayOf = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(address("eglGetPlatformDisplayEXT"));
    EGLDisplay display =
        displayOf == nullptr ? EGL_NO_DISPLAY : displayOf(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY ||
        egl<decltype(eglInitialize)>("eglInitialize")(display, nullptr, nullptr) != EGL_TRUE ||
        egl<decltype(eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API) != EGL_TRUE)
        return fail(ErrorCode::NoRenderer, kInstall);

    constexpr std::array<EGLint, 5> kConfig{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                            EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (egl<decltype(eglChooseConfig)>("eglChooseConfig")(display, kConfig.data(), &config, 1, &configs) != EGL_TRUE ||
        configs == 0)
        return fail(ErrorCode::NoRenderer, kInstall);
    constexpr std::array<EGLint, 7> kContext{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLContext context =
        egl<decltype(eglCreateContext)>("eglCreateContext")(display, config, EGL_NO_CONTEXT, kContext.data());
    if (context == EGL_NO_CONTEXT)
        return fail(ErrorCode::NoRenderer, kInstall);
    return std::make_unique<EglContext>(display, context);
}

}  // namespace planewright
