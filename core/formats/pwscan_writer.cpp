// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/pwscan_writer.h"

#include <cassert>
#include <optional>
#include <utility>

#include "core/formats/parameter_events.h"
#include "core/formats/pwscan_schema.h"
#include "core/formats/pwscan_slice.h"
#include "core/formats/recording_csv.h"

namespace planewright {

struct PwscanWriter::State {
    std::string path;
    std::optional<SqlDatabase> database;  // none between a failure and the next call
    std::optional<SqlStatement> insert;
    ScanDescription description;
    std::string startedUtc;
    int scan = 0;
    int slices = 0;
    std::size_t ranges = 0;
    std::optional<int> lastStep;
    bool madeFile = false;
    bool closed = false;

    Result<void> reopen();
    Result<void> prepared(Result<void> done);
    Result<void> end(Result<void> done);
    Result<void> removeFile();
    bool holds(const ScanSlice& slice, std::string_view packed);
    void letGo();
};

namespace {

/// A small -wal, brought into the file every 256 KiB: on a disk that runs full it is the -wal that takes the last room,
/// and what is in it needs as much again in the file.
Result<void> beginWal(SqlDatabase& database)
{
    return database.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; PRAGMA wal_autocheckpoint=64");
}

/// True for the file that was recorded into, as far as its scan and the last slice tell.
Result<bool> holdsScan(SqlDatabase& database, int scan, std::string_view startedUtc, std::optional<int> lastStep)
{
    auto select = database.prepare(
        "SELECT 1 FROM scan WHERE id=?1 AND started_utc=?2 AND (?3 IS NULL OR EXISTS(SELECT 1 FROM slice WHERE "
        "scan_id=?1 AND step=?3))");
    if (!select)
        return tl::unexpected{select.error()};
    return select->bind(std::int64_t{scan})
        .bind(startedUtc)
        .bind(lastStep ? std::optional<std::int64_t>{*lastStep} : std::nullopt)
        .step();
}

/// Makes the tables in an empty file, in one transaction with the scan: a file is a recording or empty.
Result<int> beginFile(SqlDatabase& database, const std::string& path, const ScanRecord& scan)
{
    int id = 0;
    const auto begun = database.inTransaction([&]() -> Result<void> {
        const auto objects = database.number("SELECT count(*) FROM sqlite_schema");
        if (!objects)
            return tl::unexpected{objects.error()};
        if (*objects != 0)
            return fail(ErrorCode::NotWritten, path + ": another program has just made this file; give another name");
        if (auto made = createPwscanSchema(database); !made)
            return made;
        return insertScan(database, scan).map([&](int inserted) { id = inserted; });
    });
    if (!begun)
        return tl::unexpected{begun.error()};
    return id;
}

}  // namespace

PwscanWriter::PwscanWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
PwscanWriter::PwscanWriter(PwscanWriter&&) noexcept = default;
PwscanWriter& PwscanWriter::operator=(PwscanWriter&&) noexcept = default;
PwscanWriter::~PwscanWriter() = default;

Result<PwscanWriter> PwscanWriter::create(const std::string& path, const ScanRecord& scan)
{
    if (fileExists(path))
        return fail(ErrorCode::NotWritten, path + ": the file exists; add the scan to it, or give another name");
    auto database = SqlDatabase::open(path, SqlDatabase::Access::Create, ErrorCode::NotWritten);
    if (!database)
        return tl::unexpected{database.error()};
    ScanRecord running = scan;
    running.state = ScanState::Running;
    const auto id = beginFile(*database, path, running);
    if (!id)
        return tl::unexpected{id.error()};
    if (const auto begun = beginWal(*database); !begun)
        return tl::unexpected{begun.error()};
    auto state = std::make_unique<State>();
    state->path = path;
    state->database = std::move(*database);
    state->description = scan.description;
    state->startedUtc = scan.startedUtc;
    state->scan = *id;
    state->madeFile = true;
    return PwscanWriter{std::move(state)};
}

Result<PwscanWriter> PwscanWriter::append(const std::string& path, const ScanRecord& scan)
{
    if (!fileExists(path))
        return fail(ErrorCode::Unreadable, path + ": there is no such recording to add to; check its name");
    auto database = SqlDatabase::open(path, SqlDatabase::Access::Write, ErrorCode::NotWritten);
    if (!database)
        return tl::unexpected{database.error()};
    const auto version = checkPwscanSchema(*database, path);
    if (!version)
        return tl::unexpected{version.error()};
    if (*version > kPwscanVersion)
        return fail(ErrorCode::Unreadable,
                    path + ": the recording is of a newer version; add to it with a newer version of the program");
    if (const auto begun = beginWal(*database); !begun)
        return tl::unexpected{begun.error()};
    ScanRecord running = scan;
    running.state = ScanState::Running;
    const auto id = insertScan(*database, running);
    if (!id)
        return tl::unexpected{id.error()};
    auto state = std::make_unique<State>();
    state->path = path;
    state->database = std::move(*database);
    state->description = scan.description;
    state->startedUtc = scan.startedUtc;
    state->scan = *id;
    return PwscanWriter{std::move(state)};
}

/// Connects anew after a failure: what broke the connection, as a disk that was taken out, may be over.
Result<void> PwscanWriter::State::reopen()
{
    assert(!closed);
    if (database && database->fileHasMoved())
        letGo();
    if (!database) {
        auto again = SqlDatabase::open(path, SqlDatabase::Access::Write, ErrorCode::NotWritten);
        if (!again)
            return tl::unexpected{again.error()};
        const auto same = holdsScan(*again, scan, startedUtc, lastStep);
        if (!same)
            return tl::unexpected{same.error()};
        if (!*same)
            return fail(ErrorCode::NotWritten,
                        path + ": the file is another one than at the beginning; put back the one that was recorded");
        if (auto begun = beginWal(*again); !begun)
            return begun;
        database = std::move(*again);
    }
    if (!insert) {
        auto prepared = prepareSliceInsert(*database);
        if (!prepared)
            return tl::unexpected{prepared.error()};
        insert = std::move(*prepared);
    }
    return {};
}

void PwscanWriter::State::letGo()
{
    insert.reset();
    database.reset();
}

/// Passes on what became of a statement; after a failure that a new connection may cure, there is to be one.
Result<void> PwscanWriter::State::prepared(Result<void> done)
{
    if (!done && database && !database->mayPass())
        letGo();
    return done;
}

/// True where this very slice is in the file: its commit was said to have failed, and had reached the disk.
bool PwscanWriter::State::holds(const ScanSlice& slice, std::string_view packed)
{
    const auto sum = database->number("SELECT crc32 FROM slice WHERE scan_id=" + std::to_string(scan) +
                                      " AND step=" + std::to_string(slice.step) +
                                      " AND time_us=" + std::to_string(slice.time.count()));
    return sum && *sum == std::int64_t{checkSum(packed)};
}

Result<void> PwscanWriter::write(const ScanSlice& slice)
{
    State& s = *state_;
    if (slice.ranges.size() != static_cast<std::size_t>(s.description.beams) ||
        (s.lastStep && slice.step <= *s.lastStep))
        return fail(ErrorCode::Internal, s.path + ": slice " + std::to_string(slice.step) +
                                             " has another number of beams, or its step does not rise");
    const auto packed = packedRanges(slice.ranges);
    if (!packed)
        return fail(ErrorCode::NotWritten, s.path + ": slice " + std::to_string(slice.step) +
                                               " has a range that a recording cannot hold; limit the ranges");
    if (s.slices == kMaxSlices || s.ranges + slice.ranges.size() > kMaxRanges)
        return fail(ErrorCode::NotWritten, s.path + ": the scan is as long as a recording can be; begin a new one");
    if (auto ready = s.reopen(); !ready)
        return ready;
    Result<void> done = insertSlice(*s.insert, s.scan, slice, *packed);
    if (!done && s.database->failedByConstraint() && s.holds(slice, *packed))
        done = {};
    if (done) {
        ++s.slices;
        s.ranges += slice.ranges.size();
        s.lastStep = slice.step;
    }
    return s.prepared(std::move(done));
}

Result<void> PwscanWriter::write(const ScanEvent& event)
{
    if (auto ready = state_->reopen(); !ready)
        return ready;
    return state_->prepared(insertEvent(*state_->database, state_->scan, event));
}

Result<void> PwscanWriter::writeParameters(int step, const Parameters& parameters)
{
    return write(parametersEvent(step, parameters));
}

Result<void> PwscanWriter::close(ScanState state)
{
    State& s = *state_;
    if (auto ready = s.reopen(); !ready)
        return ready;
    const std::string update =
        "UPDATE scan SET state='" + std::string{name(state)} + "' WHERE id=" + std::to_string(s.scan);
    s.insert.reset();
    return s.end(s.database->run(update.c_str()));
}

Result<void> PwscanWriter::discard()
{
    State& s = *state_;
    if (auto ready = s.reopen(); !ready)
        return ready;
    s.insert.reset();
    const std::string id = std::to_string(s.scan);
    const auto slices = s.database->number("SELECT count(*) FROM slice WHERE scan_id=" + id);
    const auto others = s.database->number("SELECT count(*) FROM scan WHERE id<>" + id);
    if (!slices || !others)
        return s.prepared(tl::unexpected{slices ? others.error() : slices.error()});
    if (*slices != 0)
        return close(ScanState::Partial);
    if (s.madeFile && *others == 0)
        return s.removeFile();
    return s.end(s.database->inTransaction([&]() -> Result<void> {
        for (const std::string table : {"event", "edit", "setting"}) {
            if (auto removed = s.database->run(("DELETE FROM " + table + " WHERE scan_id=" + id).c_str()); !removed)
                return removed;
        }
        return s.database->run(("DELETE FROM scan WHERE id=" + id).c_str());
    }));
}

/// After the last statement: the file becomes one.
Result<void> PwscanWriter::State::end(Result<void> done)
{
    if (!done)
        return prepared(std::move(done));
    // Where another program has the file open, that one ends the -wal; the recording is whole with it, too.
    auto merged = database->run("PRAGMA wal_checkpoint(TRUNCATE); PRAGMA journal_mode=DELETE");
    if (!merged && !database->failedBusy())
        return prepared(std::move(merged));
    closed = true;
    letGo();
    return {};
}

Result<void> PwscanWriter::State::removeFile()
{
    letGo();
    const Result<void> removed = removeDatabase(path);
    closed = removed.has_value();
    return removed;
}

int PwscanWriter::scan() const
{
    return state_->scan;
}

int PwscanWriter::slices() const
{
    return state_->slices;
}

const std::string& PwscanWriter::path() const
{
    return state_->path;
}

}  // namespace planewright
