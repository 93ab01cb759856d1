// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

namespace planewright {

/// An OpenGL 3.3 context of OSMesa: it draws in memory and needs no display.
///
/// A program that has one has no other: it links OSMesa before VTK, so that all OpenGL functions are OSMesa's, and
/// osmesa_context.cpp answers for glXGetProcAddressARB, which VTK's loader asks for the rest.
class OsmesaContext {
public:
    /// Empty where OSMesa cannot make a context.
    static std::unique_ptr<OsmesaContext> create();
    ~OsmesaContext();
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    bool makeCurrent();

private:
    OsmesaContext() = default;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace planewright
