// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <ostream>

#include "core/formats/geometry_keys.h"
#include "core/formats/gzip_text.h"
#include "core/formats/number_text.h"
#include "core/formats/recording_csv.h"
#include "core/formats/written.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

/// Text in pieces to a stream, compressed where asked for.
class TextSink {
public:
    TextSink(std::ostream& out, bool gzip) : out_(out), gzip_(gzip ? std::make_unique<GzipText>() : nullptr) {}

    void write(std::string_view piece, bool finish)
    {
        if (!gzip_) {
            out_.write(piece.data(), static_cast<std::streamsize>(piece.size()));
            return;
        }
        compressed_.clear();
        gzip_->add(piece, finish, compressed_);
        out_.write(compressed_.data(), static_cast<std::streamsize>(compressed_.size()));
    }

private:
    std::ostream& out_;
    std::unique_ptr<GzipText> gzip_;
    std::string compressed_;
};

void appendWhole(std::string& text, long long value)
{
    char buffer[24];
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

/// Seconds with six decimals, from whole microseconds so that no digit is lost.
void appendSeconds(std::string& text, std::chrono::microseconds time)
{
    const long long count = time.count();
    if (count < 0)
        text += '-';
    appendWhole(text, std::abs(count / 1'000'000));
    const std::string decimals = std::to_string(std::abs(count % 1'000'000));
    text += '.';
    text.append(6 - decimals.size(), '0');
    text += decimals;
}

void appendKey(std::string& text, std::string_view key, std::string_view value)
{
    const std::size_t begin = text.size();
    text += "# ";
    text += key;
    text += " = ";
    text += value;
    // A line end in a name would begin a line of its own.
    std::replace_if(
        text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
    text += '\n';
}

struct Columns {
    bool pitchEnd = false;
    bool bearingStart = false;
};

void appendHeader(std::string& text, const ScanDescription& description, Columns columns)
{
    appendKey(text, "format", "nodding-laser-csv 1");
    if (!description.scanner.empty())
        appendKey(text, "scanner", description.scanner);
    appendKey(text, "bearing_start_deg", formatNumber(toDegrees(description.firstBearing)));
    appendKey(text, "bearing_step_deg", formatNumber(toDegrees(description.bearingStep)));
    appendKey(text, "beams", std::to_string(description.beams));
    appendKey(text, "range_min_m", formatNumber(description.rangeMin));
    appendKey(text, "range_max_m", formatNumber(description.rangeMax));
    appendKey(text, "pitch_axis_offset_m", formatNumber(description.pitchAxisOffset));
    for (const auto& [key, value] : keysOf(description))
        appendKey(text, key, value);
    text += "slice,time_s,pitch_deg";
    text += columns.pitchEnd ? ",pitch_end_deg" : "";
    text += columns.bearingStart ? ",bearing_start_deg" : "";
    for (int beam = 0; beam < description.beams; ++beam) {
        text += ",r";
        appendWhole(text, beam);
    }
    text += '\n';
}

/// Appends a row; false where a range is more than the format holds.
bool appendRow(std::string& text, const ScanSlice& slice, Columns columns)
{
    appendWhole(text, slice.step);
    text += ',';
    appendSeconds(text, slice.time);
    text += ',';
    appendNumber(text, toDegrees(slice.tilt));
    if (columns.pitchEnd) {
        text += ',';
        appendNumber(text, toDegrees(slice.tiltEnd.value_or(slice.tilt)));
    }
    if (columns.bearingStart) {
        text += ',';
        appendNumber(text, toDegrees(slice.firstBearing));
    }
    for (const double range : slice.ranges) {
        const double millimetres = range > 0.0 ? std::floor(range * 1000.0 + 0.5) : 0.0;
        if (millimetres > kMaxRangeMillimetres)
            return false;
        text += ',';
        appendWhole(text, static_cast<long long>(millimetres));
    }
    text += '\n';
    return true;
}

}  // namespace

Result<void> writeRecordingCsv(std::ostream& out, const Recording& recording, bool gzip)
{
    Columns columns;
    for (const ScanSlice& slice : recording.slices) {
        if (slice.ranges.size() != static_cast<std::size_t>(recording.description.beams))
            return fail(ErrorCode::Internal, "slice " + std::to_string(slice.step) + " has " +
                                                 std::to_string(slice.ranges.size()) + " beams instead of " +
                                                 std::to_string(recording.description.beams));
        columns.pitchEnd = columns.pitchEnd || slice.tiltEnd.has_value();
        columns.bearingStart = columns.bearingStart || slice.ownBearing;
    }

    TextSink sink{out, gzip};
    std::string text;
    appendHeader(text, recording.description, columns);
    for (const ScanSlice& slice : recording.slices) {
        sink.write(text, false);
        text.clear();
        if (!appendRow(text, slice, columns))
            return fail(ErrorCode::NotWritten, "slice " + std::to_string(slice.step) + " has a range above " +
                                                   std::to_string(kMaxRangeMillimetres) +
                                                   " mm, which a recording cannot hold; limit the ranges");
    }
    sink.write(text, true);
    return written(out);
}

}  // namespace planewright
