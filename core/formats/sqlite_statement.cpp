// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <sqlite3.h>
#include <utility>

#include "core/formats/sqlite_database.h"
#include "core/formats/sqlite_message.h"

namespace planewright {

void SqlStatement::Finalizer::operator()(sqlite3_stmt* statement) const
{
    sqlite3_finalize(statement);
}

SqlStatement::SqlStatement(sqlite3_stmt* handle, std::shared_ptr<SqlContext> context)
    : handle_(handle), context_(std::move(context))
{
}

SqlStatement& SqlStatement::bind(std::int64_t value)
{
    sqlite3_bind_int64(handle_.get(), nextParameter_++, value);
    return *this;
}

SqlStatement& SqlStatement::bind(double value)
{
    sqlite3_bind_double(handle_.get(), nextParameter_++, value);
    return *this;
}

SqlStatement& SqlStatement::bind(std::string_view text)
{
    // An empty view may have no address, which SQLite would take for NULL.
    sqlite3_bind_text64(handle_.get(), nextParameter_++, text.empty() ? "" : text.data(), text.size(), SQLITE_STATIC,
                        SQLITE_UTF8);
    return *this;
}

SqlStatement& SqlStatement::bindBlob(std::string_view bytes)
{
    sqlite3_bind_blob64(handle_.get(), nextParameter_++, bytes.empty() ? "" : bytes.data(), bytes.size(),
                        SQLITE_STATIC);
    return *this;
}

SqlStatement& SqlStatement::bindNull()
{
    sqlite3_bind_null(handle_.get(), nextParameter_++);
    return *this;
}

Result<bool> SqlStatement::step()
{
    const int code = sqlite3_step(handle_.get());
    if (code == SQLITE_ROW)
        return true;
    if (code == SQLITE_DONE)
        return false;
    return fail(context_->code, context_->path + ": " + sqliteMessage(code));
}

Result<void> SqlStatement::run()
{
    const Result<bool> stepped = step();
    reset();
    if (!stepped)
        return tl::unexpected{stepped.error()};
    return {};
}

void SqlStatement::reset()
{
    sqlite3_reset(handle_.get());
    sqlite3_clear_bindings(handle_.get());
    nextParameter_ = 1;
    context_->workLeft = kMostWork;
}

SqlStatement::Type SqlStatement::type(int column) const
{
    switch (sqlite3_column_type(handle_.get(), column)) {
        case SQLITE_INTEGER:
            return Type::Integer;
        case SQLITE_FLOAT:
            return Type::Real;
        case SQLITE_TEXT:
            return Type::Text;
        case SQLITE_BLOB:
            return Type::Blob;
        default:
            return Type::Null;
    }
}

std::int64_t SqlStatement::integer(int column) const
{
    return sqlite3_column_int64(handle_.get(), column);
}

double SqlStatement::real(int column) const
{
    return sqlite3_column_double(handle_.get(), column);
}

std::string_view SqlStatement::text(int column) const
{
    // Asking for the text of a number would turn it into one.
    if (type(column) != Type::Text)
        return {};
    const unsigned char* const text = sqlite3_column_text(handle_.get(), column);
    if (text == nullptr)
        return {};
    return {reinterpret_cast<const char*>(text), static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

std::string_view SqlStatement::blob(int column) const
{
    if (type(column) != Type::Blob)
        return {};
    const void* const bytes = sqlite3_column_blob(handle_.get(), column);
    if (bytes == nullptr)
        return {};
    return {static_cast<const char*>(bytes), static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

std::optional<std::int64_t> SqlStatement::integerIf(int column) const
{
    if (type(column) != Type::Integer)
        return std::nullopt;
    return integer(column);
}

std::optional<std::string> SqlStatement::textIf(int column) const
{
    if (type(column) != Type::Text)
        return std::nullopt;
    return std::string{text(column)};
}

}  // namespace planewright
