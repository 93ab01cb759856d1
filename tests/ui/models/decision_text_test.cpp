// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/decision_text.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class DecisionTextTest : public QObject {
    Q_OBJECT

private slots:
    void aSegmentJoinsAPlane();
    void whatFailedStandsOut();
    void aSplitTellsItsParts();
    void pairsTellAllConditions();
    void manyConditionsAreToldByThoseThatFail();
    void otherDecisionsInWords_data();
    void otherDecisionsInWords();
    void numbersThatDifferLookDifferent();
    void numbersHaveTheirUnits_data();
    void numbersHaveTheirUnits();
    void theSameNameMeansWhatItIsAbout();
    void conditionsNameTheirParameters();
    void phasesTellWhatTheyGave();
    void operandsAreReadFromWhatIsTyped();
    void whyNotIsAnsweredInASentence();
};

namespace {

using Kind = DecisionKind;

Test distance(double value, double limit = 0.05)
{
    return {"plane_distance", value, Comparison::Less, limit};
}

Snapshot planesOf(const std::vector<std::pair<PlaneId, int>>& sizes)
{
    Snapshot snapshot;
    for (const auto& [id, size] : sizes) {
        Plane plane;
        plane.id = id;
        plane.segments.resize(static_cast<std::size_t>(size));
        snapshot.planes.push_back(std::make_shared<const Plane>(plane));
    }
    return snapshot;
}

}  // namespace

void DecisionTextTest::aSegmentJoinsAPlane()
{
    // Files and reports count steps from 0, the screen from 1.
    const Decision decision{Phase::Assign,
                            Kind::Assign,
                            {SegmentId{62, 3}, PlaneRef{12}},
                            {distance(0.012), {"orthogonality", 0.031, Comparison::Less, 0.1}},
                            {PlaneRef{12}}};

    QCOMPARE(decisionLine(decision).plain(),
             QStringLiteral("seg 63.3 → P12: D 0.012 < 0.050 m ✔, |n·δ| 0.03 < 0.10 ✔"));
}

void DecisionTextTest::whatFailedStandsOut()
{
    const Decision decision{Phase::Assign,
                            Kind::Reject,
                            {SegmentId{62, 3}, PlaneRef{1}},
                            {distance(0.061), {"orthogonality", 0.031, Comparison::Less, 0.1}},
                            {}};

    const TextLine line = decisionLine(decision);

    QCOMPARE(line.plain(), QStringLiteral("seg 63.3 not → P01: D 0.061 < 0.050 m ✘, |n·δ| 0.03 < 0.10 ✔"));
    QString failed;
    for (const TextPart& part : line.parts)
        failed += part.tone == TextTone::Fail ? part.text : QString{};
    QCOMPARE(failed, QStringLiteral("D 0.061 < 0.050 m ✘"));
}

void DecisionTextTest::aSplitTellsItsParts()
{
    const std::vector<Decision> decisions{{Phase::SplitMerge,
                                           Kind::Split,
                                           {PlaneRef{7}},
                                           {{"fitting_error", 4.31, Comparison::Greater, 4.0}},
                                           {PlaneRef{7}, PlaneRef{16}}},
                                          {Phase::SplitMerge, Kind::Cluster, {SegmentId{1, 1}}, {}, {ClusterRef{2}}},
                                          {Phase::SplitMerge, Kind::Cluster, {SegmentId{1, 2}}, {}, {ClusterRef{2}}},
                                          {Phase::SplitMerge, Kind::Near, {PlaneRef{7}, PlaneRef{16}}, {}, {}},
                                          {Phase::SplitMerge, Kind::Cluster, {SegmentId{1, 3}}, {}, {ClusterRef{2}}}};
    const Snapshot after = planesOf({{7, 18}, {16, 9}});

    QCOMPARE(setFreeBySplit(decisions, 0), 2);
    QCOMPARE(setFreeBySplit(decisions, 3), 0);
    QCOMPARE(decisionLine(decisions[0], {&after, 2, {}}).plain(),
             QStringLiteral("Split P07: E 4.31 > 4.00 ✔ → P07 (18 seg), P16 (9 seg), 2 back to clusters"));
}

void DecisionTextTest::pairsTellAllConditions()
{
    const Decision near{Phase::SplitMerge,
                        Kind::Near,
                        {PlaneRef{3}, PlaneRef{11}},
                        {{"normal_alignment", 0.9991, Comparison::Greater, std::cos(degrees(5.0))},
                         distance(0.061, 0.025),
                         {"in_plane_gap", 0.0, Comparison::LessEqual, 0.5},
                         {"fitting_error", 1.5, Comparison::LessEqual, 4.0}},
                        {}};

    QCOMPARE(decisionLine(near).plain(),
             QStringLiteral("P03 ~ P11 stay two: |n·n| 0.9991 > 0.9962 ✔, D 0.061 < 0.025 m ✘, gap 0.000 ≤ 0.500 m ✔, "
                            "E 1.50 ≤ 4.00 ✔"));
}

void DecisionTextTest::manyConditionsAreToldByThoseThatFail()
{
    Decision fit{Phase::Fit,
                 Kind::Fit,
                 {ClusterRef{4}},
                 {{"segments", 6.0, Comparison::GreaterEqual, 4.0},
                  {"slices", 4.0, Comparison::GreaterEqual, 3.0},
                  {"points", 200.0, Comparison::GreaterEqual, 60.0}},
                 {PlaneRef{15}}};
    const Snapshot after = planesOf({{15, 6}});

    QCOMPARE(decisionLine(fit, {&after, 0, {}}).plain(), QStringLiteral("C4 → P15 (6 seg): all 3 conditions hold ✔"));
    fit.kind = Kind::NoFit;
    fit.operands.emplace_back(SegmentId{59, 2});
    fit.result.clear();
    fit.tests[2].value = 48.0;
    QCOMPARE(decisionLine(fit).plain(), QStringLiteral("C4 around seg 60.2: no plane: points 48 ≥ 60 ✘"));
}

void DecisionTextTest::otherDecisionsInWords_data()
{
    QTest::addColumn<Decision>("decision");
    QTest::addColumn<QString>("text");
    const SegmentId segment{62, 3};
    QTest::newRow("too few points") << Decision{Phase::Extract,
                                                Kind::Reject,
                                                {PieceRef{62, 47, 51}},
                                                {{"points", 5.0, Comparison::GreaterEqual, 7.0}},
                                                {}}
                                    << QStringLiteral("beams 47–51 discarded: points 5 ≥ 7 ✘");
    QTest::newRow("too short") << Decision{Phase::Extract,
                                           Kind::Reject,
                                           {PieceRef{62, 47, 66}},
                                           {{"points", 20.0, Comparison::GreaterEqual, 7.0},
                                            {"length", 0.1243, Comparison::GreaterEqual, 0.2}},
                                           {}}
                               << QStringLiteral("beams 47–66 discarded: points 20 ≥ 7 ✔, length 0.124 ≥ 0.200 m ✘");
    QTest::newRow("a mixed pixel") << Decision{Phase::Extract,
                                               Kind::Reject,
                                               {PieceRef{62, 30, 30}},
                                               {{"line_distance", 0.051, Comparison::LessEqual, 0.03}},
                                               {}}
                                   << QStringLiteral("beam 30 discarded: off the line 0.051 ≤ 0.030 m ✘");
    QTest::newRow("without any plane") << Decision{Phase::Assign, Kind::Reject, {segment}, {}, {}}
                                       << QStringLiteral("seg 63.3 fits no plane");
    QTest::newRow("leaves its plane") << Decision{Phase::Finish,
                                                  Kind::Reject,
                                                  {segment, PlaneRef{7}},
                                                  {{"join_chi2", 31.2, Comparison::Less, 25.0}},
                                                  {}}
                                      << QStringLiteral("seg 63.3 leaves P07: χ² 31.2 < 25.0 ✘");
    QTest::newRow("moves")
        << Decision{Phase::Finish, Kind::Assign, {segment, PlaneRef{7}}, {distance(0.01, 0.02)}, {PlaneRef{12}}}
        << QStringLiteral("seg 63.3: P07 → P12: D 0.010 < 0.020 m ✔");
    QTest::newRow("joins a cluster") << Decision{Phase::Cluster,
                                                 Kind::Cluster,
                                                 {segment},
                                                 {{"similarity", 0.9961, Comparison::Greater, 0.9848}},
                                                 {ClusterRef{5}}}
                                     << QStringLiteral("seg 63.3 → C5: |δ·δ| 0.9961 > 0.9848 ✔");
    QTest::newRow("begins a cluster") << Decision{Phase::Cluster,
                                                  Kind::Cluster,
                                                  {segment},
                                                  {{"direction_similarity", 0.5, Comparison::Greater, 0.9848}},
                                                  {ClusterRef{9}}}
                                      << QStringLiteral("seg 63.3 → C9 (new): |δ·δ| 0.5000 > 0.9848 ✘");
    QTest::newRow("of three segments") << Decision{Phase::Fit,
                                                   Kind::Fit,
                                                   {SegmentId{0, 1}, SegmentId{1, 1}, SegmentId{2, 0}},
                                                   {{"seed_chi2", 3.0, Comparison::Less, 11.3}},
                                                   {PlaneRef{0}}}
                                       << QStringLiteral("seg 1.1 + seg 2.1 + seg 3.0 → P00: χ² 3.0 < 11.3 ✔");
    QTest::newRow("given up") << Decision{Phase::Fit,
                                          Kind::NoFit,
                                          {PlaneRef{8}},
                                          {{"incidence", std::sin(degrees(2.0)), Comparison::GreaterEqual,
                                            std::sin(degrees(3.0))}},
                                          {}}
                              << QStringLiteral("P08 given up: incidence 2.0 ≥ 3.0° ✘");
    QTest::newRow("taken apart") << Decision{Phase::Finish,
                                             Kind::Split,
                                             {PlaneRef{8}},
                                             {{"contested_share", 0.4, Comparison::Greater, 0.25}},
                                             {}}
                                 << QStringLiteral("Split P08: contested 40 > 25 % ✔ → taken apart");
    QTest::newRow("loses its worst") << Decision{Phase::Finish,
                                                 Kind::Split,
                                                 {PlaneRef{8}, segment},
                                                 {{"reduced_chi2", 2.5, Comparison::Greater, 1.75}},
                                                 {PlaneRef{8}}}
                                     << QStringLiteral("P08 without seg 63.3: χ² / freedom 2.50 > 1.75 ✔");
    QTest::newRow("merged") << Decision{Phase::SplitMerge,
                                        Kind::Merge,
                                        {PlaneRef{3}, PlaneRef{11}},
                                        {{"adjacent", 1.0, Comparison::GreaterEqual, 1.0}},
                                        {PlaneRef{3}}}
                            << QStringLiteral("P03 + P11 → P03: side by side: yes ✔");
}

void DecisionTextTest::otherDecisionsInWords()
{
    QFETCH(Decision, decision);
    QFETCH(QString, text);

    QCOMPARE(decisionLine(decision).plain(), text);
}

void DecisionTextTest::numbersThatDifferLookDifferent()
{
    QCOMPARE(textOf(distance(0.05004), TestAbout::Join).text(), QStringLiteral("D 0.05004 < 0.05000 m"));
    QCOMPARE(textOf(distance(0.05), TestAbout::Join).text(), QStringLiteral("D 0.050 < 0.050 m"));
    QCOMPARE(textOf({"shared_segments", 0.5999, Comparison::GreaterEqual, 0.6}, TestAbout::Absorb).text(),
             QStringLiteral("shared 59.99 ≥ 60.00 %"));
}

void DecisionTextTest::numbersHaveTheirUnits_data()
{
    QTest::addColumn<Test>("test");
    QTest::addColumn<QString>("text");
    const auto inf = std::numeric_limits<double>::infinity();
    QTest::newRow("radians") << Test{"normal_sigma", degrees(9.1), Comparison::LessEqual, degrees(8.0)}
                             << QStringLiteral("σ of n 9.1 ≤ 8.0°");
    QTest::newRow("a variance") << Test{"normal_variance", degrees(2.0) * degrees(2.0), Comparison::Less,
                                        degrees(1.7) * degrees(1.7)}
                                << QStringLiteral("σ of n 2.0 < 1.7°");
    QTest::newRow("a squared sine") << Test{"steepness", 0.25, Comparison::Greater, 0.0027}
                                    << QStringLiteral("plane to slice 30.0 > 3.0°");
    QTest::newRow("no gap to measure") << Test{"in_plane_gap", inf, Comparison::LessEqual, 0.5}
                                       << QStringLiteral("gap ∞ ≤ 0.500 m");
    QTest::newRow("never seen") << Test{"slices_away", 2147483647.0, Comparison::LessEqual, 8.0}
                                << QStringLiteral("slices away ∞ ≤ 8");
    QTest::newRow("no") << Test{"facing", 0.0, Comparison::GreaterEqual, 1.0} << QStringLiteral("faces it: no");
    QTest::newRow("a name without words")
        << Test{"some_thing", 1.0, Comparison::Less, 2.0} << QStringLiteral("some thing 1.00 < 2.00");
}

void DecisionTextTest::numbersHaveTheirUnits()
{
    QFETCH(Test, test);
    QFETCH(QString, text);

    QCOMPARE(textOf(test, TestAbout::Any).text(), text);
    if (test.name == "in_plane_gap")
        QCOMPARE(textOf(test, TestAbout::Any, {true, 2}).text(), QStringLiteral("gap ∞ ≤ 500 mm"));
}

void DecisionTextTest::theSameNameMeansWhatItIsAbout()
{
    const auto keyOf = [](std::string_view name, TestAbout about) {
        return QString::fromStdString(std::string{wordsFor(name, about)->parameters.front()});
    };
    const std::vector<Test> likely{{"normal_alignment", 1.0, Comparison::Greater, 0.9},
                                   {"adjacent", 1.0, Comparison::GreaterEqual, 1.0}};

    QCOMPARE(keyOf("plane_distance", TestAbout::Join), QStringLiteral("assignment.plane-distance"));
    QCOMPARE(keyOf("plane_distance", TestAbout::Merge), QStringLiteral("planes.merge-distance"));
    QCOMPARE(keyOf("join_chi2", aboutOf("join_known", {})), QStringLiteral("likelihood.apart-gate"));
    QCOMPARE(keyOf("normal_alignment", aboutOf("merge", {})), QStringLiteral("planes.merge-angle"));
    QCOMPARE(keyOf("normal_alignment", aboutOf("merge", likely)), QString{});
}

void DecisionTextTest::conditionsNameTheirParameters()
{
    const TextLine line = testLine({"fitting_error", 4.31, Comparison::Greater, 4.0}, TestAbout::Split);

    QCOMPARE(line.plain(), QStringLiteral("E 4.31 > 4.00 ✔  Error limit"));
    QCOMPARE(line.parts.back().tone, TextTone::Link);
    QVERIFY(meaningOf(distance(0.01), TestAbout::Join).contains(QStringLiteral("assignment.plane-distance-sigmas")));
    QVERIFY(meaningOf({"normal_alignment", std::cos(degrees(2.5)), Comparison::Greater, 0.9}, TestAbout::Tracks)
                .contains(QStringLiteral("is 2.5°")));
}

void DecisionTextTest::phasesTellWhatTheyGave()
{
    StepCounts counts;
    counts.segments = 12;
    counts.returns = 689;
    const std::vector<Decision> decisions{
        {Phase::Remaining, Kind::Assign, {SegmentId{1, 1}}, {}, {PlaneRef{1}}},
        {Phase::Remaining, Kind::Assign, {SegmentId{1, 2}, PlaneRef{2}}, {}, {PlaneRef{2}}},
        {Phase::Remaining, Kind::Reject, {SegmentId{1, 3}}, {}, {}}};

    const std::vector<Decision> discarded{{Phase::Extract, Kind::Reject, {PieceRef{1, 40, 41}}, {}, {}}};
    QCOMPARE(phaseResult(Phase::Extract, counts, {}), QStringLiteral("12 segments in 689 points"));
    QCOMPARE(phaseResult(Phase::Extract, counts, discarded), QStringLiteral("12 segments in 689 points, 1 discarded"));
    QCOMPARE(phaseResult(Phase::Remaining, counts, decisions), QStringLiteral("2 assigned, 1 fit none"));
    QCOMPARE(phaseResult(Phase::SplitMerge, counts, {}), QStringLiteral("nothing"));
    QCOMPARE(phaseTitle(Phase::SplitMerge, {}), QStringLiteral("Split and merge"));
    QCOMPARE(phaseTitle(Phase::Finish, "drop_unfounded"), QStringLiteral("Give up unfounded planes"));
}

void DecisionTextTest::operandsAreReadFromWhatIsTyped()
{
    const auto plane = [](const QString& text) { return std::get<PlaneRef>(*operandOf(text)).id; };
    QCOMPARE(plane("P07"), 7);
    QCOMPARE(plane(" p12 "), 12);
    QCOMPARE(plane("3"), 3);
    QVERIFY(std::get<SegmentId>(*operandOf("64.3")) == (SegmentId{63, 3}));
    QVERIFY(std::get<SegmentId>(*operandOf("seg 1.0")) == (SegmentId{0, 0}));
    for (const char* wrong : {"", "P", "floor", "P1.2.3", "-4", "12345678901234567890", "64."})
        QVERIFY2(!operandOf(wrong), wrong);
}

void DecisionTextTest::whyNotIsAnsweredInASentence()
{
    const Conditions fails{"merge", {distance(0.06)}};
    const Conditions holds{"absorb", {distance(0.01)}};
    QCOMPARE(whyNotAnswer({{PlaneRef{3}, PlaneRef{11}}, false, {fails}}),
             QStringLiteral("P03 and P11 stay two: no way has all its conditions."));
    QCOMPARE(whyNotAnswer({{PlaneRef{3}, PlaneRef{11}}, false, {fails, holds}}),
             QStringLiteral("P03 and P11 are not one yet: they become one when it is due next."));
    QCOMPARE(whyNotAnswer({{PlaneRef{3}, SegmentId{63, 3}}, false, {fails}}),
             QStringLiteral("Seg 64.3 is not in P03: no way has all its conditions."));
    QCOMPARE(whyNotAnswer({{SegmentId{63, 3}, PlaneRef{3}}, true, {holds}}), QStringLiteral("Seg 64.3 is in P03."));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DecisionTextTest)
#include "decision_text_test.moc"
