// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ostream>
#include <utility>

#include "core/formats/pwscan_schema.h"
#include "core/formats/pwscan_slice.h"
#include "core/formats/recording_pwscan.h"
#include "core/formats/written.h"

namespace planewright {

namespace {

Result<void> insertSlices(SqlDatabase& database, int scan, const Recording& recording)
{
    auto insert = prepareSliceInsert(database);
    if (!insert)
        return tl::unexpected{insert.error()};
    for (const ScanSlice& slice : recording.slices) {
        if (slice.ranges.size() != static_cast<std::size_t>(recording.description.beams))
            return fail(ErrorCode::Internal, "slice " + std::to_string(slice.step) + " has " +
                                                 std::to_string(slice.ranges.size()) + " beams instead of " +
                                                 std::to_string(recording.description.beams));
        const auto packed = packedRanges(slice.ranges);
        if (!packed)
            return fail(ErrorCode::NotWritten, "slice " + std::to_string(slice.step) + " has a range above " +
                                                   std::to_string(kMaxRangeMillimetres) +
                                                   " mm, which a recording cannot hold; limit the ranges");
        if (auto inserted = insertSlice(*insert, scan, slice, *packed); !inserted)
            return inserted;
    }
    return {};
}

Result<void> insertRecording(SqlDatabase& database, const Recording& recording, ScanNotes notes)
{
    notes.scan.description = recording.description;
    const auto id = insertScan(database, notes.scan);
    if (!id)
        return tl::unexpected{id.error()};
    Result<void> done = insertSlices(database, *id, recording);
    for (const ScanEvent& event : notes.events) {
        if (done)
            done = insertEvent(database, *id, event);
    }
    for (const StoredEdit& edit : notes.edits) {
        if (done)
            done = insertEdit(database, *id, edit.edit, edit.undone).map([](int) {});
    }
    for (StoredMapEdit& edit : notes.mapEdits) {
        edit.edit.scan = *id;
        if (done)
            done = insertMapEdit(database, edit.edit, edit.undone).map([](int) {});
    }
    return done;
}

ScanNotes notesOfCompleteScan()
{
    ScanNotes notes;
    notes.scan.state = ScanState::Complete;
    return notes;
}

/// The bytes of a recording that `fill` fills.
Result<void> writeDatabase(std::ostream& out, const std::function<Result<void>(SqlDatabase&)>& fill)
{
    auto database = SqlDatabase::openInMemory("the recording");
    if (!database)
        return tl::unexpected{database.error()};
    const auto filled = database->inTransaction([&]() -> Result<void> {
        if (auto made = createPwscanSchema(*database); !made)
            return made;
        return fill(*database);
    });
    if (!filled)
        return filled;
    const std::string bytes = database->bytes();
    if (bytes.empty())
        return fail(ErrorCode::NotWritten, "out of memory; close other programs");
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return written(out);
}

}  // namespace

Result<void> writeRecordingPwscan(std::ostream& out, const Recording& recording, const std::optional<ScanNotes>& notes)
{
    return writeDatabase(out, [&](SqlDatabase& database) {
        return insertRecording(database, recording, notes.value_or(notesOfCompleteScan()));
    });
}

Result<void> writeScansPwscan(std::ostream& out, std::size_t scans,
                              const std::function<Result<WrittenScan>(std::size_t scan)>& scanOf)
{
    return writeDatabase(out, [&](SqlDatabase& database) -> Result<void> {
        for (std::size_t i = 0; i < scans; ++i) {
            auto scan = scanOf(i);
            if (!scan)
                return tl::unexpected{scan.error()};
            if (auto inserted = insertRecording(database, scan->recording, std::move(scan->notes)); !inserted)
                return inserted;
        }
        return {};
    });
}

}  // namespace planewright
