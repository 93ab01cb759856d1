// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/files/recording_file.h"

#include <sys/stat.h>
#include <utility>

#include "app/files/cloud_file.h"
#include "app/files/file_kind.h"
#include "app/files/input_file.h"
#include "core/formats/recording_csv.h"

namespace planewright {

namespace {

bool isPwscan(const std::string& path)
{
    const auto suffix = suffixOf(path, kRecordingSuffixes, "a recording");
    return suffix && *suffix == kPwscanSuffix;
}

Result<RecordingFile> read(const std::string& path, std::istream& input, const RecordingChoice& choice)
{
    if (isPwscan(path)) {
        Result<ReadPwscan> found = readRecordingPwscan(path, choice.scan);
        if (!found)
            return tl::unexpected{found.error()};
        return RecordingFile{std::move(found->read.recording),
                             found->read.damaged,
                             found->read.slicesLeftOut,
                             std::move(found->notes),
                             false,
                             std::move(found->read.warnings)};
    }
    if (choice.scan)
        return fail(ErrorCode::Usage, path + ": a .csv holds one scan; leave --scan out");
    Result<ReadRecording> found = readRecordingCsv(input, path);
    if (!found)
        return tl::unexpected{found.error()};
    return RecordingFile{std::move(found->recording), found->damaged, found->slicesLeftOut, std::nullopt, false,
                         std::move(found->warnings)};
}

Result<void> leaveSuspectsOut(RecordingFile& file, const std::string& path)
{
    const std::size_t suspects =
        std::erase_if(file.recording.slices, [](const ScanSlice& slice) { return slice.angleSuspect; });
    if (suspects == 0)
        return {};
    if (file.recording.slices.empty())
        return fail(ErrorCode::Unreadable, path +
                                               ": the angle of every slice is suspect; check the tilt unit and scan "
                                               "again");
    file.warnings.push_back(
        path + ": the angle of " + std::to_string(suspects) +
        (suspects == 1 ? " slice is suspect; it is not used" : " slices is suspect; they are not used"));
    return {};
}

/// A scan that cannot be imported is one problem: nothing of it is used.
Result<RecordingProblems> problemsOfCloud(const std::string& path)
{
    const auto scans = scansOfCloudFile(path);
    if (!scans)
        return tl::unexpected{scans.error()};
    RecordingProblems found;
    for (const int scan : *scans) {
        auto file = loadCloudFile(path, scan, {});
        if (file)
            found.warnings.insert(found.warnings.end(), file->warnings.begin(), file->warnings.end());
        else if (found.problems.size() < kMaxListedProblems)
            found.problems.push_back(file.error().message);
        else
            ++found.more;
    }
    return found;
}

}  // namespace

Result<RecordingFile> loadRecordingFile(const std::string& path, const RecordingChoice& choice,
                                        const std::stop_token& stop)
{
    if (const auto known = checkRecordingNames({path}); !known)
        return tl::unexpected{known.error()};
    if (isCloudFile(path))
        return loadCloudFile(path, choice.scan, stop);
    const auto input = openInput(path, stop);
    if (!input)
        return tl::unexpected{input.error()};
    Result<RecordingFile> file = read(path, **input, choice);
    if (stop.stop_requested())
        return fail(ErrorCode::Interrupted, path + ": reading was cancelled");
    if (file && !choice.keepsSuspects) {
        if (const auto left = leaveSuspectsOut(*file, path); !left)
            return tl::unexpected{left.error()};
    }
    return file;
}

Result<std::vector<RecordingChoice>> scansOfRecordingFile(const std::string& path)
{
    if (isCloudFile(path)) {
        return scansOfCloudFile(path).map([](const std::vector<int>& scans) {
            std::vector<RecordingChoice> choices;
            for (const int scan : scans)
                choices.push_back({scan, false});
            return choices;
        });
    }
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    if (!isPwscan(path))
        return std::vector<RecordingChoice>(1);
    const auto scans = scansOfPwscan(path);
    if (!scans)
        return tl::unexpected{scans.error()};
    std::vector<RecordingChoice> choices;
    for (const ScanRecord& scan : *scans)
        choices.push_back({scan.id, false});
    return choices;
}

Result<RecordingProblems> problemsOfRecordingFile(const std::string& path)
{
    if (isCloudFile(path))
        return problemsOfCloud(path);
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    return isPwscan(path) ? pwscanProblems(path) : recordingProblems(**input, path);
}

Result<void> checkRecordingNames(const std::vector<std::string>& paths)
{
    for (const std::string& path : paths) {
        if (isCloudFile(path))
            continue;
        if (const auto suffix = suffixOf(path, kScanSuffixes, "a recording"); !suffix)
            return tl::unexpected{suffix.error()};
    }
    return {};
}

Result<std::string_view> checkRecordingTarget(const std::string& path)
{
    auto suffix = suffixOf(path, kRecordingSuffixes, "a recording");
    if (!suffix || *suffix != kPwscanSuffix)
        return suffix;
    const std::string taken = path + ": a recording of this name is being written, or was broken off and left ";
    for (const char* const beside : {"-wal", "-journal"}) {
        struct stat status {};
        std::string left = path;
        left += beside;
        if (::stat(left.c_str(), &status) == 0 && status.st_size > 0)
            return fail(ErrorCode::NotWritten, taken + left.append("; give another name"));
    }
    return suffix;
}

Result<void> writeRecording(std::ostream& out, const Recording& recording, std::string_view suffix,
                            const std::optional<ScanNotes>& notes)
{
    if (suffix == kPwscanSuffix)
        return writeRecordingPwscan(out, recording, notes);
    return writeRecordingCsv(out, recording, suffix == ".csv.gz");
}

}  // namespace planewright
