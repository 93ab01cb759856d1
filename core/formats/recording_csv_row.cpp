// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/recording_csv_row.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "core/formats/number_cells.h"
#include "core/formats/recording_csv.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr double kLatestTime = 9e9;  // [s]; doubles hold microseconds up to here
constexpr double kLargestAngle = 360.0;

/// Reads a range [mm] from `at` on; afterwards `at` stands on the comma or at the end. Negative for what is no range.
int readRange(const char*& at, const char* end)
{
    const char* begin = at;
    std::int64_t value = 0;
    while (at != end && *at >= '0' && *at <= '9') {
        if (value <= kMaxRangeMillimetres)
            value = 10 * value + (*at - '0');
        ++at;
    }
    const bool isRange = at != begin && (at == end || *at == ',') && value <= kMaxRangeMillimetres;
    while (at != end && *at != ',')
        ++at;
    return isRange ? static_cast<int>(value) : -1;
}

}  // namespace

RowReader::RowReader(const RecordingHeader& header) : header_(header)
{
    ranges_.reserve(static_cast<std::size_t>(header.description.beams));
}

/// Finds the cells of a row and reads its ranges; notes what is no range.
void RowReader::split(std::string_view line)
{
    leading_.clear();
    ranges_.clear();
    badRanges_.clear();
    badRangeCount_ = 0;
    cells_ = 0;
    const char* at = line.data();
    const char* const end = at + line.size();
    const std::size_t rangesBegin = header_.rangesBegin();
    const std::size_t columns = header_.columns();
    for (;;) {
        const char* const begin = at;
        if (cells_ < rangesBegin || cells_ >= columns) {
            while (at != end && *at != ',')
                ++at;
            if (cells_ < rangesBegin)
                leading_.push_back({cells_, {begin, static_cast<std::size_t>(at - begin)}});
        } else {
            const int range = readRange(at, end);
            ranges_.push_back(range / 1000.0);
            if (range < 0 && ++badRangeCount_ <= kMaxListedProblems)
                badRanges_.push_back({cells_, {begin, static_cast<std::size_t>(at - begin)}});
        }
        ++cells_;
        if (at == end) {
            lastCellIsEmpty_ = at == begin;
            return;
        }
        ++at;
    }
}

void RowReader::tell(const Cell& cell, std::size_t lineNumber, std::string_view what, ProblemList& problems) const
{
    problems.add(quotedText(cell.text) + " " + std::string{what}, lineNumber, cell.column + 1,
                 header_.columnName(cell.column));
}

void RowReader::tellRowLength(std::size_t lineNumber, ProblemList& problems) const
{
    std::string what = "the row has " + std::to_string(cells_) + (cells_ == 1 ? " cell" : " cells") + " instead of " +
                       std::to_string(header_.columns());
    if (cells_ == 1)
        what += "; separate cells by commas";
    else if (cells_ > header_.columns())
        what += "; remove what is too much, and write decimal points and no decimal commas";
    else
        what += "; complete or remove the row";
    problems.add(what, lineNumber);
}

std::optional<double> RowReader::readAngle(const Cell& cell, std::size_t lineNumber, ProblemList& problems) const
{
    const auto value = readNumber<double>(cell.text);
    if (!value)
        tell(cell, lineNumber, "is not a finite number; give an angle in degrees, with a decimal point", problems);
    else if (std::abs(*value) > kLargestAngle)
        tell(cell, lineNumber, "is out of limits; give an angle from -360 to 360 degrees", problems);
    else
        return degrees(*value);
    return std::nullopt;
}

/// Reads what stands before the ranges; true if all of it is right.
bool RowReader::readLeadingCells(std::size_t lineNumber, ProblemList& problems)
{
    bool good = true;
    const auto bad = [&](const Cell& cell, std::string_view what) {
        tell(cell, lineNumber, what, problems);
        good = false;
    };
    const auto step = readNumber<std::int64_t>(leading_[0].text);
    if (!step || *step < 0 || *step > kMaxStep)
        bad(leading_[0], "is not a slice number; give a whole number from 0 to " + std::to_string(kMaxStep));
    else if (step_ && *step <= *step_)
        bad(leading_[0], "does not rise above " + std::to_string(*step_) +
                             " of the row before; number the slices "
                             "in the order of measurement");
    else
        step_ = static_cast<int>(*step);

    const auto seconds = readNumber<double>(leading_[1].text);
    if (!seconds)
        bad(leading_[1], "is not a finite number; give a time in seconds, with a decimal point");
    else if (std::abs(*seconds) > kLatestTime)
        bad(leading_[1], "is out of limits; give a time within 9000000000 s of zero");
    else {
        const std::chrono::microseconds time{std::llround(*seconds * 1e6)};
        if (time_ && time < *time_)
            bad(leading_[1], "is earlier than the row before; put the rows in the order of measurement");
        else
            time_ = time;
    }

    const auto angle = [&](const Cell& cell) {
        const auto value = readAngle(cell, lineNumber, problems);
        good = good && value;
        return value;
    };
    pitch_ = angle(leading_[2]).value_or(0.0);
    if (header_.description.beamTable && !header_.description.beamTable->isSeenAt(pitch_))
        bad(leading_[2], "looks away from the image that beam_image_pitch_deg tells of; correct one of them");
    if (header_.pitchEnd)
        pitchEnd_ = angle(leading_[3]);
    if (header_.bearingStart)
        bearingStart_ = angle(leading_.back());
    return good;
}

RowReader::Outcome RowReader::read(std::string_view line, bool isWhole, std::size_t lineNumber, ProblemList& problems)
{
    split(line);
    const bool isShort = cells_ < header_.columns() || (cells_ == header_.columns() && lastCellIsEmpty_);
    // What is left of a row has nothing but numbers; other text at the end of a file is no row.
    if (!isWhole && isShort && line.find_first_not_of("0123456789.,+-eE") == std::string_view::npos)
        return Outcome::CutShort;
    if (cells_ != header_.columns()) {
        tellRowLength(lineNumber, problems);
        return Outcome::Bad;
    }
    const bool good = readLeadingCells(lineNumber, problems);
    for (const Cell& cell : badRanges_)
        tell(cell, lineNumber, "is not a range; give whole millimetres from 0 to 1000000, 0 for no return", problems);
    for (std::size_t i = badRanges_.size(); i < badRangeCount_; ++i)
        problems.add({}, lineNumber);
    return good && badRangeCount_ == 0 ? Outcome::Slice : Outcome::Bad;
}

ScanSlice RowReader::slice() const
{
    ScanSlice slice;
    slice.step = *step_;
    slice.time = *time_;
    slice.tilt = pitch_;
    slice.tiltEnd = pitchEnd_;
    slice.firstBearing = bearingStart_.value_or(0.0);
    slice.ownBearing = bearingStart_.has_value();
    layBeams(slice, header_.description);
    slice.ranges = ranges_;
    return slice;
}

}  // namespace planewright
