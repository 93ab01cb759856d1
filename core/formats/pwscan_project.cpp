// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/pwscan_project.h"

#include <utility>

#include "core/formats/edit_json.h"
#include "core/formats/parameter_events.h"
#include "core/formats/pwscan_open.h"
#include "core/formats/pwscan_schema.h"
#include "core/formats/recording_csv.h"

namespace planewright {

struct PwscanProject::State {
    std::string path;
    ReadOnlyCause cause = ReadOnlyCause::None;
    std::string readOnlyBecause;
    SqlDatabase database;
};

namespace {

constexpr std::size_t kLongestKey = 200;
constexpr std::size_t kLongestValue = std::size_t{1} << 20;

constexpr std::string_view kNoPermission =
    "the file or its folder cannot be written; copy the recording to a folder of your own to change it";

/// Finds out whether a change could be made, without making one.
Result<void> tryToWrite(SqlDatabase& database)
{
    Result<void> begun = database.run("PRAGMA synchronous=FULL; BEGIN IMMEDIATE");
    if (!begun)
        return begun;
    return database.run("ROLLBACK");
}

}  // namespace

PwscanProject::PwscanProject(std::unique_ptr<State> state) : state_(std::move(state)) {}
PwscanProject::PwscanProject(PwscanProject&&) noexcept = default;
PwscanProject& PwscanProject::operator=(PwscanProject&&) noexcept = default;
PwscanProject::~PwscanProject() = default;

Result<PwscanProject> PwscanProject::open(const std::string& path)
{
    auto reading = openPwscanForReading(path);
    if (!reading)
        return tl::unexpected{reading.error()};
    const auto version = checkPwscanSchema(*reading, path);
    if (!version)
        return tl::unexpected{version.error()};
    if (*version > kPwscanVersion)
        return PwscanProject{std::make_unique<State>(
            State{path, ReadOnlyCause::NewerVersion,
                  "the recording is of a newer version; change it with a newer version of the program",
                  std::move(*reading)})};
    auto writing = SqlDatabase::open(path, SqlDatabase::Access::Write, ErrorCode::NotWritten);
    if (!writing || writing->isReadOnly())
        return PwscanProject{std::make_unique<State>(
            State{path, ReadOnlyCause::NotWritable, std::string{kNoPermission}, std::move(*reading)})};
    if (const auto tried = tryToWrite(*writing); !tried) {
        const bool busy = writing->failedBusy();
        return PwscanProject{std::make_unique<State>(
            State{path, busy ? ReadOnlyCause::HeldElsewhere : ReadOnlyCause::NotWritable,
                  busy ? std::string{"another program is writing to it; close it there and open the recording again"}
                       : std::string{kNoPermission},
                  std::move(*reading)})};
    }
    // The file may have been exchanged between the two.
    if (const auto again = checkPwscanSchema(*writing, path); !again)
        return tl::unexpected{again.error()};
    return PwscanProject{std::make_unique<State>(State{path, ReadOnlyCause::None, {}, std::move(*writing)})};
}

const std::string& PwscanProject::readOnlyBecause() const
{
    return state_->readOnlyBecause;
}

ReadOnlyCause PwscanProject::readOnlyCause() const
{
    return state_->cause;
}

const std::string& PwscanProject::path() const
{
    return state_->path;
}

Result<void> PwscanProject::checkWritable() const
{
    if (!state_->readOnlyBecause.empty())
        return fail(ErrorCode::NotWritten, state_->path + ": " + state_->readOnlyBecause);
    return {};
}

Result<std::vector<ScanRecord>> PwscanProject::scans() const
{
    ProblemList problems{state_->path, 1};
    return readScans(state_->database, problems);
}

/// Errors where nothing can be added to a scan.
Result<void> PwscanProject::checkWritable(int scan) const
{
    if (auto writable = checkWritable(); !writable)
        return writable;
    const auto known = state_->database.number("SELECT count(*) FROM scan WHERE id=" + std::to_string(scan));
    if (!known)
        return tl::unexpected{known.error()};
    if (*known != 1)
        return fail(ErrorCode::Usage, state_->path + ": there is no scan " + std::to_string(scan));
    return {};
}

Result<void> PwscanProject::appendParameters(int scan, const Parameters& parameters, int fromStep)
{
    if (auto writable = checkWritable(scan); !writable)
        return writable;
    return insertEvent(state_->database, scan, parametersEvent(fromStep, parameters));
}

Result<int> PwscanProject::append(int scan, const Edit& edit)
{
    if (const auto writable = checkWritable(scan); !writable)
        return tl::unexpected{writable.error()};
    if (const auto fine = readEditJson(name(edit.kind), editJson(edit), state_->path); !fine)
        return fail(ErrorCode::Usage, fine.error().message);
    return insertEdit(state_->database, scan, edit, false);
}

Result<int> PwscanProject::append(const MapEdit& edit)
{
    if (const auto writable = checkWritable(edit.scan); !writable)
        return tl::unexpected{writable.error()};
    if (const auto fine = readMapEditJson(edit.scan, name(edit.kind), mapEditJson(edit), state_->path); !fine)
        return fail(ErrorCode::Usage, fine.error().message);
    return insertMapEdit(state_->database, edit, false);
}

Result<void> PwscanProject::setUndone(int seq, bool undone)
{
    if (auto writable = checkWritable(); !writable)
        return writable;
    auto update = state_->database.prepare("UPDATE edit SET undone=? WHERE seq=?");
    if (!update)
        return tl::unexpected{update.error()};
    if (auto updated = update->bind(std::int64_t{undone ? 1 : 0}).bind(std::int64_t{seq}).run(); !updated)
        return updated;
    if (state_->database.changedRows() != 1)
        return fail(ErrorCode::Usage, state_->path + ": there is no edit " + std::to_string(seq));
    return {};
}

Result<std::vector<StoredEdit>> PwscanProject::edits(int scan) const
{
    ProblemList problems{state_->path, 1};
    return readEdits(state_->database, scan, problems);
}

Result<std::vector<StoredMapEdit>> PwscanProject::mapEdits() const
{
    ProblemList problems{state_->path, 1};
    return readMapEdits(state_->database, problems);
}

Result<std::vector<ScanEvent>> PwscanProject::events(int scan) const
{
    ProblemList problems{state_->path, 1};
    std::vector<std::string> warnings;
    return readEvents(state_->database, scan, problems, warnings);
}

Result<std::optional<std::string>> PwscanProject::setting(std::optional<int> scan, std::string_view key) const
{
    auto select = state_->database.prepare("SELECT value FROM setting WHERE scan_id IS ? AND key=? LIMIT 1");
    if (!select)
        return tl::unexpected{select.error()};
    select->bind(scan ? std::optional<std::int64_t>{*scan} : std::nullopt).bind(key);
    const Result<bool> row = select->step();
    if (!row)
        return tl::unexpected{row.error()};
    if (!*row || select->text(0).size() > kLongestValue)
        return std::nullopt;
    return select->textIf(0);
}

Result<void> PwscanProject::setSetting(std::optional<int> scan, std::string_view key, std::string_view value)
{
    if (auto writable = checkWritable(); !writable)
        return writable;
    if (key.empty() || key.size() > kLongestKey || value.size() > kLongestValue)
        return fail(ErrorCode::Usage, state_->path + ": a setting has a key of at most " + std::to_string(kLongestKey) +
                                          " bytes and a value of at most " + std::to_string(kLongestValue));
    // NULL differs from NULL in a key, so that INSERT OR REPLACE would add a second setting of the file.
    return state_->database.inTransaction([&]() -> Result<void> {
        const auto of = scan ? std::optional<std::int64_t>{*scan} : std::nullopt;
        auto remove = state_->database.prepare("DELETE FROM setting WHERE scan_id IS ? AND key=?");
        if (!remove)
            return tl::unexpected{remove.error()};
        if (auto removed = remove->bind(of).bind(key).run(); !removed)
            return removed;
        auto insert = state_->database.prepare("INSERT INTO setting(scan_id, key, value) VALUES(?,?,?)");
        if (!insert)
            return tl::unexpected{insert.error()};
        return insert->bind(of).bind(key).bind(value).run();
    });
}

}  // namespace planewright
