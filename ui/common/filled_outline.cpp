// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/filled_outline.h"

namespace planewright {

std::shared_ptr<const FilledOutline> filledOutlineOf(const Plane& plane, const SegmentLog& log)
{
    auto filled = std::make_shared<FilledOutline>();
    filled->revision = plane.revision;
    filled->outline = outlineOf(plane, log);
    filled->triangles = triangulate(filled->outline, plane.normal);
    return filled;
}

}  // namespace planewright
