// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "core/types/error.h"

namespace planewright {

/// Where an output goes.
struct OutputTarget {
    enum class Kind {
        New,        ///< nothing is there yet
        Existing,   ///< a regular file
        Direct,     ///< a pipe or character device, to be opened
        Descriptor  ///< a descriptor that is open already
    };
    Kind kind = Kind::New;
    std::string path;     ///< with symbolic links followed
    int descriptor = -1;  ///< of Kind::Descriptor
};

/// Follows symbolic links, also one to a file that is not there yet, and looks what stands at their end. Errors
/// (NotWritten, without the path): a folder, a block device or socket, links in a ring.
Result<OutputTarget> outputTargetOf(const std::string& path);

/// The folder part of a path, "." if it has none.
std::string folderOf(const std::string& path);

}  // namespace planewright
