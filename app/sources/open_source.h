// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/sources/known_scanner.h"
#include "core/formats/parameter_events.h"
#include "core/formats/pwscan_project.h"
#include "core/formats/recording_pwscan.h"
#include "devices/emulated/simulated_room.h"
#include "devices/nodding/scan_plan.h"
#include "devices/scan_source.h"
#include "devices/scip/scip_connect.h"
#include "devices/source_address.h"

namespace planewright {

/// What a file lacks that was opened all the same.
struct InputDamage {
    int slices = 0;                     ///< that are sound
    int slicesLeftOut = 0;              ///< as far as they can be counted
    std::vector<std::string> warnings;  ///< one line each, beginning with the file's name
};

/// A source that is ready, with what its file holds beside the slices.
struct OpenedSource {
    std::shared_ptr<ScanSource> source;
    std::optional<FittedPlan> plan;          ///< of devices: what the scan is going to take
    std::optional<KnownScanner> scanner;     ///< of devices: what they said of themselves when they were opened
    std::vector<std::string> warnings;       ///< one line each
    std::optional<InputDamage> damage;       ///< of a file; empty where it is sound
    std::vector<ParametersFrom> parameters;  ///< what a recording was extracted with; empty where it does not say
    std::optional<PwscanProject> project;    ///< of a `.pwscan`: where edits go
    int scan = 0;                            ///< its number in there
    std::vector<StoredEdit> edits;           ///< of this scan
    std::optional<ScanNotes> imported;       ///< of a cloud: its name and pose, which a recording of it is to keep
};

/// What a laser on a tilt unit is set up with.
struct NoddingSetup {
    std::string tiltUnit;        ///< its address; empty: none was given
    ScanPlan plan;               ///< of Table VIII where nobody says otherwise
    std::string dialogueFolder;  ///< where the dialogues with the devices are recorded; empty: nowhere
    ScipProgress progress;       ///< told what is waited for while a device starts up, in the thread that opens it
};

/// What sources are set up with, by kind.
struct SourceSetup {
    SimulatedScanner simulation;  ///< of `sim:`, but for the address's seed and speed
    NoddingSetup nodding;         ///< of a laser's address
};

/// Noise of simulated scanners where nobody says otherwise: `default`.
SimulationNoise defaultSimulationNoise();

/// Opens what an address names; files and devices may take seconds, a simulation takes none. A plain file is a replay
/// as fast as possible. Nothing moves before the source is begun.
///
/// A stop ends the reading of CSV and the waiting for devices soon, with an Interrupted error. Errors: Usage for an
/// unknown scene, which lists those known, a file of no known kind, a laser without a tilt unit and a plan that the
/// devices cannot carry out; Unreadable for a file, naming it; NoDevice.
Result<OpenedSource> openSource(const SourceAddress& address, const SourceSetup& setup, const Clock& clock,
                                const std::stop_token& stop);

}  // namespace planewright
