// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/problem_list.h"
#include "core/geometry/pose.h"
#include "core/types/error.h"
#include "core/types/recording.h"

namespace planewright {

/// What became of a scan. One that is running where nobody records was broken off, and its slices are all there.
enum class ScanState { Running, Complete, Partial, Fault };
std::string_view name(ScanState state);

/// One scan of a `.pwscan`, without its slices.
struct ScanRecord {
    int id = 0;  ///< from 1, given by the file
    std::string name;
    int floor = 0;           ///< of the building
    std::string startedUtc;  ///< ISO 8601; empty where it is not known
    ScanState state = ScanState::Running;
    ScanDescription description;
    std::optional<int> plannedSlices;
    std::optional<Pose> pose;  ///< by odometry, in a frame of its own
};

/// Most scans, and most events and edits, that are read from one file.
inline constexpr int kMaxScans = 10'000;
inline constexpr int kMaxScanNotes = 1'000'000;

class SqlDatabase;

/// Adds a scan and gives its id; the record's own is not used.
Result<int> insertScan(SqlDatabase& database, const ScanRecord& scan);

/// The scans of a file in order of id. One that cannot be used is left out, and why goes to `problems`.
Result<std::vector<ScanRecord>> readScans(SqlDatabase& database, ProblemList& problems);

}  // namespace planewright
