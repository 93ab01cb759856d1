// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <utility>

#include "ui/models/parameter_model.h"

namespace planewright {

namespace {

struct GroupTitle {
    std::string_view beginning;  ///< of the keys
    const char* title;
};

// In the algorithm's order. A key belongs to the longest beginning that it has.
constexpr std::array<GroupTitle, 15> kGroups{{
    {"method.", "Method"},
    {"segments.incidence-limit", "Breakpoints"},
    {"segments.breakpoint-sigmas", "Breakpoints"},
    {"segments.", "Segments"},
    {"noise.", "3D geometry"},
    {"sensor.", "Scanner corrections"},
    {"assignment.", "Assign"},
    {"clusters.", "Clusters"},
    {"planes.", "Fit"},
    {"planes.error-limit", "Split and merge"},
    {"planes.run-", "Split and merge"},
    {"planes.max-contested", "Split and merge"},
    {"planes.merge-", "Split and merge"},
    {"likelihood.", "Likelihood"},
    {"schedule.", "Schedule"},
}};

std::string_view titleOf(std::string_view key)
{
    const GroupTitle* best = nullptr;
    for (const GroupTitle& group : kGroups) {
        if (key.starts_with(group.beginning) && (best == nullptr || group.beginning.size() > best->beginning.size()))
            best = &group;
    }
    return best == nullptr ? std::string_view{"Other"} : std::string_view{best->title};
}

QString withGreek(QString text)
{
    static constexpr std::array<std::pair<const char*, const char*>, 10> kLetters{{{"lambda", "λ"},
                                                                                   {"epsilon", "ε"},
                                                                                   {"sigma", "σ"},
                                                                                   {"delta", "δ"},
                                                                                   {"alpha", "α"},
                                                                                   {"theta", "θ"},
                                                                                   {"rho", "ρ"},
                                                                                   {"phi", "φ"},
                                                                                   {"tau", "τ"},
                                                                                   {"nu", "ν"}}};
    for (const auto& [name, letter] : kLetters)
        text.replace(QString::fromLatin1(name), QString::fromUtf8(letter));
    return text.replace(QStringLiteral("Pi"), QStringLiteral("Π"));
}

}  // namespace

std::vector<ParameterGroup> parameterGroups()
{
    std::vector<ParameterGroup> groups;
    const auto groupOf = [&groups](const QString& title) -> ParameterGroup& {
        for (ParameterGroup& group : groups) {
            if (group.title == title)
                return group;
        }
        return groups.emplace_back(ParameterGroup{title, {}});
    };
    for (const GroupTitle& group : kGroups)
        groupOf(QString::fromLatin1(group.title));
    for (const ParameterRow& row : parameterRows()) {
        const std::string_view title = titleOf(row.key);
        groupOf(QString::fromLatin1(title.data(), static_cast<qsizetype>(title.size()))).rows.push_back(&row);
    }
    return groups;
}

QString parameterLabel(const ParameterRow& row)
{
    const std::string_view name = row.key.substr(row.key.find('.') + 1);
    QString label = QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())).replace('-', ' ');
    label[0] = label[0].toUpper();
    return label;
}

QString parameterSymbol(const ParameterRow& row)
{
    const QString symbol = QString::fromLatin1(row.symbol.data(), static_cast<qsizetype>(row.symbol.size()));
    const qsizetype bar = symbol.indexOf('_');
    if (bar < 0)
        return withGreek(symbol);
    return withGreek(symbol.left(bar)) + QStringLiteral("<sub>") + withGreek(symbol.mid(bar + 1)) +
           QStringLiteral("</sub>");
}

QString parameterUnit(const ParameterRow& row)
{
    return row.unit == Unit::Angle ? QStringLiteral("°") : row.unit == Unit::Metre ? QStringLiteral("m") : QString{};
}

}  // namespace planewright
