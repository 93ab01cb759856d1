// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/problem_list.h"
#include "core/formats/text_lines.h"
#include "core/types/recording.h"

namespace planewright {

/// What the lines above the first row of a recording say.
struct RecordingHeader {
    ScanDescription description;
    bool pitchEnd = false;      ///< there is a column pitch_end_deg
    bool bearingStart = false;  ///< there is a column bearing_start_deg

    std::size_t rangesBegin() const { return 3U + (pitchEnd ? 1U : 0U) + (bearingStart ? 1U : 0U); }
    std::size_t columns() const { return rangesBegin() + static_cast<std::size_t>(description.beams); }

    /// The name of a column, from 0.
    std::string columnName(std::size_t column) const;
};

/// Reads the header and the line of column names; what is wrong goes to `problems`. Nothing where the rows cannot be
/// understood without what is missing.
std::optional<RecordingHeader> readRecordingHeader(TextLines& lines, ProblemList& problems,
                                                   std::vector<std::string>& warnings);

}  // namespace planewright
