// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/number_option.h"

#include <charconv>

#include "core/formats/number_text.h"

namespace planewright {

namespace {

template <class Number>
bool reads(const std::string& text, Number& number)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size();
}

template <class Number>
CLI::Option* addChecked(CLI::App& command, const std::string& name, Number& value, Number lowest, Number highest,
                        const std::string& allowed, const std::string& help)
{
    const auto take = [&value, lowest, highest, allowed, name](const std::string& text) {
        Number number{};
        // Written so that NaN fails.
        if (!reads(text, number) || !(number >= lowest && number <= highest))
            throw CLI::ValidationError(name, "'" + text + "' is not " + allowed);
        value = number;
    };
    return command.add_option_function<std::string>(name, take, help);
}

}  // namespace

CLI::Option* addNumber(CLI::App& command, const std::string& name, double& value, double lowest, double highest,
                       const std::string& help)
{
    const std::string allowed = "a number from " + formatNumber(lowest) + " to " + formatNumber(highest);
    return addChecked(command, name, value, lowest, highest, allowed, help)->type_name("NUMBER");
}

template <class Whole>
CLI::Option* addWholeNumber(CLI::App& command, const std::string& name, Whole& value, Whole lowest, Whole highest,
                            const std::string& help)
{
    const std::string allowed = "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest);
    return addChecked(command, name, value, lowest, highest, allowed, help)->type_name("N");
}

template CLI::Option* addWholeNumber(CLI::App&, const std::string&, int&, int, int, const std::string&);
template CLI::Option* addWholeNumber(CLI::App&, const std::string&, std::int64_t&, std::int64_t, std::int64_t,
                                     const std::string&);
template CLI::Option* addWholeNumber(CLI::App&, const std::string&, std::uint64_t&, std::uint64_t, std::uint64_t,
                                     const std::string&);

}  // namespace planewright
