// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/formats/problem_list.h"
#include "core/formats/recording_csv_header.h"
#include "core/types/scan_slice.h"

namespace planewright {

/// Turns the rows of one recording into slices, and holds what one row says against the row before.
class RowReader {
public:
    explicit RowReader(const RecordingHeader& header);

    enum class Outcome {
        Slice,     ///< slice() is the row's
        CutShort,  ///< a last row that lacks its end and has no other fault
        Bad,       ///< the problems have been told
    };

    /// Reads a row. `isWhole` is false for a line that the file's end cut off before its line end.
    Outcome read(std::string_view line, bool isWhole, std::size_t lineNumber, ProblemList& problems);

    /// The slice of the row read last.
    ScanSlice slice() const;

private:
    struct Cell {
        std::size_t column = 0;
        std::string_view text;
    };

    void split(std::string_view line);
    void tellRowLength(std::size_t lineNumber, ProblemList& problems) const;
    void tell(const Cell& cell, std::size_t lineNumber, std::string_view what, ProblemList& problems) const;
    bool readLeadingCells(std::size_t lineNumber, ProblemList& problems);
    std::optional<double> readAngle(const Cell& cell, std::size_t lineNumber, ProblemList& problems) const;

    const RecordingHeader& header_;
    std::vector<Cell> leading_;      ///< the cells before r0
    std::vector<double> ranges_;     ///< those of the row read last [m]
    std::vector<Cell> badRanges_;    ///< the first of the cells that are no range
    std::size_t badRangeCount_ = 0;  ///< and how many they are
    std::size_t cells_ = 0;          ///< in the row read last
    bool lastCellIsEmpty_ = false;
    std::optional<int> step_;  ///< of the last row that was right in this
    std::optional<std::chrono::microseconds> time_;
    double pitch_ = 0.0;                  ///< [rad]
    std::optional<double> pitchEnd_;      ///< [rad]
    std::optional<double> bearingStart_;  ///< [rad]
};

}  // namespace planewright
