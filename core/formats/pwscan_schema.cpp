// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/pwscan_schema.h"

#include <array>
#include <span>

#include "core/formats/message_text.h"

namespace planewright {

namespace {

constexpr std::int64_t kApplicationId = 0x50575343;  // "PWSC"

constexpr const char* kSchema = R"(
PRAGMA application_id = 0x50575343;
PRAGMA user_version = 1;
CREATE TABLE scan(id INTEGER PRIMARY KEY, name TEXT NOT NULL, floor INTEGER NOT NULL DEFAULT 0, started_utc TEXT NOT NULL,
  state TEXT NOT NULL CHECK(state IN ('running','complete','partial','fault')), scanner TEXT NOT NULL,
  bearing_start_deg REAL NOT NULL, bearing_step_deg REAL NOT NULL, beams INTEGER NOT NULL, range_min_m REAL NOT NULL,
  range_max_m REAL NOT NULL, pitch_axis_offset_m REAL NOT NULL, planned_slices INTEGER,
  extra TEXT NOT NULL DEFAULT '{}', x REAL, y REAL, z REAL, qw REAL, qx REAL, qy REAL, qz REAL);
CREATE TABLE slice(scan_id INTEGER NOT NULL REFERENCES scan(id), step INTEGER NOT NULL, time_us INTEGER NOT NULL,
  pitch_deg REAL NOT NULL, pitch_end_deg REAL, pitch_commanded_deg REAL, bearing_start_deg REAL,
  flags INTEGER NOT NULL DEFAULT 0, ranges BLOB NOT NULL, crc32 INTEGER NOT NULL,
  PRIMARY KEY(scan_id, step)) WITHOUT ROWID;
CREATE TABLE event(id INTEGER PRIMARY KEY, scan_id INTEGER, step INTEGER, time_us INTEGER, kind TEXT NOT NULL,
  payload TEXT NOT NULL);
CREATE TABLE edit(seq INTEGER PRIMARY KEY, scan_id INTEGER NOT NULL, kind TEXT NOT NULL, payload TEXT NOT NULL,
  undone INTEGER NOT NULL DEFAULT 0);
CREATE TABLE setting(scan_id INTEGER, key TEXT NOT NULL, value TEXT NOT NULL, PRIMARY KEY(scan_id, key));
)";

/// A column and its place in the primary key, from 1; 0 where it is in none.
struct SchemaColumn {
    std::string_view name;
    int key = 0;
};

struct Table {
    std::string_view name;
    std::span<const SchemaColumn> columns;
};

constexpr std::array<SchemaColumn, 21> kScanColumns{{{"id", 1},
                                                     {"name"},
                                                     {"floor"},
                                                     {"started_utc"},
                                                     {"state"},
                                                     {"scanner"},
                                                     {"bearing_start_deg"},
                                                     {"bearing_step_deg"},
                                                     {"beams"},
                                                     {"range_min_m"},
                                                     {"range_max_m"},
                                                     {"pitch_axis_offset_m"},
                                                     {"planned_slices"},
                                                     {"extra"},
                                                     {"x"},
                                                     {"y"},
                                                     {"z"},
                                                     {"qw"},
                                                     {"qx"},
                                                     {"qy"},
                                                     {"qz"}}};
constexpr std::array<SchemaColumn, 10> kSliceColumns{{{"scan_id", 1},
                                                      {"step", 2},
                                                      {"time_us"},
                                                      {"pitch_deg"},
                                                      {"pitch_end_deg"},
                                                      {"pitch_commanded_deg"},
                                                      {"bearing_start_deg"},
                                                      {"flags"},
                                                      {"ranges"},
                                                      {"crc32"}}};
constexpr std::array<SchemaColumn, 6> kEventColumns{
    {{"id", 1}, {"scan_id"}, {"step"}, {"time_us"}, {"kind"}, {"payload"}}};
constexpr std::array<SchemaColumn, 5> kEditColumns{{{"seq", 1}, {"scan_id"}, {"kind"}, {"payload"}, {"undone"}}};
constexpr std::array<SchemaColumn, 3> kSettingColumns{{{"scan_id", 1}, {"key", 2}, {"value"}}};
constexpr std::array<Table, 5> kTables{{{"scan", kScanColumns},
                                        {"slice", kSliceColumns},
                                        {"event", kEventColumns},
                                        {"edit", kEditColumns},
                                        {"setting", kSettingColumns}}};

/// What is wrong with a table; empty if nothing is.
Result<std::string> problemOf(const Table& table, bool moreColumns, SqlDatabase& database)
{
    auto kind = database.prepare("SELECT type FROM pragma_table_list(?) WHERE schema='main'");
    if (!kind)
        return tl::unexpected{kind.error()};
    const Result<bool> there = kind->bind(table.name).step();
    if (!there)
        return tl::unexpected{there.error()};
    if (!*there)
        return "there is no table '" + std::string{table.name} + "'";
    if (kind->text(0) != "table")
        return "'" + std::string{table.name} + "' is no plain table";

    auto columns = database.prepare("SELECT name, pk, hidden FROM pragma_table_xinfo(?)");
    if (!columns)
        return tl::unexpected{columns.error()};
    columns->bind(table.name);
    std::size_t place = 0;
    for (;;) {
        const Result<bool> row = columns->step();
        if (!row)
            return tl::unexpected{row.error()};
        if (!*row)
            break;
        const bool known = place < table.columns.size();
        if (known && (columns->text(0) != table.columns[place].name ||
                      columns->integer(1) != table.columns[place].key || columns->integer(2) != 0))
            return "table '" + std::string{table.name} + "' has " + quotedText(columns->text(0)) +
                   " where the column '" + std::string{table.columns[place].name} + "' belongs";
        if (!known && !moreColumns)
            return "table '" + std::string{table.name} + "' has the unknown column " + quotedText(columns->text(0));
        ++place;
    }
    if (place < table.columns.size())
        return "table '" + std::string{table.name} + "' lacks the column '" + std::string{table.columns[place].name} +
               "'";
    return std::string{};
}

/// The first thing in the schema that no recording has: it would run, or stand in for a table. Empty if there is none.
Result<std::string> strangerIn(SqlDatabase& database)
{
    auto strangers = database.prepare(
        "SELECT type, name FROM sqlite_schema WHERE type NOT IN ('table','index') OR (type='index' AND sql IS NOT "
        "NULL) "
        "OR (type='table' AND (rootpage IS NULL OR rootpage<=0)) LIMIT 1");
    if (!strangers)
        return tl::unexpected{strangers.error()};
    const Result<bool> row = strangers->step();
    if (!row)
        return tl::unexpected{row.error()};
    if (!*row)
        return std::string{};
    return "there is a " + printableText(strangers->text(0)) + " " + quotedText(strangers->text(1)) +
           ", which no recording has";
}

}  // namespace

Result<void> createPwscanSchema(SqlDatabase& database)
{
    return database.run(kSchema);
}

Result<int> checkPwscanSchema(SqlDatabase& database, const std::string& path)
{
    const auto refuse = [&](const std::string& what) {
        return fail(ErrorCode::Unreadable, path + ": " + what + "; get a sound copy");
    };
    const auto application = database.number("PRAGMA application_id");
    if (!application)
        return tl::unexpected{application.error()};
    if (*application != kApplicationId)
        return fail(ErrorCode::Unreadable,
                    path + ": this is a database, but no recording; give a file that was recorded as .pwscan");
    const auto version = database.number("PRAGMA user_version");
    if (!version)
        return tl::unexpected{version.error()};
    if (version->value_or(0) < 1)
        return refuse("the recording says no version of its format");
    const auto stranger = strangerIn(database);
    if (!stranger)
        return tl::unexpected{stranger.error()};
    if (!stranger->empty())
        return refuse(*stranger);
    for (const Table& table : kTables) {
        const auto problem = problemOf(table, **version > kPwscanVersion, database);
        if (!problem)
            return tl::unexpected{problem.error()};
        if (!problem->empty())
            return refuse(*problem);
    }
    return static_cast<int>(**version);
}

}  // namespace planewright
