// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <Eigen/LU>
#include <QTest>

#include "core/params/registry.h"
#include "simulated_room.h"
#include "tests/core/params/preset_parameters.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

/// 1 or −1, so that a found normal times it is on the side of the true one.
double sideOf(const Plane& plane, const TruePlane& truth)
{
    return plane.normal.dot(truth.normal) < 0.0 ? -1.0 : 1.0;
}

/// The found plane nearest to a true one by its parameters.
const Plane& nearestTo(const TruePlane& truth, const Snapshot& found)
{
    const auto apart = [&](const Plane& plane) {
        const double side = sideOf(plane, truth);
        return (side * plane.normal - truth.normal).norm() + std::abs(side * plane.distance - truth.distance);
    };
    return **std::min_element(found.planes.begin(), found.planes.end(),
                              [&](const auto& a, const auto& b) { return apart(*a) < apart(*b); });
}

}  // namespace

class PreciseRoomsTest : public QObject {
    Q_OBJECT

private slots:
    void planesOfSimulatedRoomsAreFound_data();
    void planesOfSimulatedRoomsAreFound();
    void noiseFreeWallsAreExact();
    void covariancesAreHonest();
    void theScaleOfASceneChangesNothing_data();
    void theScaleOfASceneChangesNothing();
    void noiseThatIsNotEstimatedIsAsToldAgain();
    void theNoiseOfTheScannerIsFound_data();
    void theNoiseOfTheScannerIsFound();
    void explanationsChangeNothing();
    void everyDecisionHasItsNumbers();
    void snapshotsInBetweenChangeNothing();
    void aSliceAtATimeIsTheWholeScan();
    void emptyAndHostileRoomsAreSurvived();
    void changedParametersTakeEffect();
};

void PreciseRoomsTest::planesOfSimulatedRoomsAreFound_data()
{
    QTest::addColumn<QString>("scene");
    QTest::addColumn<double>("share");

    QTest::newRow("office") << "office" << 0.95;
    QTest::newRow("hall") << "hall" << 0.97;
    QTest::newRow("curved") << "curved" << 0.97;
    QTest::newRow("twelve") << "twelve" << 0.97;
    QTest::newRow("clutter") << "clutter" << 0.95;
}

void PreciseRoomsTest::planesOfSimulatedRoomsAreFound()
{
    QFETCH(const QString, scene);
    QFETCH(const double, share);
    double correct = 0.0;
    double groups = 0.0;
    double regions = 0.0;

    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const SimulatedRoom room = scanOf(scene.toStdString(), "default", seed);
        const LabelComparison compared =
            comparedWithTruth(room, *extracted(room.scan.recording, precise()), 200, precise());
        correct += static_cast<double>(compared.correct.size());
        groups += static_cast<double>(compared.groups);
        regions += static_cast<double>(compared.regions);
    }

    QVERIFY2(correct >= share * groups, qPrintable(QString("%1 of %2").arg(correct).arg(groups)));
    QVERIFY2(correct >= share * regions, qPrintable(QString("%1 of %2").arg(correct).arg(regions)));
}

void PreciseRoomsTest::noiseFreeWallsAreExact()
{
    const SimulatedRoom room = scanOf("twelve", "none", 1);

    const auto found = extracted(room.scan.recording, precise());

    QVERIFY(found->planes.size() >= room.scene.planes.size());
    for (const TruePlane& truth : room.scene.planes) {
        const Plane& plane = nearestTo(truth, *found);
        const double side = sideOf(plane, truth);
        // Points are kept as floats: 24 bits of up to 20 m are micrometres.
        QVERIFY2((side * plane.normal - truth.normal).norm() < 1e-5, truth.name.c_str());
        QVERIFY2(std::abs(side * plane.distance - truth.distance) < 1e-5, truth.name.c_str());
    }
}

void PreciseRoomsTest::covariancesAreHonest()
{
    std::vector<double> squares;

    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const SimulatedRoom room = scanOf("twelve", "default", seed);
        const auto found = extracted(room.scan.recording, precise());
        for (const TruePlane& truth : room.scene.planes) {
            const Plane& plane = nearestTo(truth, *found);
            const double side = sideOf(plane, truth);
            Eigen::Vector3d error;
            error.head<2>() = plane.tangents.transpose() * (plane.normal - side * truth.normal);
            error[2] = plane.distance - side * truth.distance;
            squares.push_back(error.dot(plane.covariance.inverse() * error));
        }
    }

    // The median of χ² of 3 degrees of freedom is 2.366; within a factor of 1.5.
    std::sort(squares.begin(), squares.end());
    const double median = squares[squares.size() / 2];
    QVERIFY2(median > 2.366 / 1.5 && median < 2.366 * 1.5, qPrintable(QString::number(median)));
}

void PreciseRoomsTest::theScaleOfASceneChangesNothing_data()
{
    QTest::addColumn<double>("scale");
    QTest::newRow("a cupboard") << 0.1;
    QTest::newRow("a large hall") << 10.0;
}

/// Rooms, scanner and noise are all so many times as large; nothing is set for that.
void PreciseRoomsTest::theScaleOfASceneChangesNothing()
{
    QFETCH(double, scale);
    RoomTotals found;

    for (const std::string_view scene : {"corridor", "office", "hall"}) {
        SimulatedRoom room = scanOf(scene, "default", 3);
        for (TruePlane& plane : room.scene.planes)
            plane.distance *= scale;
        ScanDescription& description = room.scan.recording.description;
        description.rangeMin *= scale;
        description.rangeMax *= scale;
        description.pitchAxisOffset *= scale;
        for (ScanSlice& slice : room.scan.recording.slices) {
            for (double& range : slice.ranges)
                range *= scale;
        }
        found += comparedWithTruth(room, *extracted(room.scan.recording, precise()), 200, precise());
    }

    QVERIFY2(static_cast<double>(found.correct) >= 0.95 * static_cast<double>(found.truePlanes),
             qPrintable(QString("%1 of %2 planes found").arg(found.correct).arg(found.truePlanes)));
    QVERIFY2(static_cast<double>(found.correct) >= 0.95 * static_cast<double>(found.foundPlanes),
             qPrintable(QString("%1 of %2 found planes are true").arg(found.correct).arg(found.foundPlanes)));
}

/// Lengths that a fine scan has made smaller are whole again when its noise is taken from what is told.
void PreciseRoomsTest::noiseThatIsNotEstimatedIsAsToldAgain()
{
    SimulationNoise noise = *simulationNoise("default");
    noise.rangeConstant = 0.0005;
    noise.rangeProportional = 0.0;
    const SimulatedScan scan = simulate(*makeScene("office", 1), *acquisitionSettings("table8"), noise, 1);
    PlaneExtractor extractor(sensorOf(scan.recording.description), precise());
    for (int step = 0; step < 20; ++step)
        extractor.step(scan.recording.slices[static_cast<std::size_t>(step)]);
    QVERIFY(extractor.step(scan.recording.slices[20])->noise.fineness < 1.0);
    Parameters told = precise();
    told.noise.estimated = false;

    extractor.setParameters(told);
    const SensorNoise after = extractor.step(scan.recording.slices[21])->noise;

    QVERIFY(!after.estimated);
    QCOMPARE(after.fineness, 1.0);
}

void PreciseRoomsTest::theNoiseOfTheScannerIsFound_data()
{
    QTest::addColumn<double>("rangeSigma");
    QTest::addColumn<double>("pitchSigma");
    QTest::newRow("as told") << 0.008 << 0.084;
    QTest::newRow("worse") << 0.015 << 0.15;
    QTest::newRow("better") << 0.005 << 0.05;
}

void PreciseRoomsTest::theNoiseOfTheScannerIsFound()
{
    QFETCH(double, rangeSigma);
    QFETCH(double, pitchSigma);
    const Scene scene = *makeScene("hall", 2);
    SimulationNoise noise = *simulationNoise("default");
    noise.rangeConstant = rangeSigma;
    noise.pitch = degrees(pitchSigma);
    const SimulatedScan scan = simulate(scene, *acquisitionSettings("table8"), noise, 2);

    const SensorNoise found = extracted(scan.recording, precise())->noise;

    QVERIFY(found.estimated);
    for (const double range : {2.0, 6.0, 12.0}) {
        const double sigma = std::hypot(found.rangeConstant, found.rangeProportional * range);
        QVERIFY2(std::abs(sigma / noise.rangeSigma(range) - 1.0) < 0.2, qPrintable(QString::number(sigma)));
    }
    QVERIFY2(std::abs(found.pitch / noise.pitch - 1.0) < 0.25, qPrintable(QString::number(toDegrees(found.pitch))));
}

void PreciseRoomsTest::explanationsChangeNothing()
{
    const SimulatedRoom room = scanOf("office", "default", 3);

    const auto plain = extracted(room.scan.recording, precise());
    const auto explained = extracted(room.scan.recording, precise(), {{}, true});

    QCOMPARE(explained->planes.size(), plain->planes.size());
    for (std::size_t i = 0; i < plain->planes.size(); ++i) {
        QVERIFY(explained->planes[i]->normal == plain->planes[i]->normal);
        QVERIFY(explained->planes[i]->distance == plain->planes[i]->distance);
        QVERIFY(explained->planes[i]->segments == plain->planes[i]->segments);
    }
}

void PreciseRoomsTest::everyDecisionHasItsNumbers()
{
    const SimulatedRoom room = scanOf("office", "default", 1);
    PlaneExtractor extractor(sensorOf(room.scan.recording.description), precise(), {{}, true});
    std::map<DecisionKind, int> counts;
    const auto look = [&](const StepReport& report) {
        for (const Decision& decision : report.decisions) {
            ++counts[decision.kind];
            const bool done = decision.kind == DecisionKind::Assign || decision.kind == DecisionKind::Fit ||
                              decision.kind == DecisionKind::Merge;
            for (const Test& test : decision.tests)
                QVERIFY(std::isfinite(test.value) && (!done || test.pass()));
            QVERIFY(!decision.operands.empty());
        }
    };

    for (const ScanSlice& slice : room.scan.recording.slices)
        look(extractor.advance(slice));
    look(extractor.conclude());

    for (const DecisionKind kind : {DecisionKind::Assign, DecisionKind::Reject, DecisionKind::Cluster,
                                    DecisionKind::Fit, DecisionKind::NoFit, DecisionKind::Merge, DecisionKind::Near})
        QVERIFY2(counts[kind] > 0, name(kind).data());
}

void PreciseRoomsTest::snapshotsInBetweenChangeNothing()
{
    const SimulatedRoom room = scanOf("hall", "default", 2);
    PlaneExtractor extractor(sensorOf(room.scan.recording.description), precise());
    for (const ScanSlice& slice : room.scan.recording.slices)
        extractor.advance(slice);

    const auto without = extractor.finish();
    const auto with = extracted(room.scan.recording, precise());

    QCOMPARE(without->planes.size(), with->planes.size());
    QCOMPARE(without->segments.segmentCount(), with->segments.segmentCount());
    for (std::size_t i = 0; i < with->planes.size(); ++i)
        QVERIFY(without->planes[i]->normal == with->planes[i]->normal);
}

void PreciseRoomsTest::aSliceAtATimeIsTheWholeScan()
{
    const SimulatedRoom room = scanOf("corridor", "default", 1);
    PlaneExtractor extractor(sensorOf(room.scan.recording.description), precise());
    std::shared_ptr<const Snapshot> before;
    std::size_t segments = 0;

    for (const ScanSlice& slice : room.scan.recording.slices) {
        const auto snapshot = extractor.step(slice);
        segments += static_cast<std::size_t>(snapshot->report.counts.segments);
        QCOMPARE(snapshot->segments.segmentCount(), segments);
        QCOMPARE(static_cast<std::size_t>(snapshot->report.counts.fitted + snapshot->report.counts.unfitted), segments);
        if (before) {
            // Planes that did not change are shared with the snapshot before.
            for (const auto& plane : snapshot->planes) {
                for (const auto& old : before->planes)
                    QVERIFY(old->id != plane->id || old->revision != plane->revision || old == plane);
            }
        }
        before = snapshot;
    }
    QVERIFY(extractor.finish()->planes.size() > 4);
}

void PreciseRoomsTest::emptyAndHostileRoomsAreSurvived()
{
    QVERIFY(extracted(scanOf("empty", "default", 1).scan.recording, precise())->planes.empty());
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const auto found = extracted(scanOf("hostile", "default", seed).scan.recording, precise());
        for (const auto& plane : found->planes) {
            QVERIFY(plane->normal.allFinite() && plane->covariance.allFinite());
            QVERIFY(std::abs(plane->normal.norm() - 1.0) < 1e-9);
            QVERIFY(plane->distance >= 0.0 && std::isfinite(plane->rms) && std::isfinite(plane->fittingError));
        }
    }
    PlaneExtractor nothing({}, precise());
    QVERIFY(nothing.finish()->planes.empty());
}

void PreciseRoomsTest::changedParametersTakeEffect()
{
    const SimulatedRoom room = scanOf("office", "default", 1);
    Parameters large = precise();
    QVERIFY(setParameter(large, "likelihood.min-solid-angle", "0.5"));
    QVERIFY(setParameter(large, "likelihood.enough-points", "1000000"));
    PlaneExtractor extractor(sensorOf(room.scan.recording.description), precise());

    for (const ScanSlice& slice : room.scan.recording.slices)
        extractor.advance(slice);
    extractor.setParameters(large);

    QVERIFY(extractor.finish()->planes.size() < extracted(room.scan.recording, precise())->planes.size() / 2);
}

PLANEWRIGHT_TEST(PreciseRoomsTest)
#include "precise_rooms_test.moc"
