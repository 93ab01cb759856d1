// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/geometry/outline.h"
#include "core/geometry/triangulate.h"

namespace planewright {

/// A plane's outline with the triangles that fill it.
struct FilledOutline {
    std::uint64_t revision = 0;  ///< of the plane that it is of
    Outline outline;
    std::vector<Triangle> triangles;
};

/// Works out a plane's outline: a tenth of a second for the largest planes, so no work for the thread of the window.
std::shared_ptr<const FilledOutline> filledOutlineOf(const Plane& plane, const SegmentLog& log);

}  // namespace planewright
