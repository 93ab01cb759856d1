// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/charts/osmesa_context.h"

#include <GL/osmesa.h>
#include <array>
#include <vector>

extern "C" __attribute__((visibility("default"))) void (*glXGetProcAddressARB(const unsigned char* name))();
void (*glXGetProcAddressARB(const unsigned char* name))()
{
    return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
}

namespace planewright {

namespace {

/// VTK draws into a frame buffer of its own; this one is only there because a context has to have one.
constexpr int kBufferSize = 16;

}  // namespace

struct OsmesaContext::State {
    OSMesaContext context = nullptr;
    std::vector<unsigned char> buffer = std::vector<unsigned char>(4 * kBufferSize * kBufferSize);
};

std::unique_ptr<OsmesaContext> OsmesaContext::create()
{
    constexpr std::array<int, 15> kAttributes{OSMESA_FORMAT,
                                              OSMESA_RGBA,
                                              OSMESA_DEPTH_BITS,
                                              24,
                                              OSMESA_STENCIL_BITS,
                                              8,
                                              OSMESA_PROFILE,
                                              OSMESA_CORE_PROFILE,
                                              OSMESA_CONTEXT_MAJOR_VERSION,
                                              3,
                                              OSMESA_CONTEXT_MINOR_VERSION,
                                              3,
                                              0};
    std::unique_ptr<OsmesaContext> context(new OsmesaContext);
    context->state_ = std::make_unique<State>();
    context->state_->context = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
    if (context->state_->context == nullptr)
        return nullptr;
    return context;
}

OsmesaContext::~OsmesaContext()
{
    if (state_ && state_->context != nullptr)
        OSMesaDestroyContext(state_->context);
}

bool OsmesaContext::makeCurrent()
{
    return OSMesaMakeCurrent(state_->context, state_->buffer.data(), GL_UNSIGNED_BYTE, kBufferSize, kBufferSize) != 0;
}

}  // namespace planewright
