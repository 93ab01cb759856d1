// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/csv_record.h"

namespace planewright {

namespace {

constexpr std::string_view kFormulaBeginnings = "=+-@";

/// Walks over a record; the state between two lines is whether a quote is open.
class RecordSplitter {
public:
    /// Takes a line in; false where a quote stands where none may.
    bool add(std::string_view line)
    {
        for (const char c : line) {
            if (inQuotes_ && c == '"') {
                inQuotes_ = false;
                wasQuoted_ = true;
            } else if (!inQuotes_ && c == ',')
                endCell();
            else if (!inQuotes_ && c == '"') {
                if (!wasQuoted_ && !cell_.empty())
                    return false;
                // A second quote at once is a quote of the text.
                if (wasQuoted_)
                    cell_ += '"';
                inQuotes_ = true;
                wasQuoted_ = false;
            } else if (wasQuoted_)
                return false;
            else
                cell_ += c;
        }
        if (inQuotes_)
            cell_ += '\n';
        else
            endCell();
        return true;
    }

    bool isOpen() const { return inQuotes_; }
    std::vector<std::string>& cells() { return cells_; }

private:
    void endCell()
    {
        cells_.push_back(std::move(cell_));
        cell_.clear();
        wasQuoted_ = false;
    }

    std::vector<std::string> cells_;
    std::string cell_;
    bool inQuotes_ = false;
    bool wasQuoted_ = false;
};

}  // namespace

void appendQuotedCsvText(std::string& row, std::string_view text)
{
    row += '"';
    for (const char c : text) {
        if (c == '"')
            row += '"';
        row += c;
    }
    row += '"';
}

void appendCsvText(std::string& row, std::string_view text)
{
    std::string guarded;
    if (!text.empty() && kFormulaBeginnings.find(text.front()) != std::string_view::npos) {
        guarded = "'" + std::string{text};
        text = guarded;
    }
    if (text.find_first_of(",\"\r\n") == std::string_view::npos)
        row += text;
    else
        appendQuotedCsvText(row, text);
}

std::string_view unguarded(std::string_view cell)
{
    const bool guarded =
        cell.size() >= 2 && cell[0] == '\'' && kFormulaBeginnings.find(cell[1]) != std::string_view::npos;
    return guarded ? cell.substr(1) : cell;
}

std::optional<CsvRecord> nextCsvRecord(TextLines& lines, std::size_t longestRecord, std::string& problem)
{
    RecordSplitter splitter;
    std::size_t firstLine = 0;
    std::size_t length = 0;
    do {
        const auto line = lines.next();
        if (!line) {
            if (splitter.isOpen() && lines.problem().empty())
                problem = "a quote is opened and never closed; close it";
            return std::nullopt;
        }
        firstLine = firstLine == 0 ? lines.number() : firstLine;
        length += line->size() + 1;
        if (length > longestRecord)
            problem = "the row is longer than " + std::to_string(longestRecord) + " bytes; close its quotes";
        else if (!splitter.add(*line))
            problem = "a quote stands inside a cell; put the whole cell in quotes and double those inside";
        if (!problem.empty())
            return std::nullopt;
    } while (splitter.isOpen());
    return CsvRecord{firstLine, std::move(splitter.cells())};
}

}  // namespace planewright
