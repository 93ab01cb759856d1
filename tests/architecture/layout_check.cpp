// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/architecture/layout_check.h"

#include <algorithm>
#include <array>

namespace planewright::architecture {

namespace {

constexpr auto kTopLevel = std::to_array<std::string_view>({"CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json",
                                                            "CONTRIBUTING.md", "LICENSE", "README.md", "app", "core",
                                                            "devices", "packaging", "resources", "tests", "ui"});

constexpr int kMostLines = 400;
constexpr int kMostTestLines = 600;

// In two pieces, so that this file's own first lines are the only ones of their kind in it.
const std::string kHolder = std::string{"SPDX-"} + "FileCopyrightText: 2026 The Planewright authors";
const std::string kLicence = std::string{"SPDX-"} + "License-Identifier: BSD-3-Clause";

bool isCppSource(std::string_view path)
{
    return path.ends_with(".cpp") || path.ends_with(".h");
}

/// Takes the first line off a text.
std::string_view takeLine(std::string_view& text)
{
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

}  // namespace

Offences checkTopLevel(const std::vector<std::string>& names, const std::vector<std::string>& ignored)
{
    Offences offences;
    for (const std::string& name : names) {
        const bool agreed = std::find(kTopLevel.begin(), kTopLevel.end(), name) != kTopLevel.end();
        const bool leftBehind = std::any_of(ignored.begin(), ignored.end(), [&](const std::string& line) {
            return line == "/" + name || line == "/" + name + "/";
        });
        if (!agreed && !leftBehind && !name.starts_with('.'))
            offences.push_back({name, 0, "is outside the agreed layout of the top level"});
    }
    for (const std::string_view name : kTopLevel) {
        if (std::find(names.begin(), names.end(), name) == names.end())
            offences.push_back({std::string{name}, 0, "belongs to the top level and is missing"});
    }
    return offences;
}

bool needsLicenceLines(std::string_view path, std::string_view text)
{
    const std::string_view name = path.substr(path.rfind('/') + 1);  // npos + 1 is 0
    return isCppSource(path) || path.ends_with(".cmake") || path.ends_with(".py") || path.ends_with(".sh") ||
           name == "CMakeLists.txt" || (name.starts_with("packages-") && name.ends_with(".txt")) ||
           text.starts_with("#!");
}

Offences checkLicenceLines(std::string_view path, std::string_view text)
{
    const std::string mark = isCppSource(path) ? "// " : "# ";
    std::string_view rest = text;
    if (rest.starts_with("#!"))
        takeLine(rest);
    if (takeLine(rest) == mark + kHolder && takeLine(rest) == mark + kLicence)
        return {};
    return {{std::string{path}, 1, "the file must begin with '" + mark + kHolder + "' and '" + mark + kLicence + "'"}};
}

Offences checkLength(std::string_view path, std::string_view text)
{
    const auto lines = std::count(text.begin(), text.end(), '\n');
    const int most = path.starts_with("tests/") ? kMostTestLines : kMostLines;
    if (!isCppSource(path) || lines <= most)
        return {};
    return {{std::string{path}, 0,
             "has " + std::to_string(lines) + " lines, more than " + std::to_string(most) + ": usually two subjects"}};
}

}  // namespace planewright::architecture
