// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <ostream>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/recording_pwscan.h"
#include "core/types/error.h"

namespace planewright {

/// What is read of a recording.
struct RecordingChoice {
    std::optional<int> scan;     ///< of a .pwscan, .ptx or folder; without a number the last with slices
    bool keepsSuspects = false;  ///< slices whose angle may be wrong are among the slices
};

/// A recording, with what a .pwscan holds beside it, or an import of its scan.
struct RecordingFile {
    Recording recording;
    bool damaged = false;   ///< something had to be left out
    int slicesLeftOut = 0;  ///< of these, the slices, as far as they can be counted
    std::optional<ScanNotes> notes;
    bool isImported = false;            ///< made of points; edits have no place in its file
    std::vector<std::string> warnings;  ///< one line each, beginning with the file's name
};

/// Reads a recording of a kind known by its suffix (kScanSuffixes), or imports a cloud, or a folder of 3DTK (see
/// loadCloudFile). A stop ends the reading of texts soon. Errors: Usage for another suffix, or for a scan that is not
/// in the file; Interrupted after a stop; Unreadable otherwise.
Result<RecordingFile> loadRecordingFile(const std::string& path, const RecordingChoice& choice = {},
                                        const std::stop_token& stop = {});

/// One choice for each scan that a file holds. Errors (Unreadable): it cannot be opened.
Result<std::vector<RecordingChoice>> scansOfRecordingFile(const std::string& path);

/// Every problem of a recording. Errors (Unreadable): it cannot be opened.
Result<RecordingProblems> problemsOfRecordingFile(const std::string& path);

/// Finds out before any work whether all these names are of what can be read as a recording. Errors: Usage.
Result<void> checkRecordingNames(const std::vector<std::string>& paths);

/// Finds out before any work whether a recording may be written there, and gives the suffix. Errors: Usage for a name
/// of no recording; NotWritten where the file is one that is being recorded, or was broken off: what lies beside it
/// would be taken for a part of the new one.
Result<std::string_view> checkRecordingTarget(const std::string& path);

/// Writes a recording as the suffix says; the notes only where the kind can hold them.
Result<void> writeRecording(std::ostream& out, const Recording& recording, std::string_view suffix,
                            const std::optional<ScanNotes>& notes = std::nullopt);

}  // namespace planewright
