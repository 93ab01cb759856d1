// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/pwscan_notes.h"

#include <algorithm>
#include <array>

#include "core/formats/edit_json.h"
#include "core/formats/map_edit.h"
#include "core/formats/message_text.h"
#include "core/formats/pwscan_scan.h"
#include "core/formats/recording_csv.h"
#include "core/formats/sqlite_database.h"

namespace planewright {

namespace {

constexpr std::array<std::string_view, 7> kEventKinds{"parameters", "fault", "recovered", "pause",
                                                      "resume",     "mark",  "note"};
constexpr std::size_t kMostPayloadBytes = std::size_t{64} << 20;  ///< of all events, or all edits, together

/// Calls `take` for each row of a table in order of its key; it gives the bytes that the row holds. All scans are gone
/// through, for no index leads to one: a file may hold few of such rows for all its scans.
template <class Take>
Result<void> eachRow(SqlDatabase& database, const std::string& select, std::string_view what, ProblemList& problems,
                     Take take)
{
    auto rows = database.prepare(select + " LIMIT " + std::to_string(kMaxScanNotes + 1));
    if (!rows)
        return tl::unexpected{rows.error()};
    std::size_t bytes = 0;
    for (int row = 0;; ++row) {
        const Result<bool> there = rows->step();
        if (!there) {
            problems.add("the " + std::string{what} + "s cannot be read beyond the first " + std::to_string(row) +
                             ", the file is damaged; those are used",
                         0);
            return {};
        }
        if (!*there)
            return {};
        bytes += take(*rows);
        if (row == kMaxScanNotes || bytes > kMostPayloadBytes) {
            problems.add("there are more " + std::string{what} + "s than a recording may hold; the first " +
                             std::to_string(row) + " are used",
                         0);
            return {};
        }
    }
}

/// The place of a row in its table, for messages.
std::string placeOf(std::string_view what, const SqlStatement& row)
{
    return std::string{what} + " " + std::to_string(row.integer(0));
}

}  // namespace

std::string_view name(ScanEvent::Kind kind)
{
    return kEventKinds[static_cast<std::size_t>(kind)];
}

Result<void> insertEvent(SqlDatabase& database, int scan, const ScanEvent& event)
{
    auto insert = database.prepare("INSERT INTO event(scan_id, step, time_us, kind, payload) VALUES(?,?,?,?,?)");
    if (!insert)
        return tl::unexpected{insert.error()};
    insert->bind(std::int64_t{scan})
        .bind(event.step ? std::optional<std::int64_t>{*event.step} : std::nullopt)
        .bind(event.time ? std::optional<std::int64_t>{event.time->count()} : std::nullopt)
        .bind(name(event.kind))
        .bind(event.payload);
    return insert->run();
}

Result<int> insertEdit(SqlDatabase& database, int scan, const Edit& edit, bool undone)
{
    auto insert = database.prepare("INSERT INTO edit(scan_id, kind, payload, undone) VALUES(?,?,?,?)");
    if (!insert)
        return tl::unexpected{insert.error()};
    const std::string payload = editJson(edit);
    insert->bind(std::int64_t{scan}).bind(name(edit.kind)).bind(payload).bind(std::int64_t{undone ? 1 : 0});
    if (const auto inserted = insert->run(); !inserted)
        return tl::unexpected{inserted.error()};
    return static_cast<int>(database.lastInsertedRow());
}

Result<std::vector<ScanEvent>> readEvents(SqlDatabase& database, int scan, ProblemList& problems,
                                          std::vector<std::string>& warnings)
{
    std::vector<ScanEvent> events;
    const auto take = [&](const SqlStatement& row) {
        const std::size_t bytes = row.text(5).size();
        if (row.integerIf(1) != std::int64_t{scan})
            return bytes;
        const auto kind = std::find(kEventKinds.begin(), kEventKinds.end(), row.text(4));
        const auto step = row.integerIf(2);
        const auto time = row.integerIf(3);
        const bool stepFits = row.isNull(2) || (step && *step >= 0 && *step <= kMaxStep);
        if (!stepFits || !(row.isNull(3) || time) || row.type(5) != SqlStatement::Type::Text)
            problems.add(placeOf("event", row) + ": step, time_us or payload is not what it must be; it is not used",
                         0);
        else if (kind == kEventKinds.end())
            warnings.push_back(placeInFile(problems.fileName(), 0) + placeOf("event", row) + ": the kind " +
                               quotedText(row.text(4)) + " is not known; it is not used");
        else
            events.push_back({static_cast<ScanEvent::Kind>(kind - kEventKinds.begin()),
                              step ? std::optional{static_cast<int>(*step)} : std::nullopt,
                              time ? std::optional{std::chrono::microseconds{*time}} : std::nullopt,
                              std::string{row.text(5)}});
        return bytes + sizeof(ScanEvent);
    };
    const auto read =
        eachRow(database, "SELECT id, scan_id, step, time_us, kind, payload FROM event NOT INDEXED ORDER BY id",
                "event", problems, take);
    if (!read)
        return tl::unexpected{read.error()};
    return events;
}

Result<std::vector<StoredEdit>> readEdits(SqlDatabase& database, int scan, ProblemList& problems)
{
    std::vector<StoredEdit> edits;
    const auto take = [&](const SqlStatement& row) {
        const std::size_t bytes = row.text(3).size();
        if (row.integerIf(1) != std::int64_t{scan} || isMapEditKind(row.text(2)))
            return bytes;
        auto edit = readEditJson(row.text(2), row.text(3), placeOf("edit", row));
        const auto undone = row.integerIf(4);
        const std::int64_t seq = row.integer(0);
        if (!edit)
            problems.add(edit.error().message + "; it is not applied", 0);
        else if (!undone || seq < 0 || seq > kMaxStep)
            problems.add(placeOf("edit", row) + ": seq or undone is not what it must be; it is not applied", 0);
        else
            edits.push_back({static_cast<int>(seq), std::move(*edit), *undone != 0});
        return bytes + sizeof(StoredEdit);
    };
    const auto read = eachRow(database, "SELECT seq, scan_id, kind, payload, undone FROM edit NOT INDEXED ORDER BY seq",
                              "edit", problems, take);
    if (!read)
        return tl::unexpected{read.error()};
    return edits;
}

std::vector<Edit> editsInForce(const std::vector<StoredEdit>& edits)
{
    std::vector<Edit> inForce;
    for (const StoredEdit& stored : edits) {
        if (!stored.undone)
            inForce.push_back(stored.edit);
    }
    return inForce;
}

}  // namespace planewright
