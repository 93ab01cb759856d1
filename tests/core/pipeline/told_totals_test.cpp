// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <optional>

#include "tests/core/pipeline/likelihood_twin.h"
#include "tests/core/pipeline/neighbour_slices.h"
#include "tests/core/pipeline/new_plane_twin.h"
#include "tests/core/pipeline/raw_slice.h"
#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Eq. (6) at one tilt: where a point of a slice is in space.
Eigen::Vector3d inSpace(const Eigen::Vector2d& point, double tilt, double offset)
{
    const double ahead = point.y();
    return {point.x(), ahead * std::sin(tilt) + offset * std::cos(tilt),
            -ahead * std::cos(tilt) + offset * std::sin(tilt)};
}

/// Σ of squared distances of a plane's echoes from it, and how many they are.
std::pair<double, double> squaresOf(const Plane& plane, const ToldScan& scan, const SensorModel& sensor,
                                    const SegmentLog& log)
{
    double sum = 0.0;
    double count = 0.0;
    for (const SegmentId& id : plane.segments) {
        const ScanSlice& slice = scan.sliceOf(id.step);
        for (const Eigen::Vector2d& point : pointsOf(slice, sensor, log[id].firstBeam, log[id].lastBeam)) {
            const Eigen::Vector3d p = inSpace(point, slice.tiltAt(slice.ranges.size() / 2), sensor.pitchAxisOffset);
            sum += std::pow(plane.normal.dot(p) - plane.distance, 2);
            count += 1.0;
        }
    }
    return {sum, count};
}

/// How often planes were split in a step: one that loses segments one by one is once in a pass.
int splitsOf(const std::vector<const ToldPhase*>& phases)
{
    int splits = 0;
    for (const ToldPhase* phase : phases) {
        std::set<PlaneId> planes;
        for (const Decision& decision : phase->decisions()) {
            if (decision.kind == DecisionKind::Split)
                planes.insert(planeOf(decision.operands[0]));
        }
        splits += static_cast<int>(planes.size());
    }
    return splits;
}

int decisionsOf(const std::vector<const ToldPhase*>& phases, DecisionKind kind, std::optional<Phase> of = std::nullopt)
{
    int count = 0;
    for (const ToldPhase* phase : phases) {
        for (const Decision& decision : phase->decisions())
            count += decision.kind == kind && (!of || phase->phase == *of) ? 1 : 0;
    }
    return count;
}

}  // namespace

/// Totals of a step and the numbers of its planes, counted in decisions, snapshots and raw ranges.
class ToldTotalsTest : public QObject {
    Q_OBJECT

private slots:
    void stepsCountWhatTheyDid_data() { scans(); }
    void stepsCountWhatTheyDid();
    void planesStrayFromTheirEchoesAsTold_data() { scans(); }
    void planesStrayFromTheirEchoesAsTold();
    void planesErrAsTold_data() { scans(); }
    void planesErrAsTold();

private:
    static void scans()
    {
        QTest::addColumn<QString>("preset");
        QTest::addColumn<QString>("scene");
        for (const char* preset : {"paper", "precise"}) {
            for (const char* scene : {"corridor", "office", "stairs", "clutter", "curved"})
                QTest::addRow("%s, %s", preset, scene) << preset << scene;
        }
    }
};

void ToldTotalsTest::stepsCountWhatTheyDid()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const ToldScan scan(preset.toStdString(), scene.toStdString(), 3);
    const SensorModel sensor = sensorOf(scan.recording.description);
    Recomputed recomputed;
    std::map<int, std::vector<const ToldPhase*>> steps;
    for (const ToldPhase& phase : scan.phases)
        steps[phase.step].push_back(&phase);
    for (const auto& [step, phases] : steps) {
        const ToldPhase& last = *phases.back();
        const Snapshot& now = *last.after;
        const StepCounts& told = now.report.counts;
        int fitted = 0;
        double error = 0.0;
        for (const auto& plane : now.planes) {
            fitted += static_cast<int>(plane->segments.size());
            error += plane->fittingError / static_cast<double>(now.planes.size());
        }
        const int all = static_cast<int>(now.segments.segmentCount());
        QVERIFY(recomputed.agree(last, "fitted", told.fitted, fitted));
        QVERIFY(recomputed.agree(last, "unfitted", told.unfitted, all - fitted));
        QVERIFY(recomputed.agree(last, "clusters", told.clusters, static_cast<double>(now.clusters.size())));
        QVERIFY(recomputed.agree(last, "planes", told.planes, static_cast<double>(now.planes.size())));
        QVERIFY(recomputed.agree(last, "mean error", told.meanError, error, 1e-6));
        QVERIFY(recomputed.agree(last, "merges", told.merges, decisionsOf(phases, DecisionKind::Merge)));
        QVERIFY(recomputed.agree(last, "splits", told.splits, splitsOf(phases)));
        if (step == kLastPass)
            continue;
        const ScanSlice& slice = scan.sliceOf(step);
        const int beams = static_cast<int>(slice.ranges.size());
        QVERIFY(recomputed.agree(last, "returns", told.returns, echoesIn(slice, sensor, 0, beams - 1)));
        QVERIFY(recomputed.agree(last, "segments", told.segments,
                                 static_cast<double>(now.segments.slice(now.segments.find(step)).size())));
        QVERIFY(recomputed.agree(last, "assigned", told.assigned,
                                 decisionsOf(phases, DecisionKind::Assign, Phase::Assign)));
        QVERIFY(recomputed.agree(last, "clustered", told.clustered,
                                 decisionsOf(phases, DecisionKind::Reject, Phase::Assign)));
    }
    QVERIFY(recomputed.counts["assigned"] > 100);
}

void ToldTotalsTest::planesStrayFromTheirEchoesAsTold()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const ToldScan scan(preset.toStdString(), scene.toStdString(), 3);
    const SensorModel sensor = sensorOf(scan.recording.description);
    const bool isPrecise = preset == "precise";
    Recomputed recomputed;
    int closely = 0;
    for (const ToldPhase& phase : scan.phases) {
        if (phase.step % 10 != 9 && phase.step != kLastPass)
            continue;
        for (const auto& plane : phase.after->planes) {
            const auto [sum, count] = squaresOf(*plane, scan, sensor, phase.after->segments);
            // Points far off their line may have been left out.
            if (isPrecise && count > plane->points)
                continue;
            QVERIFY(recomputed.agree(phase, "points", plane->points, count));
            // Of a segment it keeps the mean by weights, which is beside that of its points where these are far apart.
            QVERIFY(recomputed.agree(phase, "rms", plane->rms, std::sqrt(sum / count), isPrecise ? 0.2 : 1e-3));
            closely += std::abs(plane->rms - std::sqrt(sum / count)) < 0.01 * plane->rms ? 1 : 0;
        }
    }
    QVERIFY2(recomputed.counts["rms"] > 100 && 10 * closely > 7 * recomputed.counts["rms"],
             qPrintable(QString("%1 of %2").arg(closely).arg(recomputed.counts["rms"])));
}

void ToldTotalsTest::planesErrAsTold()
{
    QFETCH(QString, preset);
    QFETCH(QString, scene);
    const ToldScan scan(preset.toStdString(), scene.toStdString(), 3);
    Recomputed recomputed;
    const ToldPhase& phase = scan.phases.back();
    for (const auto& plane : phase.after->planes) {
        if (preset == "paper") {
            const Shape shape(*plane, *phase.after, scan.parameters.planes);
            QVERIFY(recomputed.agree(phase, "E", plane->fittingError, shape.error, 1e-3));
            continue;
        }
        const PlaneSegments segments = segmentsOf(plane->segments, phase.after->segments);
        if (segments.size() > 80 || !allDirected(segments, phase.after->noise))
            continue;
        const LikeliestPlane likeliest(segments, phase.after->noise.pitch, scan.parameters.noise.systematic);
        // The last fit leaves the segments out that do not fit: their share is in no snapshot.
        const bool isOfAll = std::abs(plane->fittingError - likeliest.meanError()) < 0.01 * likeliest.meanError();
        QVERIFY(isOfAll || plane->fittingError < likeliest.meanError());
        recomputed.counts[isOfAll ? "E" : "E of some"] += 1;
    }
    QVERIFY2(recomputed.counts["E"] >= 3 && recomputed.counts["E"] > recomputed.counts["E of some"],
             qPrintable(QString("%1, %2").arg(recomputed.counts["E"]).arg(recomputed.counts["E of some"])));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldTotalsTest)
#include "told_totals_test.moc"
