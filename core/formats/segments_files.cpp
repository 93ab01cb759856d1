// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/segments_files.h"

#include <cstdint>
#include <ostream>
#include <string>

#include "core/formats/little_endian.h"
#include "core/formats/number_text.h"
#include "core/formats/segment_owners.h"
#include "core/formats/written.h"

namespace planewright {

namespace {

/// Calls visit(segment, plane, cluster) for every segment in order of step and index.
template <class Visitor>
void forEachSegment(const Snapshot& snapshot, Visitor visit)
{
    const SegmentOwners owners = segmentOwners(snapshot);
    for (std::size_t slice = 0; slice < snapshot.segments.slices(); ++slice) {
        const Segments& segments = snapshot.segments.slice(slice);
        for (std::size_t i = 0; i < segments.size(); ++i)
            visit(segments[i], owners.planes[slice][i], owners.clusters[slice][i]);
    }
}

}  // namespace

Result<void> writeSegmentsCsv(std::ostream& out, const Snapshot& snapshot)
{
    out << "step,segment,ux,uy,uz,vx,vy,vz,points,rms_m,cluster,plane\n";
    std::string row;
    forEachSegment(snapshot, [&](const LineSegment& segment, PlaneId plane, ClusterId cluster) {
        row = std::to_string(segment.id.step) + "," + std::to_string(segment.id.index);
        for (const Eigen::Vector3d& point : {segment.start, segment.end}) {
            for (const double coordinate : {point.x(), point.y(), point.z()}) {
                row += ',';
                appendNumber(row, coordinate);
            }
        }
        row += "," + std::to_string(segment.points) + ",";
        appendNumber(row, segment.rms);
        row += "," + std::to_string(cluster) + "," + std::to_string(plane) + "\n";
        out << row;
    });
    return written(out);
}

Result<void> writeSegmentsPly(std::ostream& out, const Snapshot& snapshot)
{
    std::string vertices;
    std::string edges;
    std::int32_t vertex = 0;
    forEachSegment(snapshot, [&](const LineSegment& segment, PlaneId plane, ClusterId) {
        for (const Eigen::Vector3d& point : {segment.start, segment.end}) {
            for (const double coordinate : {point.x(), point.y(), point.z()})
                appendLittleEndian(vertices, coordinate);
        }
        for (const std::int32_t value : {vertex, vertex + 1, std::int32_t{plane}})
            appendLittleEndian(edges, value);
        vertex += 2;
    });
    out << "ply\nformat binary_little_endian 1.0\ncomment line segments, metres, made by planewright\n";
    out << "element vertex " + std::to_string(vertex) + "\nproperty double x\nproperty double y\nproperty double z\n";
    out << "element edge " + std::to_string(vertex / 2) +
               "\nproperty int vertex1\nproperty int vertex2\nproperty int plane_id\nend_header\n";
    out << vertices << edges;
    return written(out);
}

}  // namespace planewright
