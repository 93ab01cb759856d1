// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/stop_words.h"

#include <cstddef>
#include <memory>
#include <string>

#include <QTest>

#include "tests/test_program.h"

using namespace planewright;

namespace {

MapStop stopWith(StopTrust trust, std::size_t alternatives, bool hasOdometry)
{
    Stop given;
    if (hasOdometry)
        given.odometry = Motion{};
    MapStop stop;
    stop.stop = std::make_shared<const Stop>(given);
    stop.trust = trust;
    stop.alternatives.resize(alternatives);
    return stop;
}

}  // namespace

class StopWordsTest : public QObject {
    Q_OBJECT

private slots:
    void aStopThatIsNotPlacedSaysWhyAndWhatToDo();
    void odometryIsNotAskedForWhereThereIsOne();
    void otherPlacesAreCounted();
    void aDirectionThatPlanesDoNotFixIsNamed();
};

void StopWordsTest::aStopThatIsNotPlacedSaysWhyAndWhatToDo()
{
    const auto said = [](std::size_t places) { return warningOf(stopWith(StopTrust::Unplaced, places, false)); };
    const std::string remedy = "; it is left out. Give its odometry, or scan nearer";
    QCOMPARE(said(0), "its planes fix no place in the map" + remedy);
    QCOMPARE(said(1), "its planes fit a place in the map but do not fix it there" + remedy);
    QCOMPARE(said(2), "its planes fit 2 places in the map and nothing tells which" + remedy);
}

void StopWordsTest::odometryIsNotAskedForWhereThereIsOne()
{
    const auto said = [](std::size_t places) { return warningOf(stopWith(StopTrust::Unplaced, places, true)); };
    const std::string remedy = "; it is left out. Check its odometry, or scan once more between";
    QCOMPARE(said(0), "its planes fix no place in the map" + remedy);
    QCOMPARE(said(1),
             "its planes fit 1 other place in the map better than that of odometry, but not clearly so" + remedy);
    QCOMPARE(said(3),
             "its planes fit 3 other places in the map better than that of odometry, but not clearly so" + remedy);
}

void StopWordsTest::otherPlacesAreCounted()
{
    QCOMPARE(warningOf(stopWith(StopTrust::OdometryDecides, 1, true)),
             std::string("its planes would fit 1 other place as well; odometry alone tells which"));
    QCOMPARE(warningOf(stopWith(StopTrust::OdometryDecides, 2, true)),
             std::string("its planes would fit 2 other places as well; odometry alone tells which"));
}

void StopWordsTest::aDirectionThatPlanesDoNotFixIsNamed()
{
    MapStop stop = stopWith(StopTrust::Planes, 0, true);
    stop.strength.shift.weakestSigma = 0.04;
    stop.strength.shift.weakest = {0.0, 1.0, 0.0};
    QCOMPARE(warningOf(stop), std::string());
    stop.strength.shift.weakestSigma = 0.06;
    QCOMPARE(warningOf(stop), std::string("its planes do not fix it along (0.00 1.00 0.00); odometry does"));
    stop.strength.shift.weakestSigma.reset();
    QVERIFY(warningOf(stop).starts_with("its planes do not fix it along"));
    QCOMPARE(warningOf(stopWith(StopTrust::First, 0, false)), std::string());
}

PLANEWRIGHT_TEST(StopWordsTest)
#include "stop_words_test.moc"
