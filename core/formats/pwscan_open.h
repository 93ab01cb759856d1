// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/formats/sqlite_database.h"

namespace planewright {

/// Opens a recording for reading: one that is closed, one that somebody records into, one that a crash left with a
/// `-wal` beside it, and one on media that cannot be written. The caller has made sure that it is a regular file.
///
/// Nothing of the recording changes, except that what a crash left half done is finished where that cannot be read
/// otherwise. Errors (Unreadable) name the file.
Result<SqlDatabase> openPwscanForReading(const std::string& path);

}  // namespace planewright
