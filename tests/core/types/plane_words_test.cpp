// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/plane_words.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class PlaneWordsTest : public QObject {
    Q_OBJECT

private slots:
    void labelsHaveTwoDigitsAtLeast();
    void lineageNamesChildAndParents();
    void segmentsCountStepsFromOne();
};

void PlaneWordsTest::labelsHaveTwoDigitsAtLeast()
{
    QCOMPARE(planeLabel(0), std::string("P00"));
    QCOMPARE(planeLabel(9), std::string("P09"));
    QCOMPARE(planeLabel(137), std::string("P137"));
}

void PlaneWordsTest::lineageNamesChildAndParents()
{
    Plane plane;
    plane.id = 3;
    QCOMPARE(lineageText(plane), std::string());
    QCOMPARE(planeState(plane), std::string("live"));

    plane.lineage = {Lineage::Kind::Merged, {7, 11}};
    QCOMPARE(lineageText(plane), std::string("P03←P07+P11"));
    QCOMPARE(planeState(plane), std::string("merged"));

    plane.lineage = {Lineage::Kind::Split, {2}};
    QCOMPARE(lineageText(plane), std::string("P03←P02"));
    QCOMPARE(planeState(plane), std::string("split"));
}

void PlaneWordsTest::segmentsCountStepsFromOne()
{
    QCOMPARE(segmentLabel({63, 3}), std::string("64.3"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaneWordsTest)
#include "plane_words_test.moc"
