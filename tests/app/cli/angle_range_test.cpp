// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/angle_range.h"

#include <QTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

class AngleRangeTest : public QObject {
    Q_OBJECT

private slots:
    void countsAsTheTablesOfThePaper_data();
    void countsAsTheTablesOfThePaper();
    void mayGoDown();
    void withoutALimitTheCountComesFromElsewhere();
    void refusesWhatIsNoRange_data();
    void refusesWhatIsNoRange();
};

void AngleRangeTest::countsAsTheTablesOfThePaper_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("closed");
    QTest::addColumn<int>("count");
    QTest::newRow("tilts of Table VIII") << "10:170:1.16" << false << 137;
    QTest::newRow("bearings of Table VIII") << "0:180:0.25" << true << 721;
    QTest::newRow("all bearings of the scanner") << "-45:225:0.25" << true << 1081;
    QTest::newRow("a step that is no binary fraction") << "0:1:0.1" << false << 10;
    QTest::newRow("one bearing") << "90:90:1" << true << 1;
}

void AngleRangeTest::countsAsTheTablesOfThePaper()
{
    QFETCH(QString, text);
    QFETCH(bool, closed);
    QFETCH(int, count);

    const auto range = parseAngleRange("--x", text.toStdString(), closed ? RangeEnd::Closed : RangeEnd::Open, 65536);

    QVERIFY(range);
    QCOMPARE(range->count, count);
}

void AngleRangeTest::mayGoDown()
{
    const auto range = parseAngleRange("--tilt", "120:35:-0.5", RangeEnd::Open, 65536);

    QVERIFY(range);
    QCOMPARE(range->first, degrees(120.0));
    QCOMPARE(range->step, degrees(-0.5));
    QCOMPARE(range->count, 170);
}

void AngleRangeTest::withoutALimitTheCountComesFromElsewhere()
{
    const auto range = parseAngleRange("--tilt", "10:170:0.0001", RangeEnd::Open, std::nullopt);

    QVERIFY(range);
    QCOMPARE(range->count, 0);
}

void AngleRangeTest::refusesWhatIsNoRange_data()
{
    QTest::addColumn<QString>("text");
    for (const char* text : {"", ":", "1:2", "1:2:", "1:2:3:4", "1:2:3 ", "a:2:3", "1,5:2:3", "nan:2:1", "0:inf:1",
                             "0:180:0", "0:180:-1", "180:0:1", "10:11:2", "0:361:1", "0:180:1e-9", "0:180:1e-320"})
        QTest::newRow(text) << text;
}

void AngleRangeTest::refusesWhatIsNoRange()
{
    QFETCH(QString, text);

    const auto range = parseAngleRange("--tilt", text.toStdString(), RangeEnd::Open, 65536);

    QVERIFY(!range);
    QCOMPARE(range.error().code, ErrorCode::Usage);
    QVERIFY(range.error().message.starts_with("--tilt: '" + text.toStdString() + "' "));
}

PLANEWRIGHT_TEST(AngleRangeTest)
#include "angle_range_test.moc"
