// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/files/cloud_file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "app/files/file_kind.h"
#include "app/files/input_file.h"
#include "core/formats/cloud_pcd.h"
#include "core/formats/cloud_ptx.h"
#include "core/formats/cloud_recording.h"
#include "core/formats/cloud_uos.h"
#include "core/formats/number_cells.h"
#include "core/types/count_text.h"

namespace planewright {

namespace {

constexpr std::string_view kUosPrefix = "scan";
constexpr std::string_view kUosSuffix = ".3d";
constexpr std::string_view kUosPoseSuffix = ".pose";

bool isFolder(const std::string& path)
{
    std::error_code error;
    return std::filesystem::is_directory(path, error);
}

bool hasSuffix(const std::string& path, std::string_view suffix)
{
    return suffixOf(path, {suffix}, "").has_value();
}

/// The scans of 3DTK in a folder by their numbers. Errors (Unreadable): none, or two of one number.
Result<std::map<int, std::string>> uosScansIn(const std::string& folder)
{
    std::map<int, std::string> scans;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (!name.starts_with(kUosPrefix) || !name.ends_with(kUosSuffix))
            continue;
        const auto number = readNumber<int>(
            std::string_view{name}.substr(kUosPrefix.size(), name.size() - kUosPrefix.size() - kUosSuffix.size()));
        if (!number || *number < 0)
            continue;
        if (!scans.emplace(*number, entry->path().string()).second)
            return fail(ErrorCode::Unreadable,
                        folder + ": there are two scans of number " + std::to_string(*number) + "; remove one");
        if (scans.size() > static_cast<std::size_t>(kMaxScans))
            return fail(ErrorCode::Unreadable,
                        folder + ": more than " + std::to_string(kMaxScans) + " scans; divide the folder");
    }
    if (error)
        return fail(ErrorCode::Unreadable, folder + ": the folder cannot be read: " + error.message());
    if (scans.empty())
        return fail(ErrorCode::Unreadable,
                    folder + ": there is no scan in this folder; scans of 3DTK are called scan000.3d, scan001.3d, ...");
    return scans;
}

/// A cloud, and what its owner should hear of it.
struct ReadCloud {
    CloudScan cloud;
    std::string place;  ///< file and scan
    std::vector<std::string> warnings;
};

template <class Read>
auto withInput(const std::string& path, const std::stop_token& stop, Read read)
    -> decltype(read(std::declval<std::istream&>()))
{
    const auto input = openInput(path, stop);
    if (!input)
        return tl::unexpected{input.error()};
    auto done = read(**input);
    if (stop.stop_requested())
        return fail(ErrorCode::Interrupted, path + ": reading was cancelled");
    return done;
}

Result<ReadCloud> readUos(const std::string& path, const std::stop_token& stop)
{
    auto cloud = withInput(path, stop, [&](std::istream& in) { return readCloudUos(in, path); });
    if (!cloud)
        return tl::unexpected{cloud.error()};
    ReadCloud read{std::move(*cloud), path, {}};
    const std::string posePath = path.substr(0, path.size() - kUosSuffix.size()) + std::string{kUosPoseSuffix};
    std::error_code error;
    if (!std::filesystem::exists(posePath, error)) {
        read.warnings.push_back(path + ": there is no " + posePath + " beside it; the scan has no pose");
        return read;
    }
    const auto pose = withInput(posePath, stop, [&](std::istream& in) { return readPoseUos(in, posePath); });
    if (!pose)
        return tl::unexpected{pose.error()};
    read.cloud.pose = *pose;
    return read;
}

Result<ReadCloud> readCloud(const std::string& path, int scan, const std::stop_token& stop)
{
    if (isFolder(path)) {
        const auto scans = uosScansIn(path);
        if (!scans)
            return tl::unexpected{scans.error()};
        const auto found = scans->find(scan);
        if (found == scans->end())
            return fail(ErrorCode::Unreadable,
                        path + ": scan " + std::to_string(scan) + " is not there any more; check the folder");
        return readUos(found->second, stop);
    }
    if (hasSuffix(path, kUosSuffix))
        return readUos(path, stop);
    const bool isPtx = hasSuffix(path, kPtxSuffix);
    auto cloud = withInput(
        path, stop, [&](std::istream& in) { return isPtx ? readCloudPtx(in, path, scan) : readCloudPcd(in, path); });
    if (!cloud)
        return tl::unexpected{cloud.error()};
    return ReadCloud{std::move(*cloud), isPtx ? path + ", scan " + std::to_string(scan) : path, {}};
}

/// What was recovered and how well.
std::string recoveredText(const std::string& place, const CloudRecording& made)
{
    std::string text = place + ": imported as a scanner";
    for (const auto& [key, value] : made.recording.description.extra) {
        if (key == "recovered_axis")
            text += " with the pitch axis (" + value + ")";
        else if (key == "recovered_beams")
            text += " and beams " + value + ";";
        else if (key == "recovered_largest_off_mm")
            text += " points are off it by at most " + value + " mm";
        else if (key == "recovered_rms_off_mm")
            text += " (root mean square " + value + " mm)";
        else
            text += "; " + value;
    }
    return text;
}

}  // namespace

bool isCloudFile(const std::string& path)
{
    return suffixOf(path, kCloudSuffixes, "").has_value() ||
           (isFolder(path) && !suffixOf(path, kRecordingSuffixes, "").has_value());
}

Result<std::vector<int>> scansOfCloudFile(const std::string& path)
{
    if (isFolder(path)) {
        return uosScansIn(path).map([](const std::map<int, std::string>& scans) {
            std::vector<int> numbers;
            for (const auto& [number, file] : scans)
                numbers.push_back(number);
            return numbers;
        });
    }
    if (!hasSuffix(path, kPtxSuffix))
        return withInput(path, {}, [](std::istream&) -> Result<std::vector<int>> { return std::vector<int>{0}; });
    return withInput(path, {}, [&](std::istream& in) { return scansOfPtx(in, path); }).map([](int scans) {
        std::vector<int> numbers;
        for (int number = 0; number < scans; ++number)
            numbers.push_back(number);
        return numbers;
    });
}

Result<RecordingFile> loadCloudFile(const std::string& path, std::optional<int> scan, const std::stop_token& stop)
{
    const auto scans = scansOfCloudFile(path);
    if (!scans)
        return tl::unexpected{scans.error()};
    const int number = scan.value_or(scans->back());
    if (std::find(scans->begin(), scans->end(), number) == scans->end())
        return fail(ErrorCode::Usage, path + ": there is no scan " + std::to_string(number) + "; there are " +
                                          countText(scans->size(), "scan") + ", from " +
                                          std::to_string(scans->front()) + " to " + std::to_string(scans->back()));
    auto read = readCloud(path, number, stop);
    if (!read)
        return tl::unexpected{read.error()};
    std::optional<Pose> pose = read->cloud.pose;
    auto made = recordingOf(std::move(read->cloud), read->place);
    if (!made)
        return tl::unexpected{made.error()};
    RecordingFile file;
    file.warnings = std::move(read->warnings);
    file.warnings.push_back(recoveredText(read->place, *made));
    if (made->pointsLeftOut > 0)
        file.warnings.push_back(read->place + ": " + countText(made->pointsLeftOut, "point") +
                                " off that scanner by more than 1 mm on each metre, left out");
    if (!scan && scans->size() > 1)
        file.warnings.push_back(path + ": holds " + countText(scans->size(), "scan") + "; the last is used");
    ScanNotes& notes = file.notes.emplace();
    notes.scan.id = number;
    notes.scan.name = read->place.substr(read->place.rfind('/') + 1);
    notes.scan.state = ScanState::Complete;
    notes.scan.description = made->recording.description;
    notes.scan.pose = pose;
    file.recording = std::move(made->recording);
    file.isImported = true;
    return file;
}

}  // namespace planewright
