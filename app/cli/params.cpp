// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/json_text.h"
#include "app/cli/parameter_options.h"
#include "app/cli/text.h"
#include "core/formats/number_text.h"
#include "core/params/manual_page.h"
#include "core/params/registry.h"

namespace planewright {

namespace {

struct ParamsOptions {
    std::string key;  ///< of show; empty for list
    bool json = false;
    bool markdown = false;
    ParameterOptions parameters;
};

std::string rangeText(const ParameterRow& row)
{
    if (!row.choices.empty())
        return joined(row.choices);
    return formatNumber(row.lowest) + " to " + formatNumber(row.highest);
}

Json asJson(const ParameterRow& row, const std::string& value)
{
    Json json{{"key", row.key}};
    // Numbers as numbers: "0.03" reads back as itself, the words of a choice do not.
    const Json number = Json::parse(value, nullptr, false);
    json["value"] = number.is_discarded() ? Json(value) : number;
    json["unit"] = row.unitName;
    if (row.choices.empty())
        json["range"] = {row.lowest, row.highest};
    else
        json["choices"] = row.choices;
    json["symbol"] = row.symbol;
    json["meaning"] = row.meaning;
    return json;
}

std::string showText(const ParameterRow& row, const std::string& value)
{
    const auto line = [](const std::string& label, std::string_view text) {
        return text.empty() ? std::string{} : label + std::string(9 - label.size(), ' ') + std::string{text} + "\n";
    };
    return line("key", row.key) + line("value", value) + line("unit", row.unitName) +
           line(row.choices.empty() ? "range" : "choices", rangeText(row)) + line("symbol", row.symbol) +
           line("meaning", row.meaning);
}

/// A parameter with its value as text.
struct ValuedRow {
    const ParameterRow* row;
    std::string value;
};

Result<std::vector<ValuedRow>> valuedRows(ParameterOptions options)
{
    const auto mapping = takeMappingParameters(options);
    if (!mapping)
        return tl::unexpected{mapping.error()};
    const Result<Parameters> parameters = parametersInForce(options, "");
    if (!parameters)
        return tl::unexpected{parameters.error()};
    std::vector<ValuedRow> rows;
    for (const ParameterRow& row : parameterRows())
        rows.push_back({&row, printParameter(*parameters, row.key)});
    for (const ParameterRow& row : mappingRows())
        rows.push_back({&row, printParameter(*mapping, row.key)});
    return rows;
}

Result<std::string> describe(const ParamsOptions& options)
{
    if (options.markdown)
        return parameterManualPage();
    const auto rows = valuedRows(options.parameters);
    if (!rows)
        return tl::unexpected{rows.error()};
    if (!options.key.empty()) {
        const auto found =
            std::ranges::find_if(*rows, [&](const ValuedRow& valued) { return valued.row->key == options.key; });
        if (found == rows->end()) {
            const std::string near{nearestKey(options.key)};
            return fail(ErrorCode::Usage, "there is no parameter '" + options.key + "'; " +
                                              (near.empty() ? "" : "did you mean " + near + "? ") +
                                              "'planewright-cli params' lists all");
        }
        return options.json ? jsonText(asJson(*found->row, found->value)) : showText(*found->row, found->value);
    }
    Json all = Json::array();
    std::vector<std::vector<std::string>> table{{"key", "value", "unit", "range", "symbol", "meaning"}};
    for (const auto& [row, value] : *rows) {
        all.push_back(asJson(*row, value));
        table.push_back({std::string{row->key}, value, std::string{row->unitName}, rangeText(*row),
                         std::string{row->symbol}, std::string{row->meaning}});
    }
    return options.json ? jsonText(all) : tableText(table);
}

Result<ExitCode> params(const ParamsOptions& options)
{
    const Result<std::string> text = describe(options);
    if (!text)
        return tl::unexpected{text.error()};
    if (const auto printed = print(*text); !printed)
        return tl::unexpected{printed.error()};
    return ExitCode::Done;
}

}  // namespace

void addParamsCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand("params", "every parameter: key, value, unit, range, symbol, meaning");
    auto options = std::make_shared<ParamsOptions>();
    const auto choose = [options, &chosen] { chosen = [options] { return params(*options); }; };
    const auto addTo = [&](CLI::App& app) {
        app.add_flag("--json", options->json, "as JSON");
        addParameterOptions(app, options->parameters);
        app.callback(choose);
    };
    command.require_subcommand(0, 1);
    addTo(command);
    command.add_flag("--markdown", options->markdown, "as the page of the manual, with the defaults");
    CLI::App& list = *command.add_subcommand("list", "all of them (the default)");
    addTo(list);
    list.add_flag("--markdown", options->markdown, "as the page of the manual, with the defaults");
    CLI::App& show = *command.add_subcommand("show", "one of them");
    show.add_option("KEY", options->key, "the parameter's key, as in segments.min-length")->required();
    addTo(show);
}

}  // namespace planewright
