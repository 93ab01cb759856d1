// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/pcd_header.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/formats/message_text.h"
#include "core/formats/number_cells.h"
#include "core/formats/words.h"
#include "core/types/recording.h"

namespace planewright {

namespace {

constexpr std::size_t kLongestHeaderLine = 4096;
constexpr std::size_t kMostPcdLines = 100;
constexpr std::size_t kMostFields = 64;
constexpr std::size_t kMostValues = 1024;  ///< of one field in a point

class PcdHeaderReader {
public:
    PcdHeaderReader(ByteReader& reader, const std::string& fileName) : reader_(reader), fileName_(fileName) {}

    Result<PcdHeader> read();

private:
    struct Line {
        std::size_t number = 0;
        std::vector<std::string> words;
    };

    /// Takes the lines in, each key once. False where problem_ says what is wrong.
    bool collect();
    bool collectLine(std::string_view text);
    void takeFields();
    void takeSize();
    void takeViewpoint();
    void takeData();
    const std::vector<std::string>* wordsOf(std::string_view key, bool needed);
    std::size_t wholeNumber(const std::string& word, std::string_view key, std::size_t least, std::size_t most);
    void tell(std::string_view key, const std::string& what)
    {
        if (problem_.empty()) {
            const auto found = lines_.find(key);
            problem_ =
                placeInFile(fileName_, found != lines_.end() ? found->second.number : reader_.lineNumber(), 0, key) +
                what;
        }
    }

    ByteReader& reader_;
    const std::string& fileName_;
    std::map<std::string, Line, std::less<>> lines_;
    PcdHeader header_;
    std::string problem_;
};

bool PcdHeaderReader::collect()
{
    while (const auto text = reader_.line(kLongestHeaderLine)) {
        if (!collectLine(*text))
            return false;
        if (lines_.contains("DATA"))
            return true;
    }
    tell({}, !reader_.problem().empty() ? reader_.problem()
             : lines_.empty()           ? "this is no .pcd file; its first lines are a header with FIELDS and DATA"
                                        : "the header ends without DATA, or its lines are longer than " +
                                    std::to_string(kLongestHeaderLine) + " bytes; get the whole file");
    return false;
}

bool PcdHeaderReader::collectLine(std::string_view text)
{
    if (reader_.lineNumber() > kMostPcdLines) {
        tell({}, "more than " + std::to_string(kMostPcdLines) + " header lines; this is no .pcd file");
        return false;
    }
    const std::vector<std::string_view> words = wordsIn(text, 2 * kMostFields);
    if (words.empty() || words.front().starts_with('#'))
        return true;
    static constexpr std::array<std::string_view, 10> kKeys{"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                                            "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
    if (std::find(kKeys.begin(), kKeys.end(), words.front()) == kKeys.end()) {
        tell({}, quotedText(words.front()) + " is no key of a .pcd header; correct or remove the line");
        return false;
    }
    Line line{reader_.lineNumber(), {words.begin() + 1, words.end()}};
    if (!lines_.emplace(words.front(), std::move(line)).second) {
        tell({}, "the key " + std::string{words.front()} + " is there twice; remove one of the two");
        return false;
    }
    return true;
}

const std::vector<std::string>* PcdHeaderReader::wordsOf(std::string_view key, bool needed)
{
    const auto found = lines_.find(key);
    if (found != lines_.end())
        return &found->second.words;
    if (needed)
        tell({}, "the header above lacks " + std::string{key} + "; add it");
    return nullptr;
}

std::size_t PcdHeaderReader::wholeNumber(const std::string& word, std::string_view key, std::size_t least,
                                         std::size_t most)
{
    const auto number = readNumber<std::size_t>(word);
    if (!number || *number < least || *number > most) {
        tell(key, quotedText(word) + " is no whole number from " + std::to_string(least) + " to " +
                      std::to_string(most) + "; correct it");
        return least;
    }
    return *number;
}

void PcdHeaderReader::takeFields()
{
    const auto* names = wordsOf("FIELDS", true);
    if (names == nullptr)
        return;
    if (names->empty() || names->size() > kMostFields) {
        tell("FIELDS", "there are no names, or more than " + std::to_string(kMostFields) + "; give x y z at least");
        return;
    }
    const auto ofFields = [&](std::string_view key, bool needed) {
        const auto* words = wordsOf(key, needed);
        if (words != nullptr && words->size() != names->size()) {
            tell(key, "has " + std::to_string(words->size()) + " values for " + std::to_string(names->size()) +
                          " fields; give one for each");
            words = nullptr;
        }
        return words;
    };
    const auto* sizes = ofFields("SIZE", true);
    const auto* types = ofFields("TYPE", true);
    const auto* counts = ofFields("COUNT", false);
    if (!problem_.empty())
        return;
    for (std::size_t i = 0; i < names->size(); ++i) {
        PcdHeader::Field field{(*names)[i], wholeNumber((*sizes)[i], "SIZE", 1, 8), (*types)[i].front(), 1};
        if ((*types)[i].size() != 1 || std::string_view{"FIU"}.find(field.type) == std::string_view::npos)
            tell("TYPE", quotedText((*types)[i]) + " is none of F, I and U; correct it");
        if (field.size == 3 || (field.size > 4 && field.size < 8))
            tell("SIZE", quotedText((*sizes)[i]) + " is none of 1, 2, 4 and 8; correct it");
        if (counts != nullptr)
            field.count = wholeNumber((*counts)[i], "COUNT", 1, kMostValues);
        header_.fields.push_back(std::move(field));
    }
    constexpr std::array<std::string_view, 3> kCoordinates{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto named = [&](const PcdHeader::Field& field) { return field.name == kCoordinates[axis]; };
        const auto found = std::find_if(header_.fields.begin(), header_.fields.end(), named);
        if (std::count_if(header_.fields.begin(), header_.fields.end(), named) != 1 || found->type != 'F' ||
            found->size < 4 || found->count != 1) {
            tell("FIELDS", std::string{kCoordinates[axis]} +
                               " is not there once, as one value of TYPE F and SIZE 4 or 8; give points with x, y, z");
            return;
        }
        header_.coordinates[axis] = static_cast<std::size_t>(found - header_.fields.begin());
    }
}

void PcdHeaderReader::takeSize()
{
    const auto number = [&](std::string_view key, std::size_t most) {
        const auto* words = wordsOf(key, true);
        if (words != nullptr && words->size() != 1)
            tell(key, "is no single number; correct it");
        return words == nullptr || words->size() != 1 ? 0 : wholeNumber(words->front(), key, 1, most);
    };
    const std::size_t columns = number("WIDTH", kMaxRanges);
    const std::size_t rows = number("HEIGHT", kMaxSlices);
    if (problem_.empty() && rows == 1)
        tell("HEIGHT", "the cloud is not organised: rows and columns are lost; give one whose HEIGHT is above 1");
    if (problem_.empty() && columns > static_cast<std::size_t>(kMaxBeams))
        tell("WIDTH", "more than " + std::to_string(kMaxBeams) + " points in a row; a recording cannot hold them");
    if (problem_.empty() && columns * rows > kMaxRanges)
        tell("WIDTH", "more than " + std::to_string(kMaxRanges) + " points; divide the cloud");
    const auto* points = wordsOf("POINTS", false);
    if (points != nullptr && (points->size() != 1 || readNumber<std::size_t>(points->front()) != columns * rows))
        tell("POINTS", "is not WIDTH times HEIGHT, " + std::to_string(columns * rows) + "; correct one of them");
    header_.columns = static_cast<int>(columns);
    header_.rows = static_cast<int>(rows);
}

void PcdHeaderReader::takeViewpoint()
{
    const auto* words = wordsOf("VIEWPOINT", false);
    if (words == nullptr)
        return;
    std::vector<double> values;
    for (const std::string& word : *words) {
        const auto value = readNumber<double>(word);
        if (value && std::abs(*value) <= 1e9)
            values.push_back(*value);
    }
    if (values.size() != 7 || words->size() != 7)
        tell("VIEWPOINT", "is not of the form x y z qw qx qy qz; correct or remove it");
    else
        header_.viewpoint = {values[0], values[1], values[2]};
}

void PcdHeaderReader::takeData()
{
    const auto* words = wordsOf("DATA", true);
    const std::string kind = words != nullptr && words->size() == 1 ? words->front() : std::string{};
    if (kind == "ascii")
        header_.data = PcdHeader::Data::Ascii;
    else if (kind == "binary")
        header_.data = PcdHeader::Data::Binary;
    else if (kind == "binary_compressed")
        header_.data = PcdHeader::Data::Compressed;
    else
        tell("DATA", "is none of ascii, binary and binary_compressed; correct it");
}

Result<PcdHeader> PcdHeaderReader::read()
{
    if (collect()) {
        takeFields();
        takeSize();
        takeViewpoint();
        takeData();
    }
    if (!problem_.empty())
        return fail(ErrorCode::Unreadable, problem_);
    return std::move(header_);
}

}  // namespace

std::size_t PcdHeader::valueBefore(std::size_t field) const
{
    std::size_t sum = 0;
    for (std::size_t i = 0; i < field; ++i)
        sum += fields[i].count;
    return sum;
}

std::size_t PcdHeader::offsetOf(std::size_t field) const
{
    std::size_t sum = 0;
    for (std::size_t i = 0; i < field; ++i)
        sum += fields[i].size * fields[i].count;
    return sum;
}

std::size_t PcdHeader::valuesOfPoint() const
{
    return valueBefore(fields.size());
}

std::size_t PcdHeader::bytesOfPoint() const
{
    return offsetOf(fields.size());
}

Result<PcdHeader> readPcdHeader(ByteReader& reader, const std::string& fileName)
{
    return PcdHeaderReader{reader, fileName}.read();
}

}  // namespace planewright
