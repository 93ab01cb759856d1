// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <chrono>
#include <cmath>
#include <limits>

#include "core/formats/pwscan_slice.h"
#include "core/formats/recording_csv.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr std::int64_t kLatestSliceTime = 9'000'000'000'000'000;  // [µs], as in CSV
constexpr double kLargestSliceAngle = 360.0;

/// Rows of one scan that may be unreadable until the rest is given up.
constexpr int kMostFailures = 50;

enum SliceColumn { kStep, kTime, kPitch, kPitchEnd, kCommanded, kBearing, kFlags, kCheckSum, kScan, kSize, kRanges };

/// A value of a wrong type becomes a text without being read: it may be larger than the memory.
std::string numberOrText(const std::string& column)
{
    return "CASE typeof(" + column + ") WHEN 'real' THEN " + column + " WHEN 'integer' THEN " + column +
           " WHEN 'null' THEN NULL ELSE '' END, ";
}

std::string wholeOrText(const std::string& column)
{
    return "CASE typeof(" + column + ") WHEN 'integer' THEN " + column + " ELSE '' END, ";
}

/// The rows of a scan and, after them, of the next: an upper bound would make SQLite load every row as a whole, with
/// all the ranges that it says it has, only to compare its key.
std::string selection()
{
    return "SELECT " + wholeOrText("step") + wholeOrText("time_us") + numberOrText("pitch_deg") +
           numberOrText("pitch_end_deg") + numberOrText("pitch_commanded_deg") + numberOrText("bearing_start_deg") +
           wholeOrText("flags") + wholeOrText("crc32") + wholeOrText("scan_id") +
           "CASE typeof(ranges) WHEN 'blob' THEN length(ranges) ELSE -1 END, "
           "CASE WHEN typeof(ranges)='blob' AND length(ranges)=?1 THEN ranges END "
           "FROM slice NOT INDEXED WHERE (scan_id, step)>(?2, ?3) ORDER BY scan_id, step LIMIT -1 OFFSET ?4";
}

/// Turns the rows of one scan into slices, and holds each against the one before.
class SliceRows {
public:
    SliceRows(const SqlStatement& row, const ScanDescription& description) : row_(row), description_(description) {}

    /// The slice of the row; nothing where `problem` says what is wrong.
    std::optional<ScanSlice> read();

    std::string problem;

private:
    std::optional<double> angle(SliceColumn column, const char* name, bool mayLack);
    bool readRanges(ScanSlice& slice);
    void tell(const std::string& what)
    {
        if (problem.empty())
            problem = what;
    }

    const SqlStatement& row_;
    const ScanDescription& description_;
    std::optional<std::int64_t> step_;
    std::optional<std::int64_t> time_;
};

/// An angle [rad], from degrees.
std::optional<double> SliceRows::angle(SliceColumn column, const char* name, bool mayLack)
{
    if (mayLack && row_.isNull(column))
        return std::nullopt;
    const SqlStatement::Type type = row_.type(column);
    const double value = row_.real(column);
    if ((type != SqlStatement::Type::Real && type != SqlStatement::Type::Integer) ||
        !(std::abs(value) <= kLargestSliceAngle))
        tell(std::string{name} + " is no angle from -360 to 360 degrees");
    return degrees(value);
}

bool SliceRows::readRanges(ScanSlice& slice)
{
    const auto beams = static_cast<std::size_t>(description_.beams);
    const std::string_view bytes = row_.blob(kRanges);
    if (bytes.size() != 4 * beams) {
        tell("ranges has " + std::to_string(row_.integer(kSize)) + " bytes instead of " + std::to_string(4 * beams));
        return false;
    }
    if (row_.integerIf(kCheckSum) != std::int64_t{checkSum(bytes)}) {
        tell("crc32 is not the check sum of the ranges");
        return false;
    }
    slice.ranges.resize(beams);
    for (std::size_t beam = 0; beam < beams; ++beam) {
        std::uint32_t millimetres = 0;
        for (std::size_t byte = 4; byte-- > 0;)
            millimetres = millimetres << 8 | static_cast<unsigned char>(bytes[4 * beam + byte]);
        if (millimetres > static_cast<std::uint32_t>(kMaxRangeMillimetres)) {
            tell("the range of beam " + std::to_string(beam) + " is above " + std::to_string(kMaxRangeMillimetres) +
                 " mm");
            return false;
        }
        slice.ranges[beam] = millimetres / 1000.0;
    }
    return true;
}

std::optional<ScanSlice> SliceRows::read()
{
    problem.clear();
    const auto step = row_.integerIf(kStep);
    if (!step || *step < 0 || *step > kMaxStep)
        tell("step is no whole number from 0 to " + std::to_string(kMaxStep));
    else if (step_ && *step <= *step_)
        tell("step does not rise");
    const auto time = row_.integerIf(kTime);
    if (!time || *time < -kLatestSliceTime || *time > kLatestSliceTime)
        tell("time_us is no whole number within its limits");
    else if (time_ && *time < *time_)
        tell("time_us is earlier than that of the slice before");

    ScanSlice slice;
    slice.tilt = angle(kPitch, "pitch_deg", false).value_or(0.0);
    slice.tiltEnd = angle(kPitchEnd, "pitch_end_deg", true);
    slice.tiltCommanded = angle(kCommanded, "pitch_commanded_deg", true);
    const auto bearing = angle(kBearing, "bearing_start_deg", true);
    if (description_.beamTable && !description_.beamTable->isSeenAt(slice.tilt))
        tell("pitch_deg looks away from the image");
    if (bearing && description_.beamTable)
        tell("bearing_start_deg has no meaning beside beam_bearings_deg");
    const auto flags = row_.integerIf(kFlags);
    if (!flags)
        tell("flags is no whole number");
    if (!readRanges(slice) || !problem.empty())
        return std::nullopt;
    step_ = step;
    time_ = time;
    slice.step = static_cast<int>(*step);
    slice.time = std::chrono::microseconds{*time};
    slice.firstBearing = bearing.value_or(0.0);
    slice.ownBearing = bearing.has_value();
    layBeams(slice, description_);
    slice.angleSuspect = (*flags & kSliceAngleSuspect) != 0;
    slice.timeSuspect = (*flags & kSliceTimeSuspect) != 0;
    slice.retaken = (*flags & kSliceRetaken) != 0;
    return slice;
}

}  // namespace

Result<void> readSlices(SqlDatabase& database, int scan, const ScanDescription& description, std::size_t& ranges,
                        const SliceListener& listener)
{
    const auto beams = static_cast<std::size_t>(description.beams);
    const auto tell = [&](std::string_view where, std::string_view what) {
        std::string problem = "scan " + std::to_string(scan);
        problem.append(where).append(what);
        listener.onProblem(problem);
    };
    auto rows = database.prepare(selection());
    if (!rows)
        return tl::unexpected{rows.error()};
    SliceRows reader{*rows, description};
    std::int64_t last = std::numeric_limits<std::int64_t>::min();
    std::int64_t unreadable = 0;  // rows after `last`
    int failures = 0;
    rows->bind(static_cast<std::int64_t>(4 * beams)).bind(std::int64_t{scan}).bind(last).bind(unreadable);
    for (int row = 0;;) {
        const Result<bool> there = rows->step();
        if (!there) {
            const std::string after = row == 0 ? "at its beginning" : "after step " + std::to_string(last);
            if (!database.failedByDamage() || ++failures > kMostFailures) {
                tell(": the slices ", after + " cannot be read, the file is damaged; those before are used");
                return {};
            }
            tell(": a slice ", after + " cannot be read, the file is damaged; it is not used");
            rows->reset();
            rows->bind(static_cast<std::int64_t>(4 * beams)).bind(std::int64_t{scan}).bind(last).bind(++unreadable);
            continue;
        }
        if (!*there || rows->integerIf(kScan) != std::int64_t{scan})
            return {};
        if (row++ == kMaxSlices || (ranges += beams) > kMaxRanges) {
            tell(": there are more slices than a recording may hold; the first ",
                 std::to_string(row - 1) + " are used");
            return {};
        }
        const auto step = rows->integerIf(kStep);
        if (auto slice = reader.read())
            listener.onSlice(std::move(*slice));
        else
            tell(", step " + (step ? std::to_string(*step) : std::string{"?"}) + ": ",
                 reader.problem + "; the slice is not used");
        if (step && *step > last) {
            last = *step;
            unreadable = 0;
        }
    }
}

}  // namespace planewright
