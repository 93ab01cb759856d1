// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <GL/osmesa.h>
#include <array>
#include <vector>

#include "ui/opengl/offscreen_context.h"
#include "ui/opengl/opengl_source.h"

namespace planewright {

namespace {

/// A context must have a buffer; nothing is drawn there.
constexpr int kBufferSize = 16;

template <class Function>
Function* osmesa(const char* name)
{
    return reinterpret_cast<Function*>(osmesaFunction(name));
}

class OsmesaContext : public OffscreenContext {
public:
    explicit OsmesaContext(OSMesaContext context) : context_(context) {}
    ~OsmesaContext() override { osmesa<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext")(context_); }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    bool makeCurrent() override
    {
        return osmesa<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent")(context_, buffer_.data(), GL_UNSIGNED_BYTE,
                                                                        kBufferSize, kBufferSize) != 0;
    }

    bool isCurrent() const override
    {
        return osmesa<decltype(OSMesaGetCurrentContext)>("OSMesaGetCurrentContext")() == context_;
    }

private:
    OSMesaContext context_;
    std::vector<unsigned char> buffer_ = std::vector<unsigned char>(4 * kBufferSize * kBufferSize);
};

}  // namespace

Result<std::unique_ptr<OffscreenContext>> makeOsmesaContext()
{
    if (auto source = useOsmesa(); !source)
        return tl::unexpected{source.error()};
    constexpr std::array<int, 13> kAttributes{OSMESA_FORMAT,
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
    const auto create = osmesa<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    OSMesaContext context = create == nullptr ? nullptr : create(kAttributes.data(), nullptr);
    if (context == nullptr)
        return fail(ErrorCode::NoRenderer, "OSMesa gives no OpenGL 3.3: install Debian's libosmesa6.");
    return std::make_unique<OsmesaContext>(context);
}

}  // namespace planewright
