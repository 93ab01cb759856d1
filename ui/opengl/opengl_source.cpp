// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/opengl/opengl_source.h"

#include <GL/gl.h>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <string>

namespace planewright {

namespace {

#define PASS(result, name, parameters, arguments) k_##name,
enum Function : std::size_t {
#include "ui/opengl/opengl_functions.h"
    kFunctions
};
#undef PASS

#define PASS(result, name, parameters, arguments) #name,
constexpr std::array<const char*, kFunctions> kNames{
#include "ui/opengl/opengl_functions.h"
};
#undef PASS

constexpr const char* kOsmesaLibrary = "libOSMesa.so.8";

// Where the functions are; null until one is called. Looking one up twice gives the same, so threads need no order.
std::array<std::atomic<void*>, kFunctions> table{};
std::atomic<void*> osmesa{nullptr};

/// The next library's function of this name: the one that would have been called without ours.
void* systemFunction(const char* name)
{
    void* function = dlsym(RTLD_NEXT, name);
    if (function == nullptr) {
        // Nothing can be drawn or undone here, and no caller could go on without the function.
        std::fprintf(stderr, "planewright: the OpenGL library has no %s; install libgl1\n", name);
        std::abort();
    }
    return function;
}

void* functionAt(Function place)
{
    void* function = table[place].load(std::memory_order_relaxed);
    if (function == nullptr) {
        function = systemFunction(kNames[place]);
        table[place].store(function, std::memory_order_relaxed);
    }
    return function;
}

}  // namespace

OpenGlSource openGlSource()
{
    return osmesa.load() == nullptr ? OpenGlSource::System : OpenGlSource::Osmesa;
}

void* osmesaFunction(const char* name)
{
    void* library = osmesa.load();
    return library == nullptr ? nullptr : dlsym(library, name);
}

Result<void> useOsmesa()
{
    if (osmesa.load() != nullptr)
        return {};
    void* library = dlopen(kOsmesaLibrary, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        return fail(ErrorCode::NoRenderer, std::string{"Cannot load "} + kOsmesaLibrary +
                                               ": install the package libosmesa6, or choose another renderer.");
    std::array<void*, kFunctions> found{};
    for (std::size_t i = 0; i < kFunctions; ++i) {
        found[i] = dlsym(library, kNames[i]);
        if (found[i] == nullptr)
            return fail(ErrorCode::NoRenderer, std::string{kOsmesaLibrary} + " has no " + kNames[i] +
                                                   ": install Debian's libosmesa6, or choose another renderer.");
    }
    for (std::size_t i = 0; i < kFunctions; ++i)
        table[i].store(found[i]);
    osmesa.store(library);
    return {};
}

}  // namespace planewright

// Seen by VTK's libraries in place of those of the system: the program comes first where names are looked up.
#define PASS(result, name, parameters, arguments)                                                                \
    extern "C" __attribute__((visibility("default"))) result name parameters                                     \
    {                                                                                                            \
        return reinterpret_cast<result(*) parameters>(planewright::functionAt(planewright::k_##name)) arguments; \
    }
#include "ui/opengl/opengl_functions.h"
#undef PASS

extern "C" __attribute__((visibility("default"))) void (*glXGetProcAddressARB(const GLubyte* name))();
void (*glXGetProcAddressARB(const GLubyte* name))()
{
    using Finder = void (*(*)(const char*))();
    using SystemFinder = void (*(*)(const GLubyte*))();
    if (planewright::openGlSource() == planewright::OpenGlSource::Osmesa)
        return reinterpret_cast<Finder>(planewright::osmesaFunction("OSMesaGetProcAddress"))(
            reinterpret_cast<const char*>(name));
    return reinterpret_cast<SystemFinder>(planewright::systemFunction("glXGetProcAddressARB"))(name);
}
