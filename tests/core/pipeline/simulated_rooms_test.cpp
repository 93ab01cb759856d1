// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QTest>

#include "simulated_room.h"
#include "tests/test_program.h"

using namespace planewright;

class SimulatedRoomsTest : public QObject {
    Q_OBJECT

private slots:
    void nearlyAllPlanesAreFoundAndFewAreFalse();
    void fewPointsAreReadTwice_data();
    void fewPointsAreReadTwice();
    void theTwelvePlanesOfTableXiiAreFound();
    void anEmptyRoomHasNoPlanes();
    void aHostileRoomIsSurvived();
};

void SimulatedRoomsTest::nearlyAllPlanesAreFoundAndFewAreFalse()
{
    RoomTotals found;

    for (const std::string_view scene : {"corridor", "office", "hall"}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const SimulatedRoom room = scanOf(scene, "default", seed);
            found += comparedWithTruth(room, *extracted(room.scan.recording), 400);
        }
    }

    QVERIFY2(static_cast<double>(found.correct) >= 0.95 * static_cast<double>(found.truePlanes),
             qPrintable(QString("%1 of %2 planes found").arg(found.correct).arg(found.truePlanes)));
    QVERIFY2(static_cast<double>(found.correct) >= 0.95 * static_cast<double>(found.foundPlanes),
             qPrintable(QString("%1 of %2 found planes are true").arg(found.correct).arg(found.foundPlanes)));
}

void SimulatedRoomsTest::fewPointsAreReadTwice_data()
{
    QTest::addColumn<QString>("scene");

    for (const char* scene : {"corridor", "office", "hall"})
        QTest::newRow(scene) << scene;
}

void SimulatedRoomsTest::fewPointsAreReadTwice()
{
    QFETCH(const QString, scene);
    const SimulatedRoom room = scanOf(scene.toStdString(), "default", 3);

    const auto found = extracted(room.scan.recording);

    const auto segments = static_cast<double>(found->segments.segmentCount());
    QVERIFY(segments > 300.0);
    QVERIFY(100.0 * 2.0 * segments / (137.0 * 721.0) < 5.0);  // Eq. (23)
}

void SimulatedRoomsTest::theTwelvePlanesOfTableXiiAreFound()
{
    const SimulatedRoom room = scanOf("twelve", "default", 1);

    const auto found = extracted(room.scan.recording);

    const LabelComparison compared = comparedWithTruth(room, *found, 400);
    QCOMPARE(compared.groups, std::size_t(12));
    QVERIFY2(compared.correct.size() >= 11, qPrintable(QString::number(compared.correct.size())));
}

void SimulatedRoomsTest::anEmptyRoomHasNoPlanes()
{
    const SimulatedRoom room = scanOf("empty", "default", 1);

    const auto found = extracted(room.scan.recording);

    QCOMPARE(found->segments.segmentCount(), std::size_t(0));
    QVERIFY(found->planes.empty());
}

void SimulatedRoomsTest::aHostileRoomIsSurvived()
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const SimulatedRoom room = scanOf("hostile", "default", seed);

        const auto found = extracted(room.scan.recording);

        for (const auto& plane : found->planes) {
            QVERIFY(plane->normal.allFinite());
            QVERIFY(std::abs(plane->normal.norm() - 1.0) < 1e-9);
            QVERIFY(plane->distance >= 0.0);
            QVERIFY(std::isfinite(plane->fittingError));
        }
    }
}

PLANEWRIGHT_TEST(SimulatedRoomsTest)
#include "simulated_rooms_test.moc"
