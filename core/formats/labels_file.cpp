// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <charconv>
#include <istream>
#include <ostream>

#include "core/formats/labels.h"
#include "core/formats/message_text.h"
#include "core/formats/number_cells.h"
#include "core/formats/recording_csv.h"
#include "core/formats/text_lines.h"
#include "core/formats/written.h"

namespace planewright {

namespace {

/// Most labels of a file: as many as a recording has ranges.
constexpr std::size_t kMaxLabels = kMaxRanges;

/// Reads the labels of a line; gives the place (from 1) of the first that is none, or 0.
std::size_t readLine(std::string_view line, std::vector<int>& labels, std::string_view& bad)
{
    for (std::size_t begin = 0; begin < line.size();) {
        const std::size_t end = std::min(line.find(' ', begin), line.size());
        const std::string_view text = line.substr(begin, end - begin);
        const auto label = readNumber<int>(text);
        if (!label || *label < kIgnoredLabel) {
            bad = text;
            return labels.size() + 1;
        }
        labels.push_back(*label);
        begin = end + 1;
    }
    return 0;
}

}  // namespace

Result<void> writeLabels(std::ostream& out, const Labels& labels)
{
    std::string text;
    std::array<char, 16> number;
    for (const std::vector<int>& line : labels) {
        text.clear();
        for (const int label : line) {
            text.append(number.data(), std::to_chars(number.data(), number.data() + number.size(), label).ptr);
            text += ' ';
        }
        if (!text.empty())
            text.pop_back();
        out << text << '\n';
    }
    return written(out);
}

Result<Labels> readLabels(std::istream& in, const std::string& fileName)
{
    const auto refuse = [&](std::size_t line, const std::string& what, std::size_t column = 0) {
        return fail(ErrorCode::Unreadable, placeInFile(fileName, line, column) + what);
    };
    TextLines lines{in};
    Labels labels;
    std::size_t blankLine = 0;
    while (const auto line = lines.next()) {
        if (line->empty()) {
            blankLine = blankLine == 0 ? lines.number() : blankLine;
            continue;
        }
        if (blankLine != 0)
            return refuse(blankLine, "there is a blank line between labels; remove it");
        std::vector<int> beams;
        std::string_view bad;
        if (const std::size_t place = readLine(*line, beams, bad); place != 0)
            return refuse(lines.number(),
                          quotedText(bad) + " is not a label; give whole numbers from -2, separated by single blanks",
                          place);
        if (!labels.empty() && beams.size() != labels.front().size())
            return refuse(lines.number(), "the line has " + std::to_string(beams.size()) +
                                              " labels and the first has " + std::to_string(labels.front().size()) +
                                              "; give one for every beam");
        if (labels.size() == static_cast<std::size_t>(kMaxSlices) || (labels.size() + 1) * beams.size() > kMaxLabels)
            return refuse(lines.number(), "more labels than a recording has ranges; give the labels of a recording");
        labels.push_back(std::move(beams));
    }
    if (!lines.problem().empty())
        return refuse(lines.problemLine(), lines.problem());
    if (lines.cutShort())
        return refuse(lines.problemLine(), "the compressed file was cut short; get the whole file");
    if (labels.empty())
        return refuse(0, "the file is empty; give a line of labels for every slice");
    return labels;
}

}  // namespace planewright
