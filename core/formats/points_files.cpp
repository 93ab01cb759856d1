// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/points_files.h"

#include <cstdint>
#include <ostream>
#include <string>

#include "core/formats/little_endian.h"
#include "core/formats/written.h"
#include "core/geometry/sensor_model.h"

namespace planewright {

namespace {

constexpr std::size_t kPointBytes = 3 * sizeof(float) + 2 * sizeof(std::int32_t);

std::size_t countReturns(const Recording& recording)
{
    const SensorModel sensor = sensorOf(recording.description);
    std::size_t returns = 0;
    for (const ScanSlice& slice : recording.slices) {
        for (const double range : slice.ranges)
            returns += sensor.hasEcho(range) ? 1U : 0U;
    }
    return returns;
}

/// The points of both formats: x, y, z as floats, then label and step.
void writePoints(std::ostream& out, const Recording& recording, const Labels& labels)
{
    const SensorModel sensor = sensorOf(recording.description);
    std::string bytes;
    for (std::size_t i = 0; i < recording.slices.size(); ++i) {
        const ScanSlice& slice = recording.slices[i];
        bytes.clear();
        bytes.reserve(slice.ranges.size() * kPointBytes);
        for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam) {
            if (!sensor.hasEcho(slice.ranges[beam]))
                continue;
            const Eigen::Vector3d point =
                toCartesian(slice.ranges[beam], slice.bearing(beam), slice.tiltAt(beam), sensor);
            for (const double coordinate : {point.x(), point.y(), point.z()})
                appendLittleEndian(bytes, static_cast<float>(coordinate));
            appendLittleEndian(bytes, std::int32_t{labels[i][beam]});
            appendLittleEndian(bytes, std::int32_t{slice.step});
        }
        out << bytes;
    }
}

}  // namespace

Result<void> writePointsPly(std::ostream& out, const Recording& recording, const Labels& labels)
{
    out << "ply\nformat binary_little_endian 1.0\ncomment scan points, metres, made by planewright\n";
    out << "element vertex " + std::to_string(countReturns(recording)) +
               "\nproperty float x\nproperty float y\nproperty float z\nproperty int plane_id\nproperty int step\n"
               "end_header\n";
    writePoints(out, recording, labels);
    return written(out);
}

Result<void> writePointsPcd(std::ostream& out, const Recording& recording, const Labels& labels)
{
    const std::string count = std::to_string(countReturns(recording));
    out << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z label step\nSIZE 4 4 4 4 4\n"
           "TYPE F F F I I\nCOUNT 1 1 1 1 1\n";
    out << "WIDTH " + count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA binary\n";
    writePoints(out, recording, labels);
    return written(out);
}

}  // namespace planewright
