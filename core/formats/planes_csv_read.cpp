// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <istream>
#include <utility>

#include "core/formats/csv_record.h"
#include "core/formats/message_text.h"
#include "core/formats/number_cells.h"
#include "core/formats/plane_record_list.h"
#include "core/formats/planes_csv.h"
#include "core/formats/text_lines.h"

namespace planewright {

namespace {

constexpr std::string_view kFormatLine = "# format = planewright-planes 1";
constexpr std::size_t kLongestRow = std::size_t{16} << 20;

/// Columns that are read; the first five must be there.
enum PlaneColumn : std::size_t { kId, kNx, kNy, kNz, kD, kPoints, kName, kClass, kColumns };
constexpr std::array<std::string_view, kColumns> kColumnNames{"id", "nx", "ny", "nz", "d", "points", "name", "class"};
constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);

class PlanesCsvReader {
public:
    PlanesCsvReader(std::istream& in, std::string fileName) : lines_(in, kLongestRow), fileName_(std::move(fileName)) {}

    Result<std::vector<PlaneRecord>> read();

private:
    tl::unexpected<Error> refuse(std::size_t line, const std::string& what, std::size_t column = 0,
                                 std::string_view name = {}) const
    {
        return fail(ErrorCode::Unreadable, placeInFile(fileName_, line, column, name) + what);
    }
    Result<void> readFormat();
    Result<void> readColumns();
    Result<PlaneRecord> readPlane(const CsvRecord& record) const;
    template <class Number>
    Result<Number> readCell(const CsvRecord& record, PlaneColumn column, std::string_view wanted) const;

    TextLines lines_;
    std::string fileName_;
    std::string problem_;
    std::array<std::size_t, kColumns> places_{};
    std::size_t columns_ = 0;
};

Result<void> PlanesCsvReader::readFormat()
{
    const auto line = lines_.next();
    if (!line && !lines_.problem().empty())
        return refuse(lines_.problemLine(), lines_.problem());
    // Spreadsheets fill every line up with commas to the width of the widest.
    const std::string_view format =
        line ? trimmed(line->substr(0, line->find_last_not_of(", \t") + 1)) : std::string_view{};
    if (format == kFormatLine)
        return {};
    return refuse(line ? 1 : 0, "this is not a planes file: the first line is not '" + std::string{kFormatLine} +
                                    "'; give a CSV that 'extract --planes' or 'simulate --truth' wrote");
}

Result<void> PlanesCsvReader::readColumns()
{
    const auto names = nextCsvRecord(lines_, kLongestRow, problem_);
    if (!names)
        return refuse(lines_.number(), problem_.empty() ? "the line of column names is missing; add it" : problem_);
    columns_ = names->cells.size();
    places_.fill(kNoColumn);
    for (std::size_t i = 0; i < columns_; ++i) {
        for (std::size_t column = 0; column < kColumns; ++column) {
            if (names->cells[i] != kColumnNames[column])
                continue;
            if (places_[column] != kNoColumn)
                return refuse(names->line, "the column is there twice; remove one of the two", i + 1,
                              kColumnNames[column]);
            places_[column] = i;
        }
    }
    for (std::size_t column = kId; column <= kD; ++column) {
        if (places_[column] == kNoColumn)
            return refuse(names->line, "there is no column '" + std::string{kColumnNames[column]} + "'; add it");
    }
    return {};
}

template <class Number>
Result<Number> PlanesCsvReader::readCell(const CsvRecord& record, PlaneColumn column, std::string_view wanted) const
{
    const std::string& cell = record.cells[places_[column]];
    if (const auto value = readNumber<Number>(cell))
        return *value;
    return refuse(record.line, quotedText(cell) + " is not " + std::string{wanted} + "; correct it",
                  places_[column] + 1, kColumnNames[column]);
}

Result<PlaneRecord> PlanesCsvReader::readPlane(const CsvRecord& record) const
{
    if (record.cells.size() != columns_)
        return refuse(record.line, "the row has " + std::to_string(record.cells.size()) + " cells instead of " +
                                       std::to_string(columns_) + "; complete it");
    PlaneRecord plane;
    const auto id = readCell<int>(record, kId, "a whole number");
    if (!id)
        return tl::unexpected(id.error());
    plane.id = *id;
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto value = readCell<double>(record, static_cast<PlaneColumn>(kNx + i), "a finite number");
        if (!value)
            return tl::unexpected(value.error());
        numbers[i] = *value;
    }
    plane.normal = {numbers[0], numbers[1], numbers[2]};
    plane.distance = numbers[3];
    if (places_[kPoints] != kNoColumn && !record.cells[places_[kPoints]].empty()) {
        const auto points = readCell<int>(record, kPoints, "a whole number");
        if (!points)
            return tl::unexpected(points.error());
        plane.points = *points;
    }
    if (places_[kName] != kNoColumn)
        plane.name = unguarded(record.cells[places_[kName]]);
    if (places_[kClass] != kNoColumn)
        plane.className = unguarded(record.cells[places_[kClass]]);
    return plane;
}

Result<std::vector<PlaneRecord>> PlanesCsvReader::read()
{
    if (const auto format = readFormat(); !format)
        return tl::unexpected(format.error());
    if (const auto columns = readColumns(); !columns)
        return tl::unexpected(columns.error());
    PlaneRecordList planes;
    while (const auto record = nextCsvRecord(lines_, kLongestRow, problem_)) {
        if (record->cells.size() == 1 && record->cells[0].empty())
            continue;
        auto plane = readPlane(*record);
        if (!plane)
            return tl::unexpected(plane.error());
        if (const std::string wrong = planes.add(std::move(*plane)); !wrong.empty())
            return refuse(record->line, wrong);
    }
    if (!problem_.empty())
        return refuse(lines_.number(), problem_);
    if (!lines_.problem().empty() || lines_.cutShort())
        return refuse(lines_.problemLine(),
                      lines_.cutShort() ? "the compressed file was cut short; get the whole file" : lines_.problem());
    return std::move(planes).take();
}

}  // namespace

Result<std::vector<PlaneRecord>> readPlanesCsv(std::istream& in, const std::string& fileName)
{
    return PlanesCsvReader{in, fileName}.read();
}

}  // namespace planewright
