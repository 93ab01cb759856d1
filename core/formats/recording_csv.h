// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "core/types/error.h"
#include "core/types/recording.h"

namespace planewright {

/// Largest step number that a recording file may hold.
inline constexpr int kMaxStep = 1'000'000'000;

/// Largest range a file may hold [mm].
inline constexpr int kMaxRangeMillimetres = 1'000'000;

/// A recording as it was read, and what its owner should hear about the file.
struct ReadRecording {
    Recording recording;
    std::vector<std::string> warnings;  ///< one line each, beginning with the file's name
    bool damaged = false;               ///< the file was cut short; what was complete is here
    int slicesLeftOut = 0;              ///< of the damage, as far as they can be counted
};

/// Reads a recording from CSV text or from the same compressed with gzip (told apart by the first two bytes).
///
/// Ranges come as the file has them, metres instead of millimetres: those outside rangeMin…rangeMax stay, and are no
/// returns. Line ends may be LF or CRLF, a byte order mark and blank lines at the end are passed over, and so are
/// commas at the end of a header line, which spreadsheets add. A last row that was cut short is dropped (damaged).
/// Errors (Unreadable): anything else that is not as the format says, with the file's name, line and column and what
/// to do. Limits beyond the format's: lines of 1 MiB, 1,000 header lines, steps up to kMaxStep, kMaxRanges ranges,
/// pitches and bearings within ±360°, times within ±9e9 s, a pitch axis offset within ±10 m.
Result<ReadRecording> readRecordingCsv(std::istream& in, const std::string& fileName);

/// All that is wrong with a recording file.
struct RecordingProblems {
    std::vector<std::string> problems;  ///< in the order of the file, at most kMaxListedProblems
    std::size_t more = 0;               ///< problems that were found beyond those
    std::vector<std::string> warnings;
    bool damaged = false;  ///< the file was cut short; no problem if a complete row remains
};
inline constexpr std::size_t kMaxListedProblems = 100;

/// Reads a recording as readRecordingCsv does, but goes on after an error where the rest can still be understood.
/// Without problems the file is one that readRecordingCsv reads.
RecordingProblems recordingProblems(std::istream& in, const std::string& fileName);

/// Writes a recording as CSV, or as the same compressed with gzip (the same bytes whenever and wherever).
///
/// The columns pitch_end_deg and bearing_start_deg are there if any slice uses them. Ranges are rounded to whole
/// millimetres, half up; ranges that are negative or no number become 0, no return; control characters in texts become
/// blanks. Reading what was written and writing it again gives the same bytes.
/// Errors: NotWritten where the stream fails, or where a range exceeds what the format can hold; Internal where a slice
/// has another number of beams than the description says.
Result<void> writeRecordingCsv(std::ostream& out, const Recording& recording, bool gzip);

}  // namespace planewright
