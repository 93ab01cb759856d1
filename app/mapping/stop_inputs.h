// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/files/recording_file.h"
#include "app/mapping/map_results.h"
#include "core/formats/parameter_events.h"
#include "core/params/mapping_parameters.h"
#include "core/params/parameters.h"
#include "core/types/error.h"

namespace planewright {

/// A stop of a map before its planes are there.
struct StopInput {
    std::string path;
    RecordingChoice choice;        ///< its scan; without a number the file has just one
    std::string name;              ///< as people call it: file and scan
    int floor = 0;                 ///< of the building
    std::optional<Pose> odometry;  ///< where wheels tell it to be, in a frame of their own
};

/// Whether a file holds planes that an extraction has written, and no slices.
bool isPlanesResult(const std::string& path);

/// The stops of recordings (each scan of a `.pwscan`, a `.ptx` or a folder of clouds is one) and of planes as `.json`,
/// in their order. Errors: Usage for a file of another kind; Unreadable for one that cannot be opened.
Result<std::vector<StopInput>> stopInputs(const std::vector<std::string>& paths);

/// What a stop's scan is extracted with, step by step; one set at least.
using ChooseParameters =
    std::function<Result<std::vector<ParametersFrom>>(const RecordingFile& file, const std::string& path)>;

/// A stop with its planes.
struct ReadStop {
    StopScan scan;
    std::optional<Parameters> parameters;  ///< of its extraction; none of planes that came as they are
    bool damaged = false;                  ///< something had to be left out
    std::vector<std::string> warnings;     ///< of reading and of edits that could not be applied
};

/// Reads a stop and extracts its planes for a map, with the edits that its file holds unless `noEdits`. Errors:
/// Unreadable, naming the file; Interrupted after a stop; those of `chooseParameters`.
Result<ReadStop> readStop(const StopInput& input, const ChooseParameters& chooseParameters,
                          const MappingParameters& mapping = {}, bool noEdits = false,
                          const std::stop_token& stop = {});

}  // namespace planewright
