// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/types/error.h"

struct sqlite3;
struct sqlite3_stmt;

namespace planewright {

/// Steps of SQLite's machine until a call is given up: a recording of the most slices needs a tenth.
inline constexpr std::int64_t kMostWork = 100'000'000;

/// What a connection and its statements share: the file and what a failure is to its caller, for messages, and how many
/// steps SQLite's machine may still take until the call is given up.
struct SqlContext {
    std::string path;
    ErrorCode code = ErrorCode::Unreadable;
    std::int64_t workLeft = 0;
};

/// A statement of a database, which must outlive it. Places of parameters count from 1, columns from 0.
class SqlStatement {
public:
    enum class Type { Null, Integer, Real, Text, Blob };

    SqlStatement(sqlite3_stmt* handle, std::shared_ptr<SqlContext> context);

    /// Binds the next parameters in their order; texts and blobs must live until the statement has run.
    SqlStatement& bind(std::int64_t value);
    SqlStatement& bind(double value);
    SqlStatement& bind(std::string_view text);
    SqlStatement& bindBlob(std::string_view bytes);
    SqlStatement& bindNull();
    SqlStatement& bind(const std::optional<double>& value) { return value ? bind(*value) : bindNull(); }
    SqlStatement& bind(const std::optional<std::int64_t>& value) { return value ? bind(*value) : bindNull(); }

    /// Goes to the next row; false after the last.
    Result<bool> step();
    /// Runs a statement that gives no row, and makes it ready to be bound again.
    Result<void> run();
    /// Makes it ready to be bound and run again.
    void reset();

    Type type(int column) const;
    bool isNull(int column) const { return type(column) == Type::Null; }
    std::int64_t integer(int column) const;
    double real(int column) const;
    /// Valid until the next step; empty where the value has another type.
    std::string_view text(int column) const;
    std::string_view blob(int column) const;
    /// The value where it has this type, which is not converted to another.
    std::optional<std::int64_t> integerIf(int column) const;
    std::optional<std::string> textIf(int column) const;

private:
    struct Finalizer {
        void operator()(sqlite3_stmt* statement) const;
    };

    std::unique_ptr<sqlite3_stmt, Finalizer> handle_;
    std::shared_ptr<SqlContext> context_;
    int nextParameter_ = 1;
};

/// A connection to an SQLite database that does not trust what it opens: no function, virtual table or view of the
/// file's schema runs, cells are checked, and values, statements and the work of reading have limits.
///
/// For use by one thread at a time. Errors have the code that its owner gave, name the file and say what to do.
class SqlDatabase {
public:
    enum class Access {
        Read,           ///< of a file that others may be writing
        ReadImmutable,  ///< of a file that nobody can write, on media that take no lock and no `-shm`
        Write,          ///< of a file that is there
        Create,         ///< the same, made where it is not there
    };

    static Result<SqlDatabase> open(const std::string& path, Access access, ErrorCode failure);
    /// A new database in memory; `name` is for messages.
    static Result<SqlDatabase> openInMemory(const std::string& name);

    /// Runs statements that give no rows of interest.
    Result<void> run(const char* sql);
    Result<SqlStatement> prepare(std::string_view sql);
    /// The number that a statement gives in its first row; nothing where it gives another type or no row.
    Result<std::optional<std::int64_t>> number(std::string_view sql);

    /// Does several things wholly or not at all.
    Result<void> inTransaction(const std::function<Result<void>()>& work);

    bool isReadOnly() const;  ///< as the file's permissions have it
    std::int64_t lastInsertedRow() const;
    std::int64_t changedRows() const;  ///< by the last statement
    bool fileHasMoved() const;         ///< its name belongs to no file, or to another
    /// The whole database as the bytes of its file. Empty where there is no memory for them.
    std::string bytes() const;

    /// What the last call failed with.
    bool needsWriting() const;  ///< it may not write, or not make a file beside
    bool failedBusy() const;
    bool failedByConstraint() const;
    bool failedByDamage() const;  ///< of what it read; something else may still be read
    /// The failure may pass with the same connection: a full disk, or a lock of another program.
    bool mayPass() const;

private:
    struct Closer {
        void operator()(sqlite3* database) const;
    };

    SqlDatabase(sqlite3* handle, std::shared_ptr<SqlContext> context);
    Result<void> defend();
    tl::unexpected<Error> failure() const;

    std::shared_ptr<SqlContext> context_;  // before the connection, which counts in it
    std::unique_ptr<sqlite3, Closer> handle_;
};

/// True where a file of this name, and with contents, is there.
bool fileExists(const std::string& path);

/// Removes a database that nobody has open, with the files that SQLite puts beside it. Fails with NotWritten where one
/// of them stays; those that are not there are none.
Result<void> removeDatabase(const std::string& path);

}  // namespace planewright
