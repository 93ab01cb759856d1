// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/slice_model.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class SliceModelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void rowsStandInBearingOrder();
    void aKeptPieceNamesItsPlane();
    void aDiscardedPieceSaysWhyWithTheNumbers();
    void breaksSplitsAndJoinsSayWhy();
    void segmentsAreFoundByTheirIds();
    void theSummaryCounts();
    void withoutASliceThereIsNothing();

private:
    QString cell(int row, SliceColumn column) const
    {
        return model_.index(row, static_cast<int>(column)).data().toString();
    }

    SliceModel model_;
};

/// By hand: beams of 0.5° from bearing 0 on, all 2 m long.
void SliceModelTest::init()
{
    auto slice = std::make_shared<ScanSlice>();
    slice->step = 62;
    slice->tilt = degrees(81.9);
    slice->bearingStep = degrees(0.5);
    slice->ranges.assign(100, 2.0);
    auto sketch = std::make_shared<SliceSketch>();
    sketch->slice = slice;
    SliceTrace& trace = sketch->trace;
    trace.runs = {{0, 59, 60}, {64, 99, 36}};
    trace.pieces = {
        {0, 40, 41, 0.7, PieceFate::Segment, 0, {{"points", 41, Comparison::GreaterEqual, 7}}},
        {41,
         59,
         19,
         0.124,
         PieceFate::TooShort,
         -1,
         {{"points", 19, Comparison::GreaterEqual, 7}, {"length", 0.124, Comparison::GreaterEqual, 0.2}}},
        {64, 66, 3, 0.03, PieceFate::TooFewPoints, -1, {{"points", 3, Comparison::GreaterEqual, 7}}},
        {67, 97, 31, 0.6, PieceFate::Segment, 1, {}},
        {98, 98, 1, 0.0, PieceFate::OffTheLines, -1, {{"line_distance", 0.0512, Comparison::LessEqual, 0.03}}},
        {99, 99, 1, 0.0, PieceFate::OffTheLines, -1, {{"line_chi2", 12.34, Comparison::LessEqual, 9.0}}}};
    trace.splits = {{41, {"chord_distance", 0.0512, Comparison::Greater, 0.03}},
                    {67, {"two_lines_gain", 83.21, Comparison::Greater, 25.0}}};
    trace.breaks = {{59, 64, 2.5, 0.106, false}};
    trace.joins = {{80, 81}};
    sketch->colours.resize(6);
    sketch->owners = {"P03", "", "", "", "", ""};
    model_.setSketch(sketch);
}

void SliceModelTest::rowsStandInBearingOrder()
{
    QStringList whats;
    for (int row = 0; row < model_.rowCount(); ++row)
        whats << cell(row, SliceColumn::What);

    QCOMPARE(whats, (QStringList{"Segment 63.0", "✘ Discarded", "◆ Split point", "□ Breakpoint", "✘ Discarded",
                                 "Segment 63.1", "◆ Split point", "○ Joined", "✘ Discarded", "✘ Discarded"}));
}

void SliceModelTest::aKeptPieceNamesItsPlane()
{
    QCOMPARE(cell(0, SliceColumn::Why), QStringLiteral("in P03"));
    QCOMPARE(cell(0, SliceColumn::Beams), QStringLiteral("0–40"));
    QCOMPARE(cell(0, SliceColumn::Bearing), QStringLiteral("0.0–20.0"));
    QCOMPARE(cell(0, SliceColumn::Points), QStringLiteral("41"));
    QCOMPARE(cell(0, SliceColumn::Length), QStringLiteral("0.700"));
    QCOMPARE(cell(5, SliceColumn::Why), QStringLiteral("in no plane"));
}

void SliceModelTest::aDiscardedPieceSaysWhyWithTheNumbers()
{
    QCOMPARE(cell(1, SliceColumn::Why), QStringLiteral("Too short: length 0.124 m < 0.200 m"));
    QCOMPARE(cell(4, SliceColumn::Why), QStringLiteral("Too few points: points 3 < 7"));
    QCOMPARE(cell(8, SliceColumn::Why), QStringLiteral("Off the lines beside it: 0.051 m > 0.030 m"));
    QCOMPARE(cell(9, SliceColumn::Why), QStringLiteral("Off the lines beside it: χ² 12.3 > 9.0"));
    QCOMPARE(model_.sentence(1),
             QStringLiteral("✘ Discarded: Too short: length 0.124 m < 0.200 m (19 points, 0.124 m)"));
}

void SliceModelTest::breaksSplitsAndJoinsSayWhy()
{
    QCOMPARE(cell(2, SliceColumn::Why), QStringLiteral("From the chord 0.051 m > 0.030 m"));
    QCOMPARE(cell(3, SliceColumn::Why), QStringLiteral("Gap 2.500 m ≥ 0.106 m"));
    QCOMPARE(cell(6, SliceColumn::Why), QStringLiteral("Two lines fit better: χ² 83.2 > 25.0"));
    QCOMPARE(cell(7, SliceColumn::Why), QStringLiteral("One line fits both sides"));
}

void SliceModelTest::segmentsAreFoundByTheirIds()
{
    QCOMPARE(model_.rowOf(SegmentId{62, 1}), std::optional<int>(5));
    QCOMPARE(model_.rowOf(SegmentId{61, 1}), std::nullopt);
    QVERIFY(model_.segmentAt(5) == (SegmentId{62, 1}));
    QVERIFY(!model_.segmentAt(1));
    QCOMPARE(model_.rowOf(SlicePart::Break, 0), std::optional<int>(3));
}

void SliceModelTest::theSummaryCounts()
{
    QCOMPARE(model_.summary(), QStringLiteral("Step 63, φ 81.9°: 2 runs, 2 segments, 4 discarded"));
}

void SliceModelTest::withoutASliceThereIsNothing()
{
    model_.setSketch(nullptr);

    QCOMPARE(model_.rowCount(), 0);
    QVERIFY(model_.summary().isEmpty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SliceModelTest)
#include "slice_model_test.moc"
