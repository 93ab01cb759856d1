// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/recorded_slice.h"

#include <QTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

class RecordedSliceTest : public QObject {
    Q_OBJECT

private slots:
    void degreesThatWereReadReadBackToTheSameRadians();
    void degreesAreTheOnesThatPeopleWrote();
    void aSliceAsRecordedStaysAsItIs();
    void rangesAreWholeMillimetresHalfUp();
};

void RecordedSliceTest::degreesThatWereReadReadBackToTheSameRadians()
{
    for (int i = -36000; i <= 36000; ++i) {
        const double radians = degrees(i / 97.0);

        QCOMPARE(degrees(degreesReadingBackTo(radians)), radians);
    }
}

void RecordedSliceTest::degreesAreTheOnesThatPeopleWrote()
{
    for (int i = 0; i <= 3600; ++i)
        QCOMPARE(degreesReadingBackTo(degrees(i / 10.0)), i / 10.0);
}

void RecordedSliceTest::aSliceAsRecordedStaysAsItIs()
{
    for (int i = 0; i < 1000; ++i) {
        ScanSlice slice;
        slice.tilt = 0.2 + 0.0029 * i;  // radians that no degrees may have given
        slice.tiltEnd = slice.tilt + 1e-3;
        slice.ranges = {0.0012345 * i};

        const ScanSlice once = asRecorded(slice);
        const ScanSlice twice = asRecorded(once);

        QVERIFY(std::abs(once.tilt - slice.tilt) < 1e-15);
        QCOMPARE(twice.tilt, once.tilt);
        QCOMPARE(*twice.tiltEnd, *once.tiltEnd);
        QCOMPARE(twice.ranges, once.ranges);
    }
}

void RecordedSliceTest::rangesAreWholeMillimetresHalfUp()
{
    QCOMPARE(recordedMillimetres(1.0004), 1000.0);
    QCOMPARE(recordedMillimetres(0.0625), 63.0);  // 62.5 exactly
    QCOMPARE(recordedMillimetres(-1.0), 0.0);
    QCOMPARE(recordedMillimetres(std::nan("")), 0.0);
}

PLANEWRIGHT_TEST(RecordedSliceTest)
#include "recorded_slice_test.moc"
