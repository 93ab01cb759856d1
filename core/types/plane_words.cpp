// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/plane_words.h"

namespace planewright {

std::string planeLabel(PlaneId id)
{
    return (id < 10 ? "P0" : "P") + std::to_string(id);
}

std::string planeState(const Plane& plane)
{
    switch (plane.lineage.kind) {
        case Lineage::Kind::Merged:
            return "merged";
        case Lineage::Kind::Split:
            return "split";
        case Lineage::Kind::Fitted:
            break;
    }
    return "live";
}

std::string lineageText(const Plane& plane)
{
    if (plane.lineage.parents.empty())
        return {};
    std::string text = planeLabel(plane.id);
    std::string_view before = "←";
    for (const PlaneId parent : plane.lineage.parents) {
        text += std::string{before} + planeLabel(parent);
        before = "+";
    }
    return text;
}

std::string segmentLabel(const SegmentId& id)
{
    return std::to_string(id.step + 1) + "." + std::to_string(id.index);
}

}  // namespace planewright
