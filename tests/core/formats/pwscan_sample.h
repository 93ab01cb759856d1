// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sqlite3.h>
#include <stdexcept>
#include <string>

#include "core/formats/pwscan_scan.h"
#include "core/types/angle.h"

/// A recording whose slice k of 0.25° beams from 0° on has pitch 10° + k, time 25 ms · k and ranges 1 m + k mm + beam
/// mm.
inline planewright::Recording sampleRecording(int slices, int beams)
{
    using namespace planewright;
    Recording recording;
    recording.description = {"UTM-30LX", 0.0, degrees(0.25), beams, 0.1, 30.0, 0.05, {}};
    for (int step = 0; step < slices; ++step) {
        ScanSlice slice;
        slice.step = step;
        slice.time = std::chrono::milliseconds{25 * step};
        slice.tilt = degrees(10.0 + step % 160);
        slice.bearingStep = recording.description.bearingStep;
        for (int beam = 0; beam < beams; ++beam)
            slice.ranges.push_back((1000 + step + beam) / 1000.0);
        recording.slices.push_back(slice);
    }
    return recording;
}

inline planewright::ScanRecord sampleScanRecord(int beams, const std::string& name = {})
{
    planewright::ScanRecord scan;
    scan.name = name;
    scan.startedUtc = "2026-03-01T08:30:00Z";
    scan.description = sampleRecording(0, beams).description;
    return scan;
}

/// Does to a database what its file's owner, or somebody who means harm, could do with any SQLite tool.
inline void runSql(const std::string& path, const std::string& sql)
{
    sqlite3* database = nullptr;
    sqlite3_open(path.c_str(), &database);
    char* message = nullptr;
    const int code = sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &message);
    const std::string problem = message != nullptr ? message : "";
    sqlite3_free(message);
    sqlite3_close(database);
    if (code != SQLITE_OK)
        throw std::runtime_error(sql + ": " + problem);
}
