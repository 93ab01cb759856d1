// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/planes_dxf.h"

#include <ostream>

#include "core/formats/dxf_text.h"
#include "core/formats/written.h"
#include "core/geometry/cut_outline.h"
#include "core/geometry/triangulate.h"

namespace planewright {

namespace {

std::vector<std::string> layersOf(std::span<const PlaneResult> planes)
{
    std::vector<std::string> layers;
    for (const PlaneResult& plane : planes)
        layers.push_back(layerName(plane.className));
    return layers;
}

Result<void> write(std::ostream& out, DxfText&& drawing)
{
    const std::string text = std::move(drawing).take();
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    return written(out);
}

}  // namespace

Result<void> writePlanesDxf(std::ostream& out, std::span<const PlaneResult> planes)
{
    DxfText drawing{layersOf(planes)};
    for (const PlaneResult& result : planes) {
        const std::string layer = layerName(result.className);
        for (const Triangle& triangle : triangulate(result.outline, result.plane->normal))
            drawing.face(layer, triangle);
        for (const Outline::Polygon& part : result.outline.parts) {
            drawing.closedPolyline(layer, part.ring);
            for (const auto& hole : part.holes)
                drawing.closedPolyline(layer, hole);
        }
    }
    return write(out, std::move(drawing));
}

std::optional<double> floorHeight(std::span<const PlaneResult> planes)
{
    const PlaneResult* largest = nullptr;
    for (const PlaneResult& plane : planes) {
        if (plane.className == "floor" && (largest == nullptr || plane.outline.area > largest->outline.area))
            largest = &plane;
    }
    if (largest == nullptr || largest->outline.parts.empty())
        return std::nullopt;
    return largest->outline.centroid.z();
}

Result<void> writeFloorPlanDxf(std::ostream& out, std::span<const PlaneResult> planes, double height)
{
    DxfText drawing{layersOf(planes)};
    for (const PlaneResult& result : planes) {
        for (const PlanLine& line : cutAtHeight(result.outline, result.plane->normal, height))
            drawing.line(layerName(result.className), line.from, line.to);
    }
    return write(out, std::move(drawing));
}

}  // namespace planewright
