// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/session/loops/slice_recorder.h"
#include "app/sources/open_source.h"

namespace planewright {

/// What a session is set up with.
struct SessionOptions {
    /// Parameters for what is opened, step by step, one set at least: by the scanner's name and what the file says it
    /// was extracted with. Without it: what the file says, or else the default preset with the scanner's noise.
    std::function<Result<std::vector<ParametersFrom>>(const std::string& scanner, std::vector<ParametersFrom> stored)>
        chooseParameters;
    /// Where scans are recorded, as `.pwscan` files named by the time; empty: they are not.
    std::string recordFolder;
    bool explain = true;                                                ///< snapshots tell every decision
    SimulatedScanner simulation{{}, defaultSimulationNoise(), 1, 1.0};  ///< what `sim:` is set up with; its own seed
    NoddingSetup nodding;                                               ///< what a laser is set up with
    std::chrono::milliseconds frame{16};                                ///< mapChanged comes at most once in this time
    std::chrono::milliseconds statusEvery{250};                         ///< while something runs
    const Clock* clock = nullptr;  ///< of sources and loops; null: the machine's. A test brings its own.
    /// Makes the recorder of a path; without it a PwscanRecorder. A test brings one that fails.
    std::function<std::unique_ptr<SliceRecorder>(const std::string& path)> makeRecorder;
};

}  // namespace planewright
