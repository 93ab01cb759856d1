// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/segment_log.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

namespace {

/// A slice of segments that name themselves.
std::shared_ptr<const Segments> segmentsOf(int step, int count)
{
    Segments segments(static_cast<std::size_t>(count));
    for (int index = 0; index < count; ++index)
        segments[static_cast<std::size_t>(index)].id = {step, index};
    return std::make_shared<const Segments>(std::move(segments));
}

/// A log of so many slices: steps 0, 2, 4, … with 0, 1, 2, 0, 1, 2, … segments.
SegmentLog logOf(int slices)
{
    SegmentLog log;
    for (int i = 0; i < slices; ++i)
        log.append(2 * i, segmentsOf(2 * i, i % 3));
    return log;
}

}  // namespace

class SegmentLogTest : public QObject {
    Q_OBJECT

private slots:
    void aNewLogIsEmpty();
    void everySliceIsFoundAgain_data();
    void everySliceIsFoundAgain();
    void stepsThatWereNotSeenAreNotFound();
    void segmentsAreReadByTheirIds();
    void aCopyStaysAsItWasWhenTheLogGrows_data();
    void aCopyStaysAsItWasWhenTheLogGrows();
    void copiesShareTheirSegments();
};

void SegmentLogTest::aNewLogIsEmpty()
{
    const SegmentLog log;

    QCOMPARE(log.slices(), std::size_t(0));
    QCOMPARE(log.segmentCount(), std::size_t(0));
    QCOMPARE(log.find(0), std::size_t(0));
}

void SegmentLogTest::everySliceIsFoundAgain_data()
{
    // 64 slices fill a shared chunk: just under, on and over that, and over it several times.
    QTest::addColumn<int>("slices");
    for (const int slices : {1, 63, 64, 65, 127, 128, 129, 300})
        QTest::addRow("%d slices", slices) << slices;
}

void SegmentLogTest::everySliceIsFoundAgain()
{
    QFETCH(int, slices);

    const SegmentLog log = logOf(slices);

    QCOMPARE(log.slices(), static_cast<std::size_t>(slices));
    std::size_t segments = 0;
    for (std::size_t i = 0; i < log.slices(); ++i) {
        QCOMPARE(log.stepOf(i), 2 * static_cast<int>(i));
        QCOMPARE(log.find(2 * static_cast<int>(i)), i);
        QCOMPARE(log.slice(i).size(), i % 3);
        segments += i % 3;
    }
    QCOMPARE(log.segmentCount(), segments);
}

void SegmentLogTest::stepsThatWereNotSeenAreNotFound()
{
    const SegmentLog log = logOf(130);

    for (int step = -1; step <= 261; step += 2)
        QCOMPARE(log.find(step), log.slices());
    QCOMPARE(log.find(260), log.slices());
    QCOMPARE(log.find(1000000), log.slices());
}

void SegmentLogTest::segmentsAreReadByTheirIds()
{
    const SegmentLog log = logOf(200);

    for (const SegmentId id : {SegmentId{2, 0}, SegmentId{4, 1}, SegmentId{142, 1}, SegmentId{394, 1}})
        QVERIFY(log[id].id == id);
}

void SegmentLogTest::aCopyStaysAsItWasWhenTheLogGrows_data()
{
    QTest::addColumn<int>("slices");
    for (const int slices : {0, 10, 63, 64, 65, 128})
        QTest::addRow("%d slices", slices) << slices;
}

void SegmentLogTest::aCopyStaysAsItWasWhenTheLogGrows()
{
    QFETCH(int, slices);
    SegmentLog log = logOf(slices);
    const SegmentLog copy = log;

    for (int i = slices; i < slices + 100; ++i)
        log.append(2 * i, segmentsOf(2 * i, 1));

    const SegmentLog expected = logOf(slices);
    QCOMPARE(copy.slices(), expected.slices());
    QCOMPARE(copy.segmentCount(), expected.segmentCount());
    for (std::size_t i = 0; i < copy.slices(); ++i) {
        QCOMPARE(copy.stepOf(i), expected.stepOf(i));
        QCOMPARE(copy.slice(i).size(), expected.slice(i).size());
    }
    QCOMPARE(log.slices(), expected.slices() + 100);
}

void SegmentLogTest::copiesShareTheirSegments()
{
    const SegmentLog log = logOf(70);

    const SegmentLog copy = log;

    for (std::size_t i = 0; i < log.slices(); ++i)
        QCOMPARE(&copy.slice(i), &log.slice(i));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SegmentLogTest)
#include "segment_log_test.moc"
