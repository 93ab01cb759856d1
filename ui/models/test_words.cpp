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

const auto& testWordTable()
{
    using enum TestAbout;
    using enum TestScale;
    static constexpr std::array kTestWords{
        TestWords{
            "plane_distance",
            Any,
            "D",
            Metre,
            {"assignment.plane-distance", "assignment.plane-distance-sigmas"},
            "How far the farther end of the segment is from the plane. The limit is larger where that end is noisy."},
        TestWords{
            "plane_distance",
            Move,
            "D",
            Metre,
            {},
            "How far the farther end of the segment is from the other plane; the limit is what it is from its own."},
        TestWords{
            "plane_distance",
            Merge,
            "D",
            Metre,
            {"planes.merge-distance", "planes.merge-sigmas"},
            "The largest distance of an end point of one plane's segments from the other plane. The limit is larger "
            "where that end is noisy."},
        TestWords{"orthogonality",
                  Any,
                  "|n·δ|",
                  Plain,
                  {"assignment.orthogonality", "assignment.orthogonality-sigmas"},
                  "Sine of the angle between the segment and the plane. The limit is larger for short segments."},
        TestWords{"contested",
                  Join,
                  "leans out",
                  Flag,
                  {"planes.run-lean", "planes.run-step"},
                  "Whether the segment is of a run that leans out of this young plane."},
        TestWords{"contested",
                  Any,
                  "contested",
                  Share,
                  {"planes.max-contested", "planes.run-lean"},
                  "Share of the plane that is on runs of segments which lean out of it."},
        TestWords{"in_other_plane",
                  Any,
                  "in another plane",
                  Flag,
                  {},
                  "Whether the segment already belongs to another plane; then it can only move."},
        TestWords{
            "distance_of_next",
            Any,
            "D",
            Metre,
            {},
            "How far the segment is from the plane; the limit is its distance from the nearest other plane that it "
            "fits."},
        TestWords{"distance_of_own",
                  Any,
                  "D",
                  Metre,
                  {},
                  "How far the segment is from the plane; the limit is its distance from its own plane."},
        TestWords{
            "direction_similarity",
            Any,
            "|δ·δ|",
            Cosine,
            {"clusters.direction-limit", ""},
            "Cosine of the angle between the segment and the nearest cluster's direction. Where it fails, the segment "
            "begins a new cluster."},
        TestWords{
            "similarity",
            Any,
            "|δ·δ|",
            Cosine,
            {"clusters.direction-limit", ""},
            "Cosine of the angle between the segment and the nearest cluster's direction. Where it fails, the segment "
            "begins a new cluster."},
        TestWords{"cluster_segments",
                  Any,
                  "segments in cluster",
                  Count,
                  {"planes.min-cluster-segments", ""},
                  "A cluster is searched for planes when it holds so many segments."},
        TestWords{"cluster_slices",
                  Any,
                  "slices of cluster",
                  Count,
                  {"planes.min-cluster-slices", ""},
                  "A cluster is searched for planes when its segments are of so many slices."},
        TestWords{"segments", Any, "segments", Count, {"planes.min-segments", ""}, "How many segments the plane has."},
        TestWords{
            "segments", Absorb, "segments", Count, {}, "The larger plane has more segments than the smaller one."},
        TestWords{
            "slices", Any, "slices", Count, {"planes.min-slices", ""}, "How many slices the plane's segments are of."},
        TestWords{"points", Any, "points", Count, {"planes.min-points", ""}, "How many scan points the plane has."},
        TestWords{"points",
                  Keep,
                  "points",
                  Count,
                  {"likelihood.min-solid-angle", "likelihood.enough-points"},
                  "How many scan points the plane has, against those that fill the smallest solid angle of a plane."},
        TestWords{"extent",
                  Any,
                  "extent",
                  Metre,
                  {"planes.min-extent", "planes.min-extent-angle"},
                  "How far the plane's segments reach in its shorter direction. The limit grows with range."},
        TestWords{"normal_sigma",
                  Any,
                  "σ of n",
                  Angle,
                  {"planes.max-normal-sigma", ""},
                  "How well the plane's normal is known: its largest standard deviation."},
        TestWords{"normal_sigma",
                  Seed,
                  "σ of n",
                  Angle,
                  {"likelihood.seed-angle", ""},
                  "How well the normal of the three segments' plane is known: its largest standard deviation."},
        TestWords{"incidence",
                  Any,
                  "incidence",
                  Sine,
                  {"planes.min-incidence", ""},
                  "Angle at which the laser's rays meet the plane on average; a slice's own plane is none."},
        TestWords{
            "contradictions",
            Any,
            "segments standing off",
            Count,
            {},
            "Segments that face the plane and stand a little off it, as steps do off a stair's slope; no more than it "
            "has itself."},
        TestWords{"fitting_error",
                  Any,
                  "E",
                  Plain,
                  {"planes.error-limit", ""},
                  "Fitting error: mean squared Mahalanobis distance of the end points from the plane, Eq. (16)."},
        TestWords{"fitting_error",
                  Merge,
                  "E",
                  Plain,
                  {"planes.error-limit", ""},
                  "Fitting error of either plane's end points to the plane of both, the larger of the two."},
        TestWords{"normal_alignment",
                  Any,
                  "|n·n|",
                  Cosine,
                  {"planes.merge-angle", "planes.merge-sigmas"},
                  "Cosine of the angle between the two planes, Eq. (21). The limit is lower where a normal is not well "
                  "known."},
        TestWords{"normal_alignment",
                  Tracks,
                  "|n·n|",
                  Cosine,
                  {},
                  "Cosine of the angle between the two planes; those that differ more are not compared."},
        TestWords{"in_plane_gap",
                  Any,
                  "gap",
                  Metre,
                  {"planes.merge-gap", ""},
                  "Gap between the two planes' segments along the plane; none where they face each other."},
        TestWords{"shared_segments",
                  Any,
                  "shared",
                  Share,
                  {"planes.merge-share", ""},
                  "Share of the smaller plane's segments that fit the larger one."},
        TestWords{"facing",
                  Any,
                  "faces it",
                  Flag,
                  {},
                  "Whether the segment faces one of the plane's segments in the slices around it."},
        TestWords{"certain_elsewhere",
                  Any,
                  "χ² of the best",
                  ChiSquare,
                  {},
                  "Whether the segment fits the plane beside it so well that no other is asked."},
        TestWords{"steepness",
                  Any,
                  "plane to slice",
                  SquaredSine,
                  {},
                  "Angle between the plane and the slice: a slice's own plane takes every line."},
        TestWords{
            "join_chi2",
            Any,
            "χ²",
            ChiSquare,
            {"likelihood.join-gate", "likelihood.apart-gate"},
            "How badly the segment fits the plane, with the covariances of both: 2 degrees of freedom. The limit is "
            "smaller for a plane that it does not face."},
        TestWords{
            "join_chi2",
            Known,
            "χ²",
            ChiSquare,
            {"likelihood.apart-gate", ""},
            "How badly the segment fits the plane that it does not face, with the covariances of both: 2 degrees of "
            "freedom."},
        TestWords{"join_chi2",
                  Move,
                  "χ²",
                  ChiSquare,
                  {},
                  "How badly the segment fits the other plane; the limit is how badly it fits its own, less 2."},
        TestWords{"rival_chi2",
                  Any,
                  "χ²",
                  ChiSquare,
                  {},
                  "How badly the segment fits the plane; the limit is how badly it fits the plane that it fits best."},
        TestWords{"fits_facing_plane",
                  Any,
                  "fits a facing plane",
                  Flag,
                  {},
                  "Whether the segment fits a plane that it faces; then no other is asked."},
        TestWords{"normal_variance",
                  Any,
                  "σ of n",
                  Variance,
                  {"likelihood.known-angle", ""},
                  "How well the plane's normal is known: its standard deviation."},
        TestWords{"slices_away",
                  Any,
                  "slices away",
                  Count,
                  {},
                  "How many slices ago the plane met a segment last; after eight it is out of sight."},
        TestWords{"own_chi2",
                  Any,
                  "χ² to its own",
                  ChiSquare,
                  {},
                  "How badly the segment fits its own plane; one that fits well stays."},
        TestWords{"moved_chi2",
                  Any,
                  "χ² + 2",
                  ChiSquare,
                  {},
                  "How badly the segment fits the other plane, and 2 more; the limit is how badly it fits its own."},
        TestWords{
            "near_chi2",
            Any,
            "χ², near",
            ChiSquare,
            {"likelihood.merge-gate", ""},
            "How far the planes are from each other by their covariances: 3 degrees of freedom. Below this limit they "
            "are looked at more closely."},
        TestWords{"scattered_chi2",
                  Any,
                  "χ², scattered",
                  ChiSquare,
                  {"likelihood.merge-gate", ""},
                  "The same with covariances that grow by as much as the planes' segments scatter."},
        TestWords{"adjacent",
                  Any,
                  "side by side",
                  Flag,
                  {"likelihood.merge-angle", ""},
                  "Whether segments of the two planes are beside each other, or both normals are known so well that it "
                  "does not matter."},
        TestWords{"merge_chi2",
                  Any,
                  "χ²",
                  ChiSquare,
                  {"likelihood.merge-gate", ""},
                  "How far the planes are from each other by their covariances: 3 degrees of freedom."},
        TestWords{"worse_together",
                  Any,
                  "E of both / E",
                  Plain,
                  {},
                  "How much worse one plane explains the segments of both than each explains its own."},
        TestWords{"seed_chi2",
                  Any,
                  "χ²",
                  ChiSquare,
                  {"likelihood.seed-gate", ""},
                  "How badly the three segments lie in one plane: 3 degrees of freedom."},
        TestWords{"pair_chi2",
                  Any,
                  "χ²",
                  ChiSquare,
                  {"likelihood.join-gate", ""},
                  "How badly the two segments lie in one plane."},
        TestWords{"parallel_chi2",
                  Any,
                  "χ², parallel",
                  ChiSquare,
                  {},
                  "How badly the plane of the two segments is parallel to the best of the other planes."},
        TestWords{"run_gain",
                  Any,
                  "χ² gained",
                  ChiSquare,
                  {},
                  "How much better a plane of its own explains the run that leans out."},
        TestWords{"contested_share",
                  Any,
                  "contested",
                  Share,
                  {"planes.max-contested", "planes.run-lean"},
                  "Share of the plane's points that are on runs of segments which lean out of it."},
        TestWords{"contested_remains",
                  Any,
                  "remains",
                  Share,
                  {},
                  "Share of the plane's points that were on planes taken apart before, which it lies like."},
        TestWords{"reduced_chi2",
                  Any,
                  "χ² / freedom",
                  Plain,
                  {"likelihood.split-sigmas", ""},
                  "How badly the plane's segments fit it, over their degrees of freedom."},
        TestWords{"free_strip_share",
                  Any,
                  "stands free",
                  Share,
                  {"likelihood.strip-share", "likelihood.strip-width"},
                  "Share of its slices in which a narrow plane stands free on both sides, as a pole does."},
        TestWords{"bent_share",
                  Any,
                  "bent",
                  Share,
                  {"likelihood.bent-share", ""},
                  "Share of the plane's points that are in segments which are no straight lines."},
    };
    return kTestWords;
}

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

std::span<const TestWords> allTestWords()
{
    return testWordTable();
}

const TestWords* wordsFor(std::string_view name, TestAbout about)
{
    const TestWords* general = nullptr;
    for (const TestWords& words : testWordTable()) {
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
            return Join;
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
