// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/map_options.h"
#include "app/cli/output_files.h"
#include "app/mapping/map_edits.h"
#include "app/mapping/map_floors.h"
#include "app/mapping/stop_inputs.h"
#include "core/params/parameters.h"
#include "core/types/error.h"

namespace planewright {

/// All that a map is made from.
struct MapInput {
    std::vector<StopInput> inputs;
    std::vector<StopScan> stops;  ///< of these inputs
    std::vector<StopEdit> edits;  ///< those in force
    Parameters parameters;        ///< of the last extraction
    bool damaged = false;
};

/// The files that a map is written to: opened before the work, written once the map is there.
class MapOutputs {
public:
    explicit MapOutputs(const MapOptions& options);

    /// Errors: Usage for a file of another kind, or one that is an input; NotWritten.
    Result<void> open(std::span<const StopInput> inputs);

    bool empty() const { return files_.empty(); }

    /// Errors: NotWritten; what stood there before is then untouched.
    Result<void> write(const MapInput& input, std::span<const MappedFloor> floors);

private:
    struct Output {
        OutputFile* file;
        std::string_view suffix;
        int floor = 0;  ///< of a plan
    };

    Result<void> open(const std::string& path, std::span<const std::string_view> suffixes, std::string_view what,
                      std::vector<Output>& outputs, int floor = 0);
    Result<void> openPlans(std::span<const StopInput> inputs);
    Result<void> openProject();
    Result<void> write(const Output& plan, std::span<const MappedFloor> floors, std::span<const StopScan> stops) const;

    const MapOptions& options_;
    OutputFiles files_;
    std::vector<Output> planes_, plans_, project_;
    OutputFile* poses_ = nullptr;
};

}  // namespace planewright
