// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include <QtTest>

#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"
#include "core/simulation/scenes.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

std::shared_ptr<const Snapshot> snapshotOf(const Recording& recording, const QString& preset)
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset.toStdString()), parameters);
    PlaneExtractor extractor(sensorOf(recording.description), parameters);
    for (const ScanSlice& slice : recording.slices)
        extractor.advance(slice);
    return extractor.finish();
}

/// A corridor with noise, as a coarse scanner sees it.
Recording scannedCorridor()
{
    AcquisitionSettings settings;
    settings.tiltStep = degrees(4.0);
    settings.slices = 40;
    settings.bearingStep = degrees(1.0);
    settings.beams = 181;
    return simulate(makeCorridor(3), settings, *simulationNoise("default"), 3).recording;
}

void bothPresets()
{
    QTest::addColumn<QString>("preset");
    QTest::newRow("paper") << "paper";
    QTest::newRow("precise") << "precise";
}

}  // namespace

/// A scanner whose pitch axis or whose beams are told in another way finds the same planes.
class TurnedRecordingTest : public QObject {
    Q_OBJECT

private slots:
    void planesAndSegmentsTurnWithTheFrame_data() { bothPresets(); }
    void planesAndSegmentsTurnWithTheFrame();
    void aTableOfEvenBearingsIsTheSameAsEvenSpacing_data() { bothPresets(); }
    void aTableOfEvenBearingsIsTheSameAsEvenSpacing();
};

void TurnedRecordingTest::planesAndSegmentsTurnWithTheFrame()
{
    QFETCH(QString, preset);
    const Recording level = scannedCorridor();
    Recording turned = level;
    // x becomes y, y becomes z, z becomes x.
    turned.description.attitude = Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5);
    const Eigen::Matrix3d turn = turned.description.attitude.toRotationMatrix();

    const auto before = snapshotOf(level, preset);
    const auto after = snapshotOf(turned, preset);

    QVERIFY(!before->planes.empty());
    QCOMPARE(after->planes.size(), before->planes.size());
    for (std::size_t i = 0; i < before->planes.size(); ++i) {
        const Plane& a = *before->planes[i];
        const Plane& b = *after->planes[i];
        QCOMPARE(b.id, a.id);
        QVERIFY(b.segments == a.segments);
        QVERIFY((b.normal - turn * a.normal).norm() < 1e-6);
        QVERIFY(std::abs(b.distance - a.distance) < 1e-6);
    }
    QCOMPARE(after->segments.slices(), before->segments.slices());
    for (std::size_t place = 0; place < before->segments.slices(); ++place) {
        const Segments& a = before->segments.slice(place);
        const Segments& b = after->segments.slice(place);
        QCOMPARE(b.size(), a.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            QVERIFY((b[k].start - turn * a[k].start).norm() < 1e-9);
            QVERIFY((b[k].end - turn * a[k].end).norm() < 1e-9);
            QVERIFY((b[k].direction - turn * a[k].direction).norm() < 1e-9);
            QVERIFY((b[k].viewpoint - turn * a[k].viewpoint).norm() < 1e-9);
            QVERIFY((b[k].startCovariance - turn * a[k].startCovariance * turn.transpose()).norm() < 1e-12);
            QVERIFY((b[k].moments.mean - turn * a[k].moments.mean).norm() < 1e-9);
            QVERIFY((b[k].moments.scatter - turn * a[k].moments.scatter * turn.transpose()).norm() < 1e-6);
        }
    }
}

void TurnedRecordingTest::aTableOfEvenBearingsIsTheSameAsEvenSpacing()
{
    QFETCH(QString, preset);
    const Recording even = scannedCorridor();
    Recording listed = even;
    auto table = std::make_shared<BeamTable>();
    for (std::size_t beam = 0; beam < even.slices.front().ranges.size(); ++beam)
        table->bearings.push_back(even.slices.front().bearing(beam));
    listed.description.beamTable = table;
    for (ScanSlice& slice : listed.slices)
        layBeams(slice, listed.description);

    const auto before = snapshotOf(even, preset);
    const auto after = snapshotOf(listed, preset);

    QVERIFY(!before->planes.empty());
    QCOMPARE(after->planes.size(), before->planes.size());
    for (std::size_t i = 0; i < before->planes.size(); ++i) {
        QVERIFY(after->planes[i]->normal == before->planes[i]->normal);
        QVERIFY(after->planes[i]->distance == before->planes[i]->distance);
        QVERIFY(after->planes[i]->segments == before->planes[i]->segments);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TurnedRecordingTest)
#include "turned_recording_test.moc"
