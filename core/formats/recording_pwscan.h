// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/map_edit.h"
#include "core/formats/pwscan_notes.h"
#include "core/formats/pwscan_scan.h"
#include "core/formats/recording_csv.h"

namespace planewright {

/// What a `.pwscan` holds of a scan beside its slices.
struct ScanNotes {
    ScanRecord scan;
    std::vector<ScanEvent> events;
    std::vector<StoredEdit> edits;
    std::vector<StoredMapEdit> mapEdits = {};  ///< to be written: those of this stop; reading one scan gives none
};

/// One scan of a `.pwscan` as it was read.
struct ReadPwscan {
    ReadRecording read;  ///< damaged where a slice, an event or an edit had to be left out; the warnings name each
    ScanNotes notes;     ///< read.recording has the scan's description, too
};

/// Reads one scan of a `.pwscan`, without a number the last that has slices. The file is not trusted: its schema, and
/// every row that is used, is held against what a recording must be, and a bad slice is named and left out. The limits
/// are those of readRecordingCsv. Slices that are angle suspect are among the slices. The caller has made sure that the
/// path is a regular file. Errors: Usage for a number that no scan has; Unreadable otherwise, naming the file.
Result<ReadPwscan> readRecordingPwscan(const std::string& path, std::optional<int> scan = std::nullopt);

/// The scans of a file in order of their numbers. Errors as above.
Result<std::vector<ScanRecord>> scansOfPwscan(const std::string& path);

/// All that is wrong with a file, over all its scans. What can be left out is among the warnings, with `damaged` set.
RecordingProblems pwscanProblems(const std::string& path);

/// Writes a recording as the bytes of a `.pwscan` of one scan, complete unless the notes say otherwise, whose
/// description is the recording's; the same recording gives the same bytes. Errors: NotWritten as writeRecordingCsv.
Result<void> writeRecordingPwscan(std::ostream& out, const Recording& recording,
                                  const std::optional<ScanNotes>& notes = std::nullopt);

/// A scan that is to be written.
struct WrittenScan {
    Recording recording;
    ScanNotes notes;
};

/// Writes so many scans as the bytes of one `.pwscan`, in their order; each is asked for when it is its turn, and an
/// error of it ends the writing. Otherwise as writeRecordingPwscan.
Result<void> writeScansPwscan(std::ostream& out, std::size_t scans,
                              const std::function<Result<WrittenScan>(std::size_t scan)>& scanOf);

}  // namespace planewright
