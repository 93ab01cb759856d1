// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/params/manual_page.h"

#include <charconv>
#include <string_view>
#include <vector>

#include "core/params/presets.h"
#include "core/params/registry.h"

namespace planewright {

namespace {

constexpr std::string_view kIntroduction =
    "# Parameters\n"
    "\n"
    "Every parameter of an extraction, with its value in each preset of the method; the first is the default.\n"
    "`-P key=value` sets one, a preset file sets several of the default's; the later wins.\n"
    "Lengths are metres and angles degrees, as the unit says. The symbol is the published method's, in ASCII.\n"
    "\n"
    "This page is made from the program's own table: `planewright-cli params list --markdown`.\n";

std::string_view partOf(std::string_view key)
{
    return key.substr(0, key.find('.'));
}

/// A limit of a range: tiny ones as 1e-15, others without an exponent.
std::string limitText(double limit)
{
    const auto format = limit > 0.0 && limit < 1e-4 ? std::chars_format::scientific : std::chars_format::fixed;
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, limit, format).ptr};
}

std::string allowedText(const ParameterRow& row)
{
    if (row.choices.empty())
        return limitText(row.lowest) + " to " + limitText(row.highest);
    std::string words;
    for (const std::string_view choice : row.choices)
        words += (words.empty() ? "`" : ", `") + std::string{choice} + "`";
    return words;
}

/// A row of a Markdown table; a bar inside a cell would end it.
std::string tableRow(const std::vector<std::string>& cells)
{
    std::string row = "|";
    for (const std::string& cell : cells) {
        row += ' ';
        for (const char c : cell)
            row += c == '|' ? std::string{"\\|"} : std::string{c};
        row += cell.empty() ? "|" : " |";
    }
    return row + "\n";
}

std::string code(std::string_view text)
{
    return text.empty() ? "" : "`" + std::string{text} + "`";
}

std::string parameterTables()
{
    std::vector<std::string> header{"key"};
    std::vector<Parameters> presets;
    for (const Preset& preset : methodPresets()) {
        header.push_back(code(preset.name));
        apply(preset, presets.emplace_back());
    }
    for (const char* column : {"unit", "allowed", "symbol", "meaning"})
        header.emplace_back(column);
    std::string text;
    std::string_view part;
    for (const ParameterRow& row : parameterRows()) {
        if (partOf(row.key) != part) {
            part = partOf(row.key);
            text += "\n## " + std::string{part} + "\n\n" + tableRow(header) +
                    tableRow(std::vector<std::string>(header.size(), "---"));
        }
        std::vector<std::string> cells{code(row.key)};
        for (const Parameters& preset : presets)
            cells.push_back(code(printParameter(preset, row.key)));
        for (const std::string& cell :
             {std::string{row.unitName}, allowedText(row), code(row.symbol), std::string{row.meaning}})
            cells.push_back(cell);
        text += tableRow(cells);
    }
    return text;
}

std::string mappingTable()
{
    std::string text =
        tableRow({"key", "default", "unit", "allowed", "meaning"}) + tableRow(std::vector<std::string>(5, "---"));
    for (const ParameterRow& row : mappingRows())
        text += tableRow({code(row.key), code(printParameter(MappingParameters{}, row.key)), std::string{row.unitName},
                          allowedText(row), std::string{row.meaning}});
    return text;
}

std::string methodTable()
{
    std::string text = tableRow({"name", "meaning"}) + tableRow({"---", "---"});
    for (const Preset& preset : methodPresets())
        text += tableRow({code(preset.name), std::string{preset.meaning}});
    return text;
}

std::string sensorTable()
{
    std::string text = tableRow({"name", "meaning", "sets"}) + tableRow({"---", "---", "---"});
    for (const Preset& preset : sensorPresets()) {
        std::string values;
        for (const auto& [key, value] : preset.values)
            values += (values.empty() ? "`" : ", `") + std::string{key} + "=" + std::string{value} + "`";
        text += tableRow({code(preset.name), std::string{preset.meaning}, values});
    }
    return text;
}

}  // namespace

std::string parameterManualPage()
{
    return std::string{kIntroduction} + parameterTables() +
           "\n## map\n\nOf `planewright-cli map` alone, which takes them with `-P` as well; no preset sets them.\n\n" +
           mappingTable() + "\n## Presets of the method: `--preset`\n\n" + methodTable() +
           "\n## Presets of the scanner: `--sensor`\n\n" + sensorTable();
}

}  // namespace planewright
