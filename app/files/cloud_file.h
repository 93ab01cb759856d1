// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/files/recording_file.h"
#include "core/types/error.h"

namespace planewright {

/// True for what is imported as points: a name that ends in one of kCloudSuffixes, and a folder whose name is not that
/// of a recording, which holds scans of 3DTK (scanNNN.3d).
bool isCloudFile(const std::string& path);

/// The numbers of the scans of a file or folder: of a .ptx from 0, of a folder those of its names, of any other file 0.
/// Errors (Unreadable): there is none, or it cannot be read.
Result<std::vector<int>> scansOfCloudFile(const std::string& path);

/// Imports a scan, without a number the last. Its notes have the name and the pose, its warnings what was recovered. A
/// scan of 3DTK has its pose in a file beside it (.pose); without one a warning says so. Errors: Usage for a scan that
/// is not there; Interrupted after a stop; Unreadable otherwise.
Result<RecordingFile> loadCloudFile(const std::string& path, std::optional<int> scan, const std::stop_token& stop);

}  // namespace planewright
