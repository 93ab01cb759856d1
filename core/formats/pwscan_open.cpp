// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/pwscan_open.h"

namespace planewright {

namespace {

/// Reads the first page, which is when SQLite looks at what a crash has left.
Result<void> probe(SqlDatabase& database)
{
    const auto read = database.number("PRAGMA schema_version");
    if (!read)
        return tl::unexpected{read.error()};
    return {};
}

Result<SqlDatabase> openAndProbe(const std::string& path, SqlDatabase::Access access)
{
    auto database = SqlDatabase::open(path, access, ErrorCode::Unreadable);
    if (!database)
        return database;
    if (const auto probed = probe(*database); !probed)
        return tl::unexpected{probed.error()};
    return database;
}

}  // namespace

Result<SqlDatabase> openPwscanForReading(const std::string& path)
{
    if (!fileExists(path))
        return fail(ErrorCode::Unreadable, path + ": there is no such file, or it is empty; check its name and folder");
    auto database = SqlDatabase::open(path, SqlDatabase::Access::Read, ErrorCode::Unreadable);
    if (!database)
        return database;
    const auto probed = probe(*database);
    if (probed)
        return database;
    if (!database->needsWriting())
        return tl::unexpected{probed.error()};
    if (!fileExists(path + "-wal") && !fileExists(path + "-journal"))
        return openAndProbe(path, SqlDatabase::Access::ReadImmutable);
    auto finished = openAndProbe(path, SqlDatabase::Access::Write);
    if (!finished)
        return fail(ErrorCode::Unreadable, path +
                                               ": the recording was broken off, and what it left beside it (-wal) "
                                               "can only be read where it can be written; copy both files to a folder "
                                               "of your own");
    return finished;
}

}  // namespace planewright
