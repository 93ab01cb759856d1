// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "core/formats/recording_csv.h"
#include "core/types/error.h"

namespace planewright {

/// Reads a recording of a kind known by its suffix (kRecordingSuffixes); warnings go to stderr. Errors: Usage for
/// another suffix, Unreadable otherwise.
Result<ReadRecording> readRecordingFile(const std::string& path);

/// Finds out before any work whether all these names are of recordings. Errors: Usage.
Result<void> checkRecordingNames(const std::vector<std::string>& paths);

}  // namespace planewright
