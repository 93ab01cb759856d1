// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/architecture/include_check.h"

#include <algorithm>
#include <functional>
#include <set>

#include "tests/architecture/rooms.h"
#include "tests/architecture/source_text.h"

namespace planewright::architecture {

namespace {

const std::vector<std::string_view> kHouse{"app", "core", "devices", "ui"};

bool liesInAny(std::string_view path, const std::vector<std::string_view>& folders)
{
    return std::any_of(folders.begin(), folders.end(), [&](std::string_view f) { return liesIn(path, f); });
}

bool applies(const Restriction& rule, std::string_view path)
{
    return liesInAny(path, rule.under) && !liesInAny(path, rule.except);
}

/// What is wrong with a header of the project, or nothing.
std::string projectRule(const Room& room, const Include& include)
{
    const std::string header = "\"" + include.header + "\"";
    if (include.header.ends_with(".moc"))
        return "";
    if (!liesInAny(include.header, kHouse))
        return header + " is not named from the top of the source tree, or is no part of the product";
    const Room* other = roomOf(include.header);
    if (other == nullptr)
        return header + " is in a folder that the table of rooms does not know";
    if (hasDoorTo(room, include.header))
        return "";
    return std::string{room.folder} + " may not include " + header + ": there is no door to " +
           std::string{other->folder};
}

/// What is wrong with a header of the standard library or of another project, or nothing.
std::string libraryRule(const Room& room, std::string_view path, const Include& include)
{
    const std::string header = "<" + include.header + ">";
    for (const Restriction& rule : restrictedHeaders()) {
        if (rule.what == include.header && applies(rule, path))
            return header + ": " + std::string{rule.reason};
    }
    if (isStandardHeader(include.header))
        return "";
    const auto allowed = [&](std::string_view beginning) { return include.header.starts_with(beginning); };
    if (std::any_of(room.libraries.begin(), room.libraries.end(), allowed))
        return "";
    return std::string{room.folder} + " may not use " + header + ": that library is not in its row of the table";
}

}  // namespace

Offences checkSource(std::string_view path, std::string_view source)
{
    if (!liesInAny(path, kHouse))
        return {};
    const Room* room = roomOf(path);
    if (room == nullptr)
        return {{std::string{path}, 0, "the table of rooms does not know this folder"}};
    Offences offences;
    for (const Include& include : includesOf(source)) {
        const std::string rule = include.header.empty() ? "an include by macro hides what it opens"
                                 : include.quoted       ? projectRule(*room, include)
                                                        : libraryRule(*room, path, include);
        if (!rule.empty())
            offences.push_back({std::string{path}, include.line, rule});
    }
    int number = 0;
    for (const std::string& line : codeLinesOf(source)) {
        ++number;
        for (const Restriction& rule : restrictedWords()) {
            if (applies(rule, path) && holdsWord(line, rule.what))
                offences.push_back(
                    {std::string{path}, number, std::string{rule.what} + ": " + std::string{rule.reason}});
        }
    }
    return offences;
}

Offences checkCircles(const std::map<std::string, std::string>& sources)
{
    Offences offences;
    std::set<std::string> done;
    std::vector<std::string> way;
    const std::function<void(const std::string&)> visit = [&](const std::string& path) {
        const auto met = std::find(way.begin(), way.end(), path);
        if (met != way.end()) {
            std::string circle;
            for (auto step = met; step != way.end(); ++step)
                circle += *step + " → ";
            offences.push_back({path, 0, "headers include each other in a circle: " + circle + path});
            return;
        }
        const auto source = sources.find(path);
        if (source == sources.end() || done.contains(path))
            return;
        way.push_back(path);
        for (const Include& include : includesOf(source->second))
            visit(include.header);
        way.pop_back();
        done.insert(path);
    };
    for (const auto& [path, source] : sources)
        visit(path);
    return offences;
}

}  // namespace planewright::architecture
