// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "tests/test_program.h"
#include "ui/models/number_text.h"

namespace planewright {

class CountedNounsTest : public QObject {
    Q_OBJECT

private slots:
    void countsHaveTheirNoun();
    void withoutAPlaneThereIsNoMeanError();
};

void CountedNounsTest::countsHaveTheirNoun()
{
    QCOMPARE(countText(0, "run", "runs"), QStringLiteral("0 runs"));
    QCOMPARE(countText(1, "run", "runs"), QStringLiteral("1 run"));
    QCOMPARE(countText(1200, "run", "runs"), QStringLiteral("1200 runs"));
}

void CountedNounsTest::withoutAPlaneThereIsNoMeanError()
{
    StepCounts counts;
    QCOMPARE(meanErrorText(counts), QStringLiteral("–"));
    counts.planes = 1;
    counts.meanError = 1.256;
    QCOMPARE(meanErrorText(counts), QStringLiteral("1.26"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CountedNounsTest)
#include "counted_nouns_test.moc"
