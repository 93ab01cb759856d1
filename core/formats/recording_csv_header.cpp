// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/recording_csv_header.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/formats/geometry_keys.h"
#include "core/formats/number_cells.h"
#include "core/formats/number_text.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr std::string_view kFormat = "nodding-laser-csv 1";
constexpr std::size_t kMostHeaderLines = 1000;
constexpr std::size_t kMostHeaderBytes = std::size_t{1} << 20;  ///< all keys are kept in memory

/// A header key whose value is a number, and its limits, which are whole.
struct NumberKey {
    std::string_view key;
    double lowest;
    double highest;
    bool lowestAllowed;
    std::string_view unit;
};
enum NumberKeyIndex : std::size_t {
    kBearingStart,
    kBearingStep,
    kBeams,
    kRangeMin,
    kRangeMax,
    kAxisOffset,
    kNumberKeys
};
constexpr std::array<NumberKey, kNumberKeys> kKeys{{
    {"bearing_start_deg", -360.0, 360.0, true, "degrees"},
    {"bearing_step_deg", 0.0, 360.0, false, "degrees"},
    {"beams", 1.0, kMaxBeams, true, ""},
    {"range_min_m", 0.0, 1e6, true, "metres"},
    {"range_max_m", 0.0, 1e6, false, "metres"},
    {"pitch_axis_offset_m", -10.0, 10.0, true, "metres"},
}};

std::string allowed(const NumberKey& key)
{
    const auto whole = [](double limit) { return std::to_string(static_cast<int>(limit)); };
    std::string text = key.key == "beams" ? "give a whole number " : "give a number ";
    text += key.lowestAllowed ? "from " + whole(key.lowest) + " to " : "above " + whole(key.lowest) + ", at most ";
    text += whole(key.highest);
    return key.unit.empty() ? text : text + " " + std::string{key.unit};
}

/// One pass over the header of one file.
class HeaderReader {
public:
    HeaderReader(TextLines& lines, ProblemList& problems, std::vector<std::string>& warnings)
        : lines_(lines), problems_(problems), warnings_(warnings)
    {
    }

    std::optional<RecordingHeader> read();

private:
    void add(std::string_view what, std::string_view name = {}) { problems_.add(what, lines_.number(), 0, name); }
    bool readKey(std::string_view line);
    void setKey(std::string_view key, std::string_view value);
    void setNumber(std::size_t index, std::string_view text);
    bool readColumns(std::string_view line);
    bool takeGeometry();
    void checkCompleteness();
    void checkValues();
    void fillDescription();

    TextLines& lines_;
    ProblemList& problems_;
    std::vector<std::string>& warnings_;
    std::vector<std::string> seen_;
    std::array<double, kNumberKeys> values_{};
    std::array<bool, kNumberKeys> valid_{};
    std::size_t rangeMaxLine_ = 0;
    std::size_t bytes_ = 0;
    RecordingHeader header_;
};

std::optional<RecordingHeader> HeaderReader::read()
{
    while (const auto line = lines_.next()) {
        if (line->find('\r') != std::string_view::npos) {
            add("the line ends are carriage returns alone; save the file with LF or CRLF line ends");
            return std::nullopt;
        }
        if (line->starts_with('#')) {
            if (!lines_.terminated())
                break;
            if (!readKey(*line))
                return std::nullopt;
            continue;
        }
        if (seen_.empty() && !line->starts_with("slice")) {
            const bool utf16 = line->starts_with("\xFF\xFE") || line->starts_with("\xFE\xFF");
            add(utf16 ? "the file is UTF-16; save it as UTF-8"
                      : "this is not a recording: the first line is not '# key = value'; give a file of the format '" +
                            std::string{kFormat} + "'");
            return std::nullopt;
        }
        checkCompleteness();
        checkValues();
        fillDescription();
        if (problems_.endsReading() || !readColumns(*line) || !takeGeometry())
            return std::nullopt;
        return header_;
    }
    if (!lines_.problem().empty())
        return std::nullopt;
    if (lines_.number() != 0)
        add("the file ends before the line of column names; get the whole file");
    else if (lines_.cutShort())
        add("the compressed file was cut short before its first line; get the whole file");
    else
        add("the file is empty; give a recording of the format '" + std::string{kFormat} + "'");
    return std::nullopt;
}

/// True where reading goes on.
bool HeaderReader::readKey(std::string_view line)
{
    // Spreadsheets fill every line up with commas to the width of the widest.
    line = line.substr(0, line.find_last_not_of(", \t") + 1);
    const std::size_t equals = line.find('=');
    const std::string_view key =
        equals == std::string_view::npos ? std::string_view{} : trimmed(line.substr(1, equals - 1));
    if (seen_.size() == kMostHeaderLines) {
        add("more than " + std::to_string(kMostHeaderLines) + " header lines; remove those that are not needed");
        return false;
    }
    bytes_ += line.size();
    if (bytes_ > kMostHeaderBytes) {
        add("more than " + std::to_string(kMostHeaderBytes) +
            " bytes of header lines; remove those that are not needed");
        return false;
    }
    if (key.empty())
        add("the header line is not of the form '# key = value'; complete or remove it");
    else if (!isPlainUtf8(line))
        add("the header line holds control characters or is not UTF-8; save the file as UTF-8");
    else if (std::find(seen_.begin(), seen_.end(), key) != seen_.end())
        add("the key is there twice; remove one of the two", key);
    else
        setKey(key, trimmed(line.substr(equals + 1)));
    seen_.emplace_back(key);
    return !problems_.endsReading();
}

void HeaderReader::setKey(std::string_view key, std::string_view value)
{
    const auto number = std::find_if(kKeys.begin(), kKeys.end(), [&](const NumberKey& k) { return k.key == key; });
    if (number != kKeys.end())
        setNumber(static_cast<std::size_t>(number - kKeys.begin()), value);
    else if (key == "scanner")
        header_.description.scanner = value;
    else if (key == "format") {
        if (value != kFormat)
            add(quotedText(value) + " is not a format that this program reads; give '" + std::string{kFormat} + "'",
                key);
    } else {
        header_.description.extra.emplace_back(key, value);
        if (isGeometryKey(key) || key.starts_with("recovered_"))
            return;
        warnings_.push_back(placeInFile(problems_.fileName(), lines_.number(), 0, key) +
                            "the key is not known; it is kept and not used");
    }
}

void HeaderReader::setNumber(std::size_t index, std::string_view text)
{
    const NumberKey& key = kKeys[index];
    if (key.key == "range_max_m")
        rangeMaxLine_ = lines_.number();
    const auto value = readNumber<double>(text);
    if (!value) {
        const bool comma = text.find(',') != std::string_view::npos;
        add(quotedText(text) + " is not a number; " + (comma ? "write a decimal point" : allowed(key)), key.key);
        return;
    }
    const bool whole = key.key != "beams" || *value == std::floor(*value);
    if (!whole || *value > key.highest || *value < key.lowest || (*value == key.lowest && !key.lowestAllowed)) {
        add(quotedText(text) + " is not allowed; " + allowed(key), key.key);
        return;
    }
    values_[index] = *value;
    valid_[index] = true;
}

void HeaderReader::checkCompleteness()
{
    std::string missing;
    const auto need = [&](std::string_view key) {
        if (std::find(seen_.begin(), seen_.end(), key) == seen_.end())
            missing += (missing.empty() ? "" : ", ") + std::string{key};
    };
    need("format");
    for (const NumberKey& key : kKeys)
        need(key.key);
    if (!missing.empty())
        add("the header above lacks " + missing + "; add '# key = value' for each");
}

void HeaderReader::checkValues()
{
    if (valid_[kRangeMin] && valid_[kRangeMax] && values_[kRangeMax] <= values_[kRangeMin])
        problems_.add(
            "must be above range_min_m, which is " + formatNumber(values_[kRangeMin]) + "; correct one of them",
            rangeMaxLine_, 0, kKeys[kRangeMax].key);
    if (valid_[kBearingStep] && valid_[kBeams] && values_[kBearingStep] * (values_[kBeams] - 1.0) > 360.0)
        warnings_.push_back(placeInFile(problems_.fileName(), 0) +
                            "the beams go round more than a full turn; check bearing_step_deg and beams");
}

void HeaderReader::fillDescription()
{
    ScanDescription& description = header_.description;
    description.firstBearing = degrees(values_[kBearingStart]);
    description.bearingStep = degrees(values_[kBearingStep]);
    description.beams = static_cast<int>(values_[kBeams]);
    description.rangeMin = values_[kRangeMin];
    description.rangeMax = values_[kRangeMax];
    description.pitchAxisOffset = values_[kAxisOffset];
}

/// Walks along the names and takes out which of the optional columns there are. True where rows can be read.
bool HeaderReader::readColumns(std::string_view line)
{
    static constexpr std::array<std::string_view, 3> kFirst{"slice", "time_s", "pitch_deg"};
    std::size_t column = 0;
    std::size_t begin = 0;
    std::size_t ranges = 0;
    for (bool more = true; more; ++column) {
        const std::size_t comma = line.find(',', begin);
        const std::string_view name = line.substr(begin, comma - begin);
        more = comma != std::string_view::npos;
        begin = comma + 1;
        std::string expected;
        if (column < kFirst.size())
            expected = kFirst[column];
        else if (ranges == 0 && name == "pitch_end_deg" && !header_.pitchEnd && !header_.bearingStart) {
            header_.pitchEnd = true;
            continue;
        } else if (ranges == 0 && name == "bearing_start_deg" && !header_.bearingStart) {
            header_.bearingStart = true;
            continue;
        } else
            expected = "r" + std::to_string(ranges++);
        if (name == expected)
            continue;
        if (!more && !lines_.terminated()) {
            add("the file ends in the line of column names; get the whole file");
            return false;
        }
        const bool separator = !more && column == 0 && name.find_first_of(";\t") != std::string_view::npos;
        problems_.add(separator ? "the columns are not separated by commas; save the file with ',' between columns and "
                                  "'.' in numbers"
                                : quotedText(name) + " stands where '" + expected +
                                      "' belongs; name the columns slice,time_s,pitch_deg,r0,r1,... without gaps",
                      lines_.number(), column + 1);
        return false;
    }
    if (ranges == 0) {
        add("the column names end before r0; name a column for each beam");
        return false;
    }
    if (valid_[kBeams] && ranges != static_cast<std::size_t>(header_.description.beams)) {
        add("the columns r0 to r" + std::to_string(ranges - 1) + " are " + std::to_string(ranges) +
            " beams and the header says beams = " + std::to_string(header_.description.beams) +
            "; correct one of them");
        return false;
    }
    if (ranges > static_cast<std::size_t>(kMaxBeams)) {
        add("more than " + std::to_string(kMaxBeams) + " beams; a recording cannot hold them");
        return false;
    }
    header_.description.beams = static_cast<int>(ranges);
    return true;
}

bool HeaderReader::takeGeometry()
{
    std::string problem = takeGeometryKeys(header_.description);
    if (problem.empty() && header_.bearingStart && header_.description.beamTable)
        problem = "the column bearing_start_deg has no meaning beside beam_bearings_deg";
    if (!problem.empty())
        add("in the header above " + problem + "; correct or remove it");
    return problem.empty();
}

}  // namespace

std::string RecordingHeader::columnName(std::size_t column) const
{
    if (column < 3)
        return std::array<std::string, 3>{"slice", "time_s", "pitch_deg"}[column];
    if (column >= rangesBegin())
        return "r" + std::to_string(column - rangesBegin());
    return column == 3 && pitchEnd ? "pitch_end_deg" : "bearing_start_deg";
}

std::optional<RecordingHeader> readRecordingHeader(TextLines& lines, ProblemList& problems,
                                                   std::vector<std::string>& warnings)
{
    return HeaderReader{lines, problems, warnings}.read();
}

}  // namespace planewright
