// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include "core/formats/map_edit.h"
#include "core/formats/parameter_events.h"
#include "core/formats/pwscan_open.h"
#include "core/formats/pwscan_schema.h"
#include "core/formats/pwscan_slice.h"
#include "core/formats/recording_pwscan.h"

namespace planewright {

namespace {

struct OpenedScans {
    SqlDatabase database;
    std::vector<ScanRecord> scans;
};

Result<OpenedScans> openScans(const std::string& path, ProblemList& problems)
{
    auto database = openPwscanForReading(path);
    if (!database)
        return tl::unexpected{database.error()};
    if (const auto checked = checkPwscanSchema(*database, path); !checked)
        return tl::unexpected{checked.error()};
    auto scans = readScans(*database, problems);
    if (!scans)
        return tl::unexpected{scans.error()};
    if (scans->empty())
        return fail(ErrorCode::Unreadable, problems.empty()
                                               ? path + ": there is no scan in it; record one with --append"
                                               : problems.texts().front());
    return OpenedScans{std::move(*database), std::move(*scans)};
}

/// What was found goes to the warnings, with a count of what is too much.
void tellProblems(const ProblemList& problems, std::vector<std::string>& warnings)
{
    warnings.insert(warnings.begin(), problems.texts().begin(), problems.texts().end());
    if (problems.more() > 0)
        warnings.push_back(problems.fileName() + ": " + std::to_string(problems.more()) + " more of such problems");
}

/// The last scan that has slices: a program that was killed before its first slice leaves one without. The last of all
/// where none has.
const ScanRecord& lastWithSlices(const std::vector<ScanRecord>& scans, SqlDatabase& database)
{
    auto select = database.prepare("SELECT 1 FROM slice NOT INDEXED WHERE scan_id=? LIMIT 1");
    for (auto scan = scans.rbegin(); select && scan != scans.rend(); ++scan) {
        const Result<bool> has = select->bind(std::int64_t{scan->id}).step();
        if (!has)
            break;
        if (*has)
            return *scan;
        select->reset();
    }
    return scans.back();
}

Result<const ScanRecord*> choose(const std::vector<ScanRecord>& scans, std::optional<int> wanted, SqlDatabase& database,
                                 const std::string& path)
{
    if (!wanted)
        return &lastWithSlices(scans, database);
    std::string numbers;
    for (const ScanRecord& scan : scans) {
        if (scan.id == *wanted)
            return &scan;
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(scan.id);
    }
    return fail(ErrorCode::Usage,
                path + ": there is no scan " + std::to_string(*wanted) + "; choose one of " + numbers);
}

}  // namespace

Result<ReadPwscan> readRecordingPwscan(const std::string& path, std::optional<int> scan)
{
    ProblemList problems{path, kMaxListedProblems};
    auto opened = openScans(path, problems);
    if (!opened)
        return tl::unexpected{opened.error()};
    const auto chosen = choose(opened->scans, scan, opened->database, path);
    if (!chosen)
        return tl::unexpected{chosen.error()};
    ReadPwscan result;
    result.notes.scan = **chosen;
    Recording& recording = result.read.recording;
    recording.description = result.notes.scan.description;
    std::size_t ranges = 0;
    const SliceListener listener{[&](ScanSlice&& slice) { recording.slices.push_back(std::move(slice)); },
                                 [&](const std::string& problem) {
                                     ++result.read.slicesLeftOut;
                                     problems.add(problem, 0);
                                 }};
    if (const auto read = readSlices(opened->database, result.notes.scan.id, recording.description, ranges, listener);
        !read)
        return tl::unexpected{read.error()};
    if (recording.slices.empty())
        return fail(ErrorCode::Unreadable, problems.empty() ? path + ": scan " + std::to_string(result.notes.scan.id) +
                                                                  " has no slice; choose another scan or recording"
                                                            : problems.texts().front());
    auto events = readEvents(opened->database, result.notes.scan.id, problems, result.read.warnings);
    if (!events)
        return tl::unexpected{events.error()};
    result.notes.events = std::move(*events);
    auto edits = readEdits(opened->database, result.notes.scan.id, problems);
    if (!edits)
        return tl::unexpected{edits.error()};
    result.notes.edits = std::move(*edits);
    result.read.damaged = !problems.empty();
    tellProblems(problems, result.read.warnings);
    return result;
}

Result<std::vector<ScanRecord>> scansOfPwscan(const std::string& path)
{
    ProblemList problems{path, 1};
    auto opened = openScans(path, problems);
    if (!opened)
        return tl::unexpected{opened.error()};
    return std::move(opened->scans);
}

RecordingProblems pwscanProblems(const std::string& path)
{
    RecordingProblems found;
    ProblemList problems{path, kMaxListedProblems};
    const auto giveUp = [&](const Error& error) {
        found.problems.push_back(error.message);
        return found;
    };
    auto opened = openScans(path, problems);
    if (!opened)
        return giveUp(opened.error());
    std::size_t ranges = 0;
    std::size_t slices = 0;
    for (const ScanRecord& scan : opened->scans) {
        const std::size_t before = slices;
        const SliceListener listener{[&](ScanSlice&&) { ++slices; },
                                     [&](const std::string& problem) { problems.add(problem, 0); }};
        if (const auto read = readSlices(opened->database, scan.id, scan.description, ranges, listener); !read)
            return giveUp(read.error());
        if (slices == before)
            found.warnings.push_back(path + ": scan " + std::to_string(scan.id) + " has no slice that can be used");
        const auto events = readEvents(opened->database, scan.id, problems, found.warnings);
        if (!events)
            return giveUp(events.error());
        if (const auto parameters = readParameterEvents(*events, path); !parameters)
            problems.addText(parameters.error().message);
        if (const auto edits = readEdits(opened->database, scan.id, problems); !edits)
            return giveUp(edits.error());
    }
    if (const auto edits = readMapEdits(opened->database, problems); !edits)
        return giveUp(edits.error());
    if (slices == 0)
        return giveUp({ErrorCode::Unreadable, problems.empty() ? path + ": there is no slice in it; get a sound copy"
                                                               : problems.texts().front()});
    found.damaged = !problems.empty();
    tellProblems(problems, found.warnings);
    return found;
}

}  // namespace planewright
