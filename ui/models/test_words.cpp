// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/test_words.h"

#include <algorithm>
#include <cmath>

#include "core/types/angle.h"
#include "ui/models/number_text.h"
#include "ui/models/parameter_model.h"

namespace planewright {

namespace {

constexpr double kEndless = 1e9;  // counts and distances beyond mean that there is none
constexpr int kFinestDecimals = 9;

int decimalsOf(TestScale scale, const LengthStyle& lengths)
{
    using enum TestScale;
    switch (scale) {
        case Metre:
            return lengths.millimetres ? std::max(lengths.decimals - 3, 0) : std::max(lengths.decimals, 3);
        case Angle:
        case Variance:
        case Sine:
        case SquaredSine:
        case ChiSquare:
            return 1;
        case Cosine:
            return 4;
        case Plain:
            return 2;
        case Count:
        case Share:
        case Flag:
            break;
    }
    return 0;
}

/// A number as people see it: every scale keeps what is larger and what is smaller.
double seenNumber(double value, TestScale scale, const LengthStyle& lengths)
{
    using enum TestScale;
    constexpr double kThousand = 1000.0;
    constexpr double kHundred = 100.0;
    switch (scale) {
        case Metre:
            return lengths.millimetres ? kThousand * value : value;
        case Angle:
            return toDegrees(value);
        case Variance:
            return toDegrees(std::sqrt(std::max(value, 0.0)));
        case Sine:
            return toDegrees(std::asin(std::clamp(value, -1.0, 1.0)));
        case SquaredSine:
            return toDegrees(std::asin(std::sqrt(std::clamp(value, 0.0, 1.0))));
        case Share:
            return kHundred * value;
        case Plain:
        case Count:
        case Cosine:
        case ChiSquare:
        case Flag:
            break;
    }
    return value;
}

QString scaleUnit(TestScale scale, const LengthStyle& lengths)
{
    using enum TestScale;
    switch (scale) {
        case Metre:
            return lengthUnit(lengths);
        case Angle:
        case Variance:
        case Sine:
        case SquaredSine:
            return QStringLiteral("°");
        case Share:
            return QStringLiteral("%");
        case Plain:
        case Count:
        case Cosine:
        case ChiSquare:
        case Flag:
            break;
    }
    return {};
}

QString seenText(double value, int decimals)
{
    return value > kEndless ? QStringLiteral("∞") : numberText(value, decimals);
}

QString comparisonText(Comparison comparison)
{
    switch (comparison) {
        case Comparison::Less:
            return QStringLiteral("<");
        case Comparison::LessEqual:
            return QStringLiteral("≤");
        case Comparison::Greater:
            return QStringLiteral(">");
        case Comparison::GreaterEqual:
            break;
    }
    return QStringLiteral("≥");
}

QString yesOrNo(bool yes)
{
    return yes ? QStringLiteral("yes") : QStringLiteral("no");
}

bool hasTest(std::span<const Test> tests, std::string_view name)
{
    return std::any_of(tests.begin(), tests.end(), [name](const Test& test) { return test.name == name; });
}

}  // namespace

const TestWords* wordsFor(std::string_view name, TestAbout about)
{
    const TestWords* general = nullptr;
    for (const TestWords& words : allTestWords()) {
        if (words.name == name && words.about == about)
            return &words;
        if (words.name == name && words.about == TestAbout::Any)
            general = &words;
    }
    return general;
}

QString TestText::text() const
{
    if (isFlag)
        return symbol + ": " + value;
    const QString numbers = QStringLiteral("%1 %2 %3 %4").arg(symbol, value, comparison, limit);
    if (unit.isEmpty())
        return numbers;
    return numbers + (unit == QStringLiteral("°") ? unit : ' ' + unit);
}

TestText textOf(const Test& test, TestAbout about, const LengthStyle& lengths)
{
    const TestWords* words = wordsFor(test.name, about);
    TestText text;
    text.symbol = words != nullptr
                      ? QString::fromUtf8(words->symbol)
                      : QString::fromUtf8(test.name.data(), static_cast<qsizetype>(test.name.size())).replace('_', ' ');
    text.pass = test.pass();
    const TestScale scale = words != nullptr ? words->scale : TestScale::Plain;
    if (scale == TestScale::Flag) {
        // What is asked for is the answer that would pass.
        text.isFlag = true;
        text.value = yesOrNo(test.value >= 0.5);
        text.comparison = QStringLiteral("=");
        text.limit = yesOrNo(test.comparison == Comparison::Greater || test.comparison == Comparison::GreaterEqual);
        return text;
    }
    const double value = seenNumber(test.value, scale, lengths);
    const double limit = seenNumber(test.limit, scale, lengths);
    int decimals = decimalsOf(scale, lengths);
    while (value != limit && decimals < kFinestDecimals && seenText(value, decimals) == seenText(limit, decimals))
        ++decimals;
    text.value = seenText(value, decimals);
    text.limit = seenText(limit, decimals);
    text.comparison = comparisonText(test.comparison);
    text.unit = scaleUnit(scale, lengths);
    return text;
}

QString meaningOf(const Test& test, TestAbout about)
{
    const TestWords* words = wordsFor(test.name, about);
    if (words == nullptr)
        return {};
    QString text = QString::fromUtf8(words->meaning);
    const TestText numbers = textOf(test, about);
    if (words->scale == TestScale::Cosine)
        text += QStringLiteral("\n%1 is %2°, %3 is %4°.")
                    .arg(numbers.value, angleText(std::acos(std::clamp(test.value, -1.0, 1.0))), numbers.limit,
                         angleText(std::acos(std::clamp(test.limit, -1.0, 1.0))));
    QStringList labels;
    for (const ParameterRow& row : parameterRows()) {
        if (std::find(words->parameters.begin(), words->parameters.end(), row.key) != words->parameters.end())
            labels << parameterLabel(row) + QStringLiteral(" (") +
                          QString::fromUtf8(row.key.data(), static_cast<qsizetype>(row.key.size())) + ')';
    }
    text += labels.isEmpty() ? QStringLiteral("\nNo parameter sets its limit.")
                             : QStringLiteral("\nIts limit is set by %1.").arg(labels.join(QStringLiteral(", ")));
    return text;
}

QString verdictMark(bool pass)
{
    return pass ? QStringLiteral("✔") : QStringLiteral("✘");
}

TestAbout aboutOf(const Decision& decision)
{
    using enum TestAbout;
    const auto* first = decision.operands.empty() ? nullptr : &decision.operands.front();
    switch (decision.kind) {
        case DecisionKind::Assign: {
            const auto* from = decision.operands.size() > 1 ? std::get_if<PlaneRef>(&decision.operands[1]) : nullptr;
            const auto* to = decision.result.empty() ? nullptr : std::get_if<PlaneRef>(&decision.result.front());
            return from != nullptr && to != nullptr && from->id != to->id ? Move : Join;
        }
        case DecisionKind::Reject:
            return decision.phase == Phase::Extract ? Piece : Join;
        case DecisionKind::Cluster:
            return Any;
        case DecisionKind::Fit:
            return first != nullptr && std::holds_alternative<SegmentId>(*first) ? Seed : Fit;
        case DecisionKind::NoFit:
            return first != nullptr && std::holds_alternative<PlaneRef>(*first) ? Keep : Fit;
        case DecisionKind::Split:
            return Split;
        case DecisionKind::Merge:
        case DecisionKind::Near:
            break;
    }
    return hasTest(decision.tests, "shared_segments") ? Absorb : aboutOf("merge", decision.tests);
}

TestAbout aboutOf(std::string_view way, std::span<const Test> tests)
{
    if (way == "merge")
        return hasTest(tests, "adjacent") ? TestAbout::Tracks : TestAbout::Merge;
    if (way == "absorb")
        return TestAbout::Absorb;
    return way == "join_known" ? TestAbout::Known : TestAbout::Join;
}

}  // namespace planewright
