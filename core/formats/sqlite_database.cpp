// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/sqlite_database.h"

#include <array>
#include <cassert>
#include <sqlite3.h>
#include <utility>

#include "core/formats/sqlite_message.h"

namespace planewright {

namespace {

/// Limits of what is read: values of a recording are far smaller, and statements are our own or the schema's.
constexpr std::array<std::pair<int, int>, 10> kLimits{{
    {SQLITE_LIMIT_LENGTH, 4 << 20},
    {SQLITE_LIMIT_SQL_LENGTH, 100'000},
    {SQLITE_LIMIT_COLUMN, 100},
    {SQLITE_LIMIT_EXPR_DEPTH, 100},
    {SQLITE_LIMIT_COMPOUND_SELECT, 5},
    {SQLITE_LIMIT_VDBE_OP, 25'000},
    {SQLITE_LIMIT_FUNCTION_ARG, 8},
    {SQLITE_LIMIT_ATTACHED, 0},
    {SQLITE_LIMIT_TRIGGER_DEPTH, 1},
    {SQLITE_LIMIT_WORKER_THREADS, 0},
}};

constexpr int kWorkCounted = 1000;  ///< steps between two looks

/// A lock of another program is waited for so long [ms].
constexpr int kLongestWait = 500;

int countWork(void* left)
{
    auto& work = *static_cast<std::int64_t*>(left);
    work -= kWorkCounted;
    return work < 0 ? 1 : 0;
}

/// A path as an URI, so that no name (`:memory:`, `file:…`) means anything else than a file.
std::string uriOf(const std::string& path)
{
    static constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789/._-";
    static constexpr std::string_view kHex = "0123456789ABCDEF";
    const std::size_t name = path.find_first_not_of('/');
    std::string uri = path.starts_with('/') ? "file:/" : "file:./";  // two slashes would begin a host
    for (const char c : path.substr(name == std::string::npos ? path.size() : name)) {
        if (kPlain.find(c) != std::string_view::npos) {
            uri += c;
            continue;
        }
        const auto byte = static_cast<unsigned char>(c);
        uri += {'%', kHex[byte >> 4], kHex[byte & 15]};
    }
    return uri;
}

int flagsOf(SqlDatabase::Access access)
{
    switch (access) {
        case SqlDatabase::Access::Create:
            return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
        case SqlDatabase::Access::Write:
            return SQLITE_OPEN_READWRITE;
        case SqlDatabase::Access::Read:
        case SqlDatabase::Access::ReadImmutable:
            break;
    }
    return SQLITE_OPEN_READONLY;
}

}  // namespace

void SqlDatabase::Closer::operator()(sqlite3* database) const
{
    sqlite3_close_v2(database);
}

SqlDatabase::SqlDatabase(sqlite3* handle, std::shared_ptr<SqlContext> context)
    : context_(std::move(context)), handle_(handle)
{
}

Result<SqlDatabase> SqlDatabase::open(const std::string& path, Access access, ErrorCode failure)
{
    std::string uri = uriOf(path);
    if (access == Access::ReadImmutable)
        uri += "?immutable=1";
    sqlite3* handle = nullptr;
    const int code =
        sqlite3_open_v2(uri.c_str(), &handle, flagsOf(access) | SQLITE_OPEN_URI | SQLITE_OPEN_EXRESCODE, nullptr);
    SqlDatabase database{handle, std::make_shared<SqlContext>(SqlContext{path, failure, kMostWork})};
    if (code != SQLITE_OK)
        return fail(failure, path + ": " + sqliteMessage(code));
    if (const auto defended = database.defend(); !defended)
        return tl::unexpected{defended.error()};
    return database;
}

Result<SqlDatabase> SqlDatabase::openInMemory(const std::string& name)
{
    sqlite3* handle = nullptr;
    const int code = sqlite3_open_v2(":memory:", &handle,
                                     SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_EXRESCODE, nullptr);
    SqlDatabase database{handle, std::make_shared<SqlContext>(SqlContext{name, ErrorCode::NotWritten, kMostWork})};
    if (code != SQLITE_OK)
        return fail(ErrorCode::NotWritten, name + ": " + sqliteMessage(code));
    if (const auto defended = database.defend(); !defended)
        return tl::unexpected{defended.error()};
    return database;
}

Result<void> SqlDatabase::defend()
{
    sqlite3* const db = handle_.get();
    sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
    for (const auto& [limit, most] : kLimits)
        sqlite3_limit(db, limit, most);
    sqlite3_busy_timeout(db, kLongestWait);
    sqlite3_progress_handler(db, kWorkCounted, countWork, &context_->workLeft);
    return run("PRAGMA cell_size_check=ON; PRAGMA mmap_size=0; PRAGMA temp_store=MEMORY");
}

tl::unexpected<Error> SqlDatabase::failure() const
{
    return fail(context_->code, context_->path + ": " + sqliteMessage(sqlite3_extended_errcode(handle_.get())));
}

Result<void> SqlDatabase::run(const char* sql)
{
    context_->workLeft = kMostWork;
    if (sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK)
        return failure();
    return {};
}

Result<SqlStatement> SqlDatabase::prepare(std::string_view sql)
{
    context_->workLeft = kMostWork;
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v2(handle_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    if (code != SQLITE_OK)
        return failure();
    return SqlStatement{statement, context_};
}

Result<std::optional<std::int64_t>> SqlDatabase::number(std::string_view sql)
{
    Result<SqlStatement> statement = prepare(sql);
    if (!statement)
        return tl::unexpected{statement.error()};
    const Result<bool> row = statement->step();
    if (!row)
        return tl::unexpected{row.error()};
    return *row ? statement->integerIf(0) : std::nullopt;
}

Result<void> SqlDatabase::inTransaction(const std::function<Result<void>()>& work)
{
    if (auto begun = run("BEGIN IMMEDIATE"); !begun)
        return begun;
    Result<void> done = work();
    if (done)
        done = run("COMMIT");
    // Some failures have rolled back already.
    if (!done && sqlite3_get_autocommit(handle_.get()) == 0)
        sqlite3_exec(handle_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    return done;
}

bool SqlDatabase::isReadOnly() const
{
    return sqlite3_db_readonly(handle_.get(), "main") != 0;
}

std::int64_t SqlDatabase::changedRows() const
{
    return sqlite3_changes64(handle_.get());
}

std::int64_t SqlDatabase::lastInsertedRow() const
{
    return sqlite3_last_insert_rowid(handle_.get());
}

std::string SqlDatabase::bytes() const
{
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> all{sqlite3_serialize(handle_.get(), "main", &size, 0),
                                                              sqlite3_free};
    if (!all)
        return {};
    return {reinterpret_cast<const char*>(all.get()), static_cast<std::size_t>(size)};
}

bool SqlDatabase::needsWriting() const
{
    const int code = sqlite3_errcode(handle_.get()) & 0xFF;
    return code == SQLITE_READONLY || code == SQLITE_CANTOPEN;
}

bool SqlDatabase::failedBusy() const
{
    const int code = sqlite3_errcode(handle_.get()) & 0xFF;
    return code == SQLITE_BUSY || code == SQLITE_LOCKED;
}

bool SqlDatabase::failedByConstraint() const
{
    return (sqlite3_errcode(handle_.get()) & 0xFF) == SQLITE_CONSTRAINT;
}

bool SqlDatabase::failedByDamage() const
{
    const int code = sqlite3_errcode(handle_.get()) & 0xFF;
    return code == SQLITE_CORRUPT || code == SQLITE_TOOBIG;
}

bool SqlDatabase::fileHasMoved() const
{
    int moved = 0;
    return sqlite3_file_control(handle_.get(), "main", SQLITE_FCNTL_HAS_MOVED, &moved) == SQLITE_OK && moved != 0;
}

bool SqlDatabase::mayPass() const
{
    return failedBusy() || (sqlite3_errcode(handle_.get()) & 0xFF) == SQLITE_FULL;
}

bool fileExists(const std::string& path)
{
    sqlite3_vfs* const files = sqlite3_vfs_find(nullptr);
    int there = 0;
    return files != nullptr && files->xAccess(files, path.c_str(), SQLITE_ACCESS_EXISTS, &there) == SQLITE_OK &&
           there != 0;
}

Result<void> removeDatabase(const std::string& path)
{
    sqlite3_vfs* const files = sqlite3_vfs_find(nullptr);
    for (const char* const ending : {"-wal", "-shm", ""}) {
        const int done = files == nullptr ? SQLITE_ERROR : files->xDelete(files, (path + ending).c_str(), 0);
        if (done != SQLITE_OK && done != SQLITE_IOERR_DELETE_NOENT)
            return fail(ErrorCode::NotWritten,
                        path + ": cannot be removed, though it holds nothing; remove it yourself");
    }
    return {};
}

}  // namespace planewright
