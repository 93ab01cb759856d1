// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <string>

#include <CLI/CLI.hpp>

#include "app/sources/open_source.h"
#include "core/types/error.h"

namespace planewright {

/// What the command line says of how a scan is taken; empty, 0 and not a number: nothing.
struct ScanSetupOptions {
    static constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

    std::string tiltUnit;
    std::string tilt;
    std::string bearing;
    int slices = 0;
    int cluster = 0;
    bool stepAndStare = false;
    int settle = -1;                 ///< [ms]
    double travelSpeed = kNotGiven;  ///< [degrees/s]
    double axisOffset = kNotGiven;   ///< [m]
    std::string dialogueFolder;
};

/// Adds --tilt-unit, --tilt, --slices, --bearing, --cluster, --step-and-stare, --settle, --travel-speed, --axis-offset
/// and
/// --dialogues.
void addScanSetupOptions(CLI::App& command, ScanSetupOptions& options);

/// What sources are set up with. Errors (Usage): angles that are none, or an option that this kind of source has not.
Result<SourceSetup> sourceSetupOf(const ScanSetupOptions& options, SourceAddress::Kind kind);

}  // namespace planewright
