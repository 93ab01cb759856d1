// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "app/sources/open_source.h"
#include "core/types/error.h"

namespace planewright {

/// What the command line says of how a scan is taken; empty and 0: nothing.
struct ScanSetupOptions {
    std::string tiltUnit;
    std::string tilt;
    std::string bearing;
    int slices = 0;
    bool stepAndStare = false;
    int settle = -1;  ///< [ms]
    std::string dialogueFolder;
};

/// Adds --tilt-unit, --tilt, --slices, --bearing, --step-and-stare, --settle and --dialogues.
void addScanSetupOptions(CLI::App& command, ScanSetupOptions& options);

/// What sources are set up with. Errors (Usage): angles that are none, or an option that this kind of source has not.
Result<SourceSetup> sourceSetupOf(const ScanSetupOptions& options, SourceAddress::Kind kind);

}  // namespace planewright
