// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/former_extractions.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

/// Histories without steps, told apart by how many they were planned to have.
class FormerExtractionsTest : public QObject {
    Q_OBJECT

private slots:
    void theLastIsTakenBackFirstAndMadeAgainFirst();
    void anotherRerunEndsWhatWasTakenBack();
    void theLastEightAreKept();
};

void FormerExtractionsTest::theLastIsTakenBackFirstAndMadeAgainFirst()
{
    FormerExtractions former;
    ScanHistory present{{}, 1};
    former.replace(present, {{}, 2});
    former.replace(present, {{}, 3});
    QCOMPARE(present.plannedSteps(), 3);

    QVERIFY(former.takeBack(present));
    QCOMPARE(present.plannedSteps(), 2);
    QVERIFY(former.takeBack(present));
    QCOMPARE(present.plannedSteps(), 1);
    QVERIFY(!former.takeBack(present));
    QCOMPARE(present.plannedSteps(), 1);

    QVERIFY(former.makeAgain(present));
    QCOMPARE(present.plannedSteps(), 2);
    QVERIFY(former.makeAgain(present));
    QCOMPARE(present.plannedSteps(), 3);
    QVERIFY(!former.makeAgain(present));
    QCOMPARE(former.size(), std::size_t(2));
}

void FormerExtractionsTest::anotherRerunEndsWhatWasTakenBack()
{
    FormerExtractions former;
    ScanHistory present{{}, 1};
    former.replace(present, {{}, 2});
    QVERIFY(former.takeBack(present));

    former.replace(present, {{}, 3});

    QVERIFY(!former.makeAgain(present));
    QVERIFY(former.takeBack(present));
    QCOMPARE(present.plannedSteps(), 1);
}

void FormerExtractionsTest::theLastEightAreKept()
{
    FormerExtractions former;
    ScanHistory present{{}, 1};
    for (int planned = 2; planned <= 12; ++planned)
        former.replace(present, {{}, planned});

    while (former.takeBack(present)) {
    }

    QCOMPARE(present.plannedSteps(), 4);  // 12 − 8
    former.clear();
    QVERIFY(!former.makeAgain(present));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::FormerExtractionsTest)
#include "former_extractions_test.moc"
