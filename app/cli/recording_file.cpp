// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/recording_file.h"

#include <sys/stat.h>
#include <utility>

#include "app/cli/console.h"
#include "app/cli/file_kind.h"
#include "app/cli/input_file.h"
#include "app/cli/number_option.h"
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
    std::vector<std::string> warnings;
    RecordingFile file;
    if (isPwscan(path)) {
        Result<ReadPwscan> found = readRecordingPwscan(path, choice.scan);
        if (!found)
            return tl::unexpected{found.error()};
        warnings = std::move(found->read.warnings);
        file = {std::move(found->read.recording), found->read.damaged, std::move(found->notes)};
    } else {
        if (choice.scan)
            return fail(ErrorCode::Usage, path + ": only a .pwscan holds several scans; leave --scan out");
        Result<ReadRecording> found = readRecordingCsv(input, path);
        if (!found)
            return tl::unexpected{found.error()};
        warnings = std::move(found->warnings);
        file = {std::move(found->recording), found->damaged, std::nullopt};
    }
    for (const std::string& warning : warnings)
        printWarning(warning);
    return file;
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
    printWarning(path + ": the angle of " + std::to_string(suspects) +
                 (suspects == 1 ? " slice is suspect; it is not used" : " slices is suspect; they are not used"));
    return {};
}

}  // namespace

void addScanOption(CLI::App& command, int& scan)
{
    addWholeNumber(command, "--scan", scan, 0, kMaxStep, "number of the scan in a .pwscan (default: the last)");
}

RecordingChoice chosenScan(int scan)
{
    return {scan < 0 ? std::nullopt : std::optional{scan}, false};
}

Result<RecordingFile> readRecordingFile(const std::string& path, const RecordingChoice& choice)
{
    if (const auto known = checkRecordingNames({path}); !known)
        return tl::unexpected{known.error()};
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    Result<RecordingFile> file = read(path, **input, choice);
    if (file && !choice.keepsSuspects) {
        if (const auto left = leaveSuspectsOut(*file, path); !left)
            return tl::unexpected{left.error()};
    }
    return file;
}

Result<std::vector<RecordingChoice>> scansOfRecordingFile(const std::string& path)
{
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
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    return isPwscan(path) ? pwscanProblems(path) : recordingProblems(**input, path);
}

Result<void> checkRecordingNames(const std::vector<std::string>& paths)
{
    for (const std::string& path : paths) {
        if (const auto suffix = suffixOf(path, kRecordingSuffixes, "a recording"); !suffix)
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
