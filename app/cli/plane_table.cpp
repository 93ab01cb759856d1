// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/plane_table.h"

#include <vector>

#include "app/cli/text.h"
#include "core/types/angle_text.h"

namespace planewright {

std::string planeTable(std::span<const PlaneResult> planes)
{
    if (planes.empty())
        return "no planes\n";
    std::vector<std::vector<std::string>> rows{{"id", "nx", "ny", "nz", "d [m]", "segments", "points", "error",
                                                "rms [mm]", "area [m2]", "width x height [m]"}};
    for (const PlaneResult& result : planes) {
        const Plane& plane = *result.plane;
        rows.push_back({std::to_string(plane.id), fixedText(plane.normal.x(), 4), fixedText(plane.normal.y(), 4),
                        fixedText(plane.normal.z(), 4), fixedText(plane.distance, 3),
                        std::to_string(plane.segments.size()), std::to_string(plane.points),
                        fixedText(plane.fittingError, 2), fixedText(1000.0 * plane.rms, 1),
                        fixedText(result.outline.area, 2),
                        fixedText(result.outline.width, 2) + " x " + fixedText(result.outline.height, 2)});
    }
    return tableText(rows);
}

}  // namespace planewright
