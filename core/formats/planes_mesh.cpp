// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/planes_mesh.h"

#include <array>
#include <cstdint>
#include <map>
#include <ostream>
#include <vector>

#include "core/formats/little_endian.h"
#include "core/formats/number_text.h"
#include "core/formats/written.h"
#include "core/geometry/triangulate.h"

namespace planewright {

namespace {

/// The triangles of one plane over its own vertices, each of which is there once.
struct Mesh {
    PlaneId id = kNoPlane;
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<std::int32_t, 3>> triangles;
};

Mesh meshOf(const PlaneResult& result)
{
    Mesh mesh;
    mesh.id = result.plane->id;
    std::map<std::array<double, 3>, std::int32_t> places;
    for (const Triangle& triangle : triangulate(result.outline, result.plane->normal)) {
        std::array<std::int32_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3d& p = triangle[i];
            const auto [place, isNew] =
                places.try_emplace({p.x(), p.y(), p.z()}, static_cast<std::int32_t>(mesh.vertices.size()));
            if (isNew)
                mesh.vertices.push_back(p);
            corners[i] = place->second;
        }
        mesh.triangles.push_back(corners);
    }
    return mesh;
}

using Colour = std::array<std::uint8_t, 3>;

/// Paul Tol's muted colours and three of his others: told apart by the colour-blind too.
constexpr std::array<Colour, 12> kColours{{{0x88, 0xCC, 0xEE},
                                           {0xCC, 0x66, 0x77},
                                           {0xDD, 0xCC, 0x77},
                                           {0x11, 0x77, 0x33},
                                           {0x33, 0x22, 0x88},
                                           {0xAA, 0x44, 0x99},
                                           {0x44, 0xAA, 0x99},
                                           {0x99, 0x99, 0x33},
                                           {0x88, 0x22, 0x55},
                                           {0x44, 0x77, 0xAA},
                                           {0xEE, 0x88, 0x66},
                                           {0xBB, 0xBB, 0xBB}}};

Colour colourOf(PlaneId id)
{
    return kColours[static_cast<std::size_t>(id) % kColours.size()];
}

}  // namespace

Result<void> writePlanesPly(std::ostream& out, std::span<const PlaneResult> planes)
{
    std::string vertices;
    std::string faces;
    std::int32_t vertexCount = 0;
    std::size_t faceCount = 0;
    for (const PlaneResult& plane : planes) {
        const Mesh mesh = meshOf(plane);
        for (const Eigen::Vector3d& vertex : mesh.vertices) {
            for (const double coordinate : {vertex.x(), vertex.y(), vertex.z()})
                appendLittleEndian(vertices, coordinate);
            appendLittleEndian(vertices, std::int32_t{mesh.id});
        }
        for (const auto& triangle : mesh.triangles) {
            appendLittleEndian(faces, std::uint8_t{3});
            for (const std::int32_t corner : triangle)
                appendLittleEndian(faces, vertexCount + corner);
            for (const std::uint8_t channel : colourOf(mesh.id))
                appendLittleEndian(faces, channel);
            appendLittleEndian(faces, std::int32_t{mesh.id});
        }
        vertexCount += static_cast<std::int32_t>(mesh.vertices.size());
        faceCount += mesh.triangles.size();
    }
    out << "ply\nformat binary_little_endian 1.0\ncomment planes, metres, made by planewright\n";
    out << "element vertex " + std::to_string(vertexCount) +
               "\nproperty double x\nproperty double y\nproperty double z\nproperty int plane_id\n";
    out << "element face " + std::to_string(faceCount) +
               "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
               "property uchar blue\nproperty int plane_id\nend_header\n";
    out << vertices << faces;
    return written(out);
}

Result<void> writePlanesObj(std::ostream& out, std::span<const PlaneResult> planes)
{
    out << "# planes, metres, made by planewright\n";
    std::size_t before = 1;  // OBJ counts vertices from 1 through the whole file
    std::string text;
    for (const PlaneResult& plane : planes) {
        const Mesh mesh = meshOf(plane);
        text = "g plane_" + std::to_string(mesh.id) + "\n";
        for (const Eigen::Vector3d& vertex : mesh.vertices) {
            text += 'v';
            for (const double coordinate : {vertex.x(), vertex.y(), vertex.z()}) {
                text += ' ';
                appendNumber(text, coordinate);
            }
            text += '\n';
        }
        for (const auto& triangle : mesh.triangles) {
            text += 'f';
            for (const std::int32_t corner : triangle)
                text += " " + std::to_string(before + static_cast<std::size_t>(corner));
            text += '\n';
        }
        before += mesh.vertices.size();
        out << text;
    }
    return written(out);
}

}  // namespace planewright
