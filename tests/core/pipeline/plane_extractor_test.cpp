// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <set>

#include <QTest>

#include "simulated_room.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

bool samePlanes(const Snapshot& a, const Snapshot& b)
{
    if (a.planes.size() != b.planes.size())
        return false;
    for (std::size_t i = 0; i < a.planes.size(); ++i) {
        const Plane& p = *a.planes[i];
        const Plane& q = *b.planes[i];
        if (p.id != q.id || p.normal != q.normal || p.distance != q.distance || p.segments != q.segments ||
            p.fittingError != q.fittingError || p.covariance != q.covariance)
            return false;
    }
    return true;
}

/// A slice that sees a wall of 4 m width straight ahead at a distance, at a tilt [rad].
ScanSlice wallSlice(int step, double tilt, double ahead)
{
    ScanSlice slice;
    slice.step = step;
    slice.tilt = tilt;
    slice.bearingStep = degrees(0.5);
    for (int beam = 0; beam <= 360; ++beam) {
        const double bearing = degrees(0.5 * beam);
        const double range = ahead / (std::sin(bearing) * std::sin(tilt));
        slice.ranges.push_back(std::abs(range * std::cos(bearing)) < 2.0 ? range : 0.0);
    }
    return slice;
}

}  // namespace

class PlaneExtractorTest : public QObject {
    Q_OBJECT

private slots:
    void aScanFedSliceBySliceEqualsTheScanFedAtOnce();
    void theStateAfterAStepDoesNotDependOnWhatFollows();
    void explainingChangesNoPlane();
    void everySegmentIsFittedOrNot();
    void phasesRunAsTableISays();
    void aGapInTheStepsIsCountedByTheSchedule();
    void theLastPassWorksOffWhatTheScheduleLeft();
    void timesComeFromTheCallersClock();
    void unchangedPlanesAreSharedBetweenSnapshots();
    void parametersChangeBetweenSteps();
    void slicesWithoutReturnsAreFine();
    void oneSliceGivesSegmentsAndNoPlane();
    void oneBeamGivesNothing();
    void manyBeamsAreWorkedOff();
    void rangesThatAreNoNumbersAreNoReturns();
};

void PlaneExtractorTest::aScanFedSliceBySliceEqualsTheScanFedAtOnce()
{
    const SimulatedRoom room = scanOf("office", "default", 2);
    const auto settings = *acquisitionSettings("table8");
    const auto noise = *simulationNoise("default");

    // Once from the whole scan in memory, once with every slice made only when its turn comes.
    const auto atOnce = extracted(room.scan.recording);
    PlaneExtractor online(sensorOf(room.scan.recording.description), {});
    for (int step = 0; step < settings.slices; ++step)
        online.step(simulateSlice(room.scene, settings, noise, 2, step).slice);
    const auto sliceBySlice = online.finish();

    QVERIFY(!atOnce->planes.empty());
    QVERIFY(samePlanes(*atOnce, *sliceBySlice));
}

void PlaneExtractorTest::theStateAfterAStepDoesNotDependOnWhatFollows()
{
    const SimulatedRoom room = scanOf("corridor", "default", 3);
    const auto& recording = room.scan.recording;
    PlaneExtractor whole(sensorOf(recording.description), {});
    PlaneExtractor half(sensorOf(recording.description), {});

    std::shared_ptr<const Snapshot> atStep69;
    for (const ScanSlice& slice : recording.slices) {
        const auto snapshot = whole.step(slice);
        if (slice.step == 69)
            atStep69 = snapshot;
    }
    std::shared_ptr<const Snapshot> last;
    for (int step = 0; step <= 69; ++step)
        last = half.step(recording.slices[static_cast<std::size_t>(step)]);

    // The snapshot was kept while 67 more slices were worked in: it is still that of step 69.
    QVERIFY(!last->planes.empty());
    QVERIFY(samePlanes(*atStep69, *last));
    QCOMPARE(atStep69->segments.slices(), std::size_t(70));
}

void PlaneExtractorTest::explainingChangesNoPlane()
{
    const SimulatedRoom room = scanOf("hall", "default", 2);

    const auto silent = extracted(room.scan.recording);
    const auto explained = extracted(room.scan.recording, {}, {{}, true});

    QVERIFY(samePlanes(*silent, *explained));
    QVERIFY(silent->report.decisions.empty());
}

void PlaneExtractorTest::everySegmentIsFittedOrNot()
{
    const SimulatedRoom room = scanOf("office", "default", 4);
    PlaneExtractor extractor(sensorOf(room.scan.recording.description), {});

    const auto check = [](const Snapshot& snapshot) {
        std::set<SegmentId> seen;
        int fitted = 0;
        for (const auto& plane : snapshot.planes) {
            fitted += static_cast<int>(plane->segments.size());
            seen.insert(plane->segments.begin(), plane->segments.end());
        }
        int unfitted = 0;
        for (const auto& cluster : snapshot.clusters) {
            unfitted += static_cast<int>(cluster->segments.size());
            seen.insert(cluster->segments.begin(), cluster->segments.end());
        }
        QCOMPARE(snapshot.report.counts.fitted, fitted);
        QCOMPARE(snapshot.report.counts.unfitted, unfitted);
        QCOMPARE(seen.size(), snapshot.segments.segmentCount());
        QCOMPARE(static_cast<std::size_t>(fitted + unfitted), snapshot.segments.segmentCount());
    };

    for (const ScanSlice& slice : room.scan.recording.slices) {
        const auto snapshot = extractor.step(slice);
        check(*snapshot);
        const StepCounts& counts = snapshot->report.counts;
        QCOMPARE(counts.assigned + counts.clustered, counts.segments);
        QCOMPARE(counts.returns, static_cast<int>(std::count_if(slice.ranges.begin(), slice.ranges.end(),
                                                                [](double r) { return r >= 0.1 && r <= 30.0; })));
    }
    check(*extractor.finish());
}

void PlaneExtractorTest::phasesRunAsTableISays()
{
    const SimulatedRoom room = scanOf("corridor", "default", 1);
    // A clock that moves on by a second at every look: a phase that ran took at least one.
    int seconds = 0;
    const StepClock clock = [&] { return std::chrono::seconds(++seconds); };
    PlaneExtractor extractor(sensorOf(room.scan.recording.description), {}, {clock, false});

    for (const ScanSlice& slice : room.scan.recording.slices) {
        const StepReport report = extractor.step(slice)->report;
        const auto ran = [&](Phase phase) { return report.times[static_cast<std::size_t>(phase)].count() > 0; };
        QVERIFY(ran(Phase::Extract) && ran(Phase::Assign) && ran(Phase::Cluster));
        QCOMPARE(ran(Phase::Fit), (slice.step + 1) % 5 == 0);
        QCOMPARE(ran(Phase::SplitMerge), (slice.step + 1) % 7 == 0);
        QCOMPARE(ran(Phase::Remaining), (slice.step + 1) % 5 == 0);
        QVERIFY(!ran(Phase::Finish));
    }
    const StepReport last = extractor.finish()->report;
    QCOMPARE(last.step, -1);
    QVERIFY(last.times[static_cast<std::size_t>(Phase::Finish)].count() > 0);
}

void PlaneExtractorTest::aGapInTheStepsIsCountedByTheSchedule()
{
    PlaneExtractor extractor({}, {});

    // Steps 0 to 3 and 6 to 9: the fit of step 4 is missed, that of step 9 is not.
    std::size_t planesAt8 = 0;
    std::size_t planesAt9 = 0;
    for (const int step : {0, 1, 2, 3, 6, 7, 8, 9}) {
        const auto snapshot = extractor.step(wallSlice(step, degrees(80.0 + 1.16 * step), 3.0));
        (step < 9 ? planesAt8 : planesAt9) = snapshot->planes.size();
    }

    QCOMPARE(planesAt8, std::size_t(0));
    QCOMPARE(planesAt9, std::size_t(1));
}

void PlaneExtractorTest::theLastPassWorksOffWhatTheScheduleLeft()
{
    Parameters parameters;
    parameters.schedule = {1000, 1000, 1000};
    PlaneExtractor extractor({}, parameters);
    for (int step = 0; step < 12; ++step)
        QVERIFY(extractor.step(wallSlice(step, degrees(80.0 + 1.16 * step), 3.0))->planes.empty());

    const auto found = extractor.finish();

    QCOMPARE(found->planes.size(), std::size_t(1));
    QCOMPARE(found->planes[0]->segments.size(), std::size_t(12));
    QCOMPARE(found->report.counts.unfitted, 0);
}

void PlaneExtractorTest::timesComeFromTheCallersClock()
{
    // Two looks at the clock for each of extract, assign and cluster, 1 ms apart.
    std::chrono::milliseconds now{0};
    const StepClock clock = [&] { return now += std::chrono::milliseconds(1); };
    PlaneExtractor extractor({}, {}, {clock, false});

    const auto timed = extractor.step(wallSlice(0, degrees(80.0), 3.0));
    PlaneExtractor blind({}, {});
    const auto untimed = blind.step(wallSlice(0, degrees(80.0), 3.0));

    for (const Phase phase : {Phase::Extract, Phase::Assign, Phase::Cluster}) {
        QCOMPARE(timed->report.times[static_cast<std::size_t>(phase)].count(), 1'000'000);
        QCOMPARE(untimed->report.times[static_cast<std::size_t>(phase)].count(), 0);
    }
}

void PlaneExtractorTest::unchangedPlanesAreSharedBetweenSnapshots()
{
    PlaneExtractor extractor({}, {});
    for (int step = 0; step < 10; ++step)
        extractor.step(wallSlice(step, degrees(80.0 + 1.16 * step), 3.0));

    ScanSlice openSky = wallSlice(10, degrees(95.0), 3.0);
    std::fill(openSky.ranges.begin(), openSky.ranges.end(), 0.0);
    const auto before = extractor.step(openSky);
    openSky.step = 11;
    const auto after = extractor.step(openSky);

    QCOMPARE(before->planes.size(), std::size_t(1));
    QCOMPARE(before->planes[0].get(), after->planes[0].get());
}

void PlaneExtractorTest::parametersChangeBetweenSteps()
{
    PlaneExtractor extractor({}, {});
    Parameters strict;
    strict.segments.minLength = 9.0;

    const auto before = extractor.step(wallSlice(0, degrees(80.0), 3.0));
    extractor.setParameters(strict);
    const auto after = extractor.step(wallSlice(1, degrees(81.0), 3.0));

    QCOMPARE(before->report.counts.segments, 1);
    QCOMPARE(after->report.counts.segments, 0);
}

void PlaneExtractorTest::slicesWithoutReturnsAreFine()
{
    PlaneExtractor extractor({}, {});
    for (int step = 0; step < 20; ++step) {
        ScanSlice slice;
        slice.step = step;
        slice.bearingStep = degrees(1.0);
        slice.ranges.assign(step % 2 == 0 ? 181 : 0, 0.0);
        extractor.step(slice);
    }

    QVERIFY(extractor.finish()->planes.empty());
}

void PlaneExtractorTest::oneSliceGivesSegmentsAndNoPlane()
{
    PlaneExtractor extractor({}, {});
    extractor.step(wallSlice(0, degrees(80.0), 3.0));

    const auto found = extractor.finish();

    QVERIFY(found->planes.empty());
    QCOMPARE(found->report.counts.unfitted, 1);
}

void PlaneExtractorTest::oneBeamGivesNothing()
{
    PlaneExtractor extractor({}, {});
    for (int step = 0; step < 30; ++step) {
        ScanSlice slice;
        slice.step = step;
        slice.tilt = degrees(60.0 + step);
        slice.ranges = {2.0};
        extractor.step(slice);
    }

    const auto found = extractor.finish();

    QVERIFY(found->planes.empty());
    QCOMPARE(found->segments.segmentCount(), std::size_t(0));
}

void PlaneExtractorTest::manyBeamsAreWorkedOff()
{
    ScanSlice slice;
    slice.bearingStep = degrees(180.0 / 65535.0);
    for (int beam = 0; beam < 65536; ++beam)
        slice.ranges.push_back(3.0 + (beam % 2 == 0 ? 0.2 : -0.2));
    PlaneExtractor extractor({}, {});

    const auto snapshot = extractor.step(slice);

    QCOMPARE(snapshot->report.counts.returns, 65536);
}

void PlaneExtractorTest::rangesThatAreNoNumbersAreNoReturns()
{
    ScanSlice slice = wallSlice(0, degrees(80.0), 3.0);
    const int wall = static_cast<int>(
        std::count_if(slice.ranges.begin(), slice.ranges.end(), [](double range) { return range > 0.0; }));
    slice.ranges[0] = std::numeric_limits<double>::quiet_NaN();
    slice.ranges[1] = std::numeric_limits<double>::infinity();
    slice.ranges[2] = -1.0;
    PlaneExtractor extractor({}, {});

    const auto snapshot = extractor.step(slice);

    QCOMPARE(snapshot->report.counts.returns, wall);
}

PLANEWRIGHT_TEST(PlaneExtractorTest)
#include "plane_extractor_test.moc"
