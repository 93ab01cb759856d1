// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "core/segments/slice_trace.h"
#include "tests/core/pipeline/simulated_room.h"
#include "tests/test_program.h"

namespace planewright {

/// What is told of a slice afterwards, beside what the extraction made of it while the noise became known.
class TracedStepsTest : public QObject {
    Q_OBJECT

private slots:
    void everyStepIsTracedAsItWasExtracted_data();
    void everyStepIsTracedAsItWasExtracted();
};

void TracedStepsTest::everyStepIsTracedAsItWasExtracted_data()
{
    QTest::addColumn<QString>("preset");
    QTest::newRow("paper") << "paper";
    QTest::newRow("precise") << "precise";
}

void TracedStepsTest::everyStepIsTracedAsItWasExtracted()
{
    QFETCH(QString, preset);
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset.toStdString()), parameters);
    const SimulatedRoom room = scanOf("office", "default", 5, "table10-1");
    const SensorModel sensor = sensorOf(room.scan.recording.description);
    PlaneExtractor extractor(sensor, parameters);
    for (const ScanSlice& slice : room.scan.recording.slices) {
        const auto snapshot = extractor.step(slice);
        const Segments& segments = snapshot->segments.slice(snapshot->segments.find(slice.step));

        const SliceTrace trace = traceSlice(slice, sensor, withNoise(parameters, snapshot->noise));

        std::size_t kept = 0;
        for (const TracedPiece& piece : trace.pieces) {
            if (piece.segment < 0)
                continue;
            QVERIFY(kept < segments.size());
            QCOMPARE(piece.segment, segments[kept].id.index);
            QCOMPARE(piece.firstBeam, segments[kept].firstBeam);
            QCOMPARE(piece.lastBeam, segments[kept].lastBeam);
            QCOMPARE(piece.points, segments[kept].points);
            ++kept;
        }
        QCOMPARE(kept, segments.size());
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TracedStepsTest)
#include "traced_steps_test.moc"
