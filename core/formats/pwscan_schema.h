// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/formats/sqlite_database.h"

namespace planewright {

/// The version of `.pwscan` that this program writes. Newer ones are read as far as they hold what this one has.
inline constexpr int kPwscanVersion = 1;

/// Makes the tables of a recording in an empty database, and says whose file it is. For use within a transaction.
Result<void> createPwscanSchema(SqlDatabase& database);

/// Finds out before any use whether a database is a recording: its application id and version, and that every table is
/// a plain one with the columns it must have. Triggers, views, virtual tables and indexes that no recording has are
/// refused. Gives the version. Errors (Unreadable) begin with `path`.
Result<int> checkPwscanSchema(SqlDatabase& database, const std::string& path);

}  // namespace planewright
