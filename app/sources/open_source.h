// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/formats/parameter_events.h"
#include "core/formats/pwscan_project.h"
#include "core/formats/recording_pwscan.h"
#include "devices/emulated/simulated_room.h"
#include "devices/scan_source.h"
#include "devices/source_address.h"

namespace planewright {

/// A source that is ready, with what its file holds beside the slices.
struct OpenedSource {
    std::shared_ptr<ScanSource> source;
    std::vector<std::string> warnings;       ///< one line each
    std::vector<ParametersFrom> parameters;  ///< what a recording was extracted with; empty where it does not say
    std::optional<PwscanProject> project;    ///< of a `.pwscan`: where edits go
    int scan = 0;                            ///< its number in there
    std::vector<StoredEdit> edits;           ///< of this scan
};

/// Noise of simulated scanners where nobody says otherwise: `default`.
SimulationNoise defaultSimulationNoise();

/// Opens what an address names; a file may take seconds, a simulation takes none. `simulation` is what a simulated
/// scanner is set up with, but for the address's seed and speed. A plain file is a replay as fast as possible.
///
/// A stop ends the reading of CSV soon, with an Interrupted error. Errors: Usage for an unknown scene, which lists
/// those known, and a file of no known kind; Unreadable for a file, naming it.
Result<OpenedSource> openSource(const SourceAddress& address, const SimulatedScanner& simulation, const Clock& clock,
                                const std::stop_token& stop);

}  // namespace planewright
