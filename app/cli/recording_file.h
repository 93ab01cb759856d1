// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "app/files/recording_file.h"
#include "core/types/error.h"

namespace planewright {

/// Adds --scan, whose value stays negative where it is not given; and what it chooses.
void addScanOption(CLI::App& command, int& scan);
RecordingChoice chosenScan(int scan);

/// loadRecordingFile, whose warnings go to stderr.
Result<RecordingFile> readRecordingFile(const std::string& path, const RecordingChoice& choice = {});

}  // namespace planewright
