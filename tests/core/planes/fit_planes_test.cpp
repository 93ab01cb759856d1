// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/fit_planes.h"

#include <QtTest>

#include "tests/core/planes/seen_segments.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A map whose clusters hold these segments, of which no plane knows.
struct Clustered {
    Parameters parameters = lenient();
    PlaneMap map;
    Recorded recorded;

    explicit Clustered(const Segments& segments) { add(segments); }

    std::vector<SegmentNumber> add(const Segments& segments)
    {
        auto numbers = append(map.segments, segments);
        cluster(numbers, map, parameters);
        return numbers;
    }
    void fit(bool everySegment = false) { fitPlanes(map, parameters, recorded.recorder, everySegment); }
};

Segments upright(const Eigen::Vector3d& foot, int rows)
{
    return Sheet{foot, {0.0, 0.0, 1.0}, {0.1, 0.0, 0.0}, rows, 0}.segments();
}

}  // namespace

class FitPlanesTest : public QObject {
    Q_OBJECT

private slots:
    void twoParallelWallsInOneClusterGiveBoth();
    void segmentsOfAPlaneLeaveTheClusters();
    void clustersAreSearchedOneByOne();
    void aClusterOfFewSegmentsIsNotSearched();
    void aClusterOfFewSlicesIsNotSearched();
    void segmentsNotYetSearchedStayNewWhileTheClusterIsSmall();
    void oldFailuresAreNotTriedAgain();
    void aNewSegmentFindsTheOldOnes();
    void everySegmentIsTriedAgainWhereAsked();
    void planesAreNumberedOnAndBornNow();
    void planesFoundAreExplained();
    void failedHypothesesAreExplained();
    void nothingIsExplainedWhereNobodyAsks();
};

void FitPlanesTest::twoParallelWallsInOneClusterGiveBoth()
{
    Clustered clustered(wall(7).segments() + wall(5, 1.0).segments());
    QCOMPARE(clustered.map.clusters.all().size(), std::size_t{1});

    clustered.fit();

    QVERIFY((planeIds(clustered.map) == std::vector<PlaneId>{0, 1}));
    QVERIFY(std::abs(std::abs(clustered.map.planes[0].distance()) - 4.0) < 1e-9);
    QVERIFY(std::abs(std::abs(clustered.map.planes[1].distance()) - 5.0) < 1e-9);
    QCOMPARE(clustered.map.planes[0].members().size(), std::size_t{7});
    QCOMPARE(clustered.map.planes[1].members().size(), std::size_t{5});
}

void FitPlanesTest::segmentsOfAPlaneLeaveTheClusters()
{
    Clustered clustered(wall(6).segments());
    const auto stranger = clustered.add({segmentBetween(6, {-1.0, 3.0, 0.6}, {1.0, 3.0, 0.6})});

    clustered.fit();

    QVERIFY(clusteredSegments(clustered.map) == stranger);
    QCOMPARE(clustered.map.segments.owner(stranger[0]), kNoPlane);
    for (const SegmentNumber number : clustered.map.planes[0].members())
        QCOMPARE(clustered.map.segments.owner(number), 0);
}

void FitPlanesTest::clustersAreSearchedOneByOne()
{
    // The upright segments lie in the wall of the level ones, and are of another cluster all the same.
    Clustered clustered(wall(6).segments() + upright({-1.0, 4.0, 0.0}, 6));
    QCOMPARE(clustered.map.clusters.all().size(), std::size_t{2});

    clustered.fit();

    QCOMPARE(clustered.map.planes.size(), std::size_t{2});
    for (const GrowingPlane& plane : clustered.map.planes) {
        QCOMPARE(plane.members().size(), std::size_t{6});
        QVERIFY(std::abs(std::abs(plane.distance()) - 4.0) < 1e-9);
    }
}

void FitPlanesTest::aClusterOfFewSegmentsIsNotSearched()
{
    Clustered few(wall(5).segments());
    few.parameters.planes.minClusterSegments = 6;
    Clustered enough(wall(6).segments());
    enough.parameters.planes.minClusterSegments = 6;

    few.fit();
    enough.fit();

    QVERIFY(few.map.planes.empty());
    const auto decisions = few.recorded.decisions(DecisionKind::NoFit);
    QCOMPARE(decisions.size(), std::size_t{1});
    QCOMPARE(clusterOf(decisions[0].operands[0]), few.map.clusters.all()[0].id);
    QVERIFY(failed(decisions[0].tests) == std::vector<std::string_view>{"cluster_segments"});
    QCOMPARE(testOf(decisions[0].tests, "cluster_segments").value, 5.0);
    QCOMPARE(testOf(decisions[0].tests, "cluster_segments").limit, 6.0);
    QCOMPARE(enough.map.planes.size(), std::size_t{1});
}

void FitPlanesTest::aClusterOfFewSlicesIsNotSearched()
{
    // Six segments in three slices.
    Clustered clustered(wall(3).segments() + wall(3, 0.01).segments());
    clustered.parameters.planes.minClusterSlices = 4;

    clustered.fit();

    QVERIFY(clustered.map.planes.empty());
    const auto decisions = clustered.recorded.decisions(DecisionKind::NoFit);
    QCOMPARE(decisions.size(), std::size_t{1});
    QVERIFY(failed(decisions[0].tests) == std::vector<std::string_view>{"cluster_slices"});
    QCOMPARE(testOf(decisions[0].tests, "cluster_slices").value, 3.0);

    clustered.parameters.planes.minClusterSlices = 3;
    clustered.fit();
    QCOMPARE(clustered.map.planes.size(), std::size_t{1});
}

void FitPlanesTest::segmentsNotYetSearchedStayNewWhileTheClusterIsSmall()
{
    Clustered clustered(wall(5).segments());
    clustered.parameters.planes.minClusterSegments = 6;
    clustered.fit();
    clustered.parameters.planes.minClusterSegments = 5;

    clustered.fit();

    QCOMPARE(clustered.map.planes.size(), std::size_t{1});
}

void FitPlanesTest::oldFailuresAreNotTriedAgain()
{
    Clustered clustered(wall(5).segments());
    clustered.parameters.planes.minSegments = 6;
    clustered.fit();
    QVERIFY(clustered.map.planes.empty());
    const std::size_t explained = clustered.recorded.report.decisions.size();
    QVERIFY(explained > 0);
    clustered.parameters.planes.minSegments = 5;

    clustered.fit();

    QVERIFY(clustered.map.planes.empty());
    QCOMPARE(clustered.recorded.report.decisions.size(), explained);
}

void FitPlanesTest::aNewSegmentFindsTheOldOnes()
{
    Clustered clustered(wall(5).segments());
    clustered.parameters.planes.minSegments = 6;
    clustered.fit();
    clustered.add(wall(1, 0.0, 5).segments());

    clustered.fit();

    QCOMPARE(clustered.map.planes.size(), std::size_t{1});
    QCOMPARE(clustered.map.planes[0].members().size(), std::size_t{6});
    QVERIFY(clustered.map.clusters.all().empty());
}

void FitPlanesTest::everySegmentIsTriedAgainWhereAsked()
{
    Clustered clustered(wall(5).segments());
    clustered.parameters.planes.minSegments = 6;
    clustered.fit();
    clustered.parameters.planes.minSegments = 5;

    clustered.fit(true);

    QCOMPARE(clustered.map.planes.size(), std::size_t{1});
    QCOMPARE(clustered.map.planes[0].members().size(), std::size_t{5});
}

void FitPlanesTest::planesAreNumberedOnAndBornNow()
{
    Clustered clustered(wall(6).segments());
    clustered.map.nextPlane = 7;
    clustered.map.step = 5;

    clustered.fit();

    QVERIFY((planeIds(clustered.map) == std::vector<PlaneId>{7}));
    QCOMPARE(clustered.map.nextPlane, 8);
    const auto plane = clustered.map.planes[0].publish(clustered.map.segments);
    QCOMPARE(plane->bornStep, 5);
    QVERIFY(plane->lineage.kind == Lineage::Kind::Fitted);
    QVERIFY(plane->lineage.parents.empty());
}

void FitPlanesTest::planesFoundAreExplained()
{
    Clustered clustered(wall(7).segments() + wall(5, 1.0).segments());
    const ClusterId cluster = clustered.map.clusters.all()[0].id;

    clustered.fit();

    const auto decisions = clustered.recorded.decisions(DecisionKind::Fit);
    QCOMPARE(decisions.size(), std::size_t{2});
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(clusterOf(decisions[i].operands[0]), cluster);
        QCOMPARE(planeOf(decisions[i].result[0]), static_cast<PlaneId>(i));
        QVERIFY(allPass(decisions[i].tests));
    }
    QCOMPARE(testOf(decisions[0].tests, "segments").value, 7.0);
    QCOMPARE(testOf(decisions[1].tests, "segments").value, 5.0);
}

void FitPlanesTest::failedHypothesesAreExplained()
{
    Clustered clustered(wall(5).segments());
    clustered.parameters.planes.minPoints = 151;

    clustered.fit();

    const auto decisions = clustered.recorded.decisions(DecisionKind::NoFit);
    QCOMPARE(decisions.size(), std::size_t{1});
    QCOMPARE(clusterOf(decisions[0].operands[0]), clustered.map.clusters.all()[0].id);
    const SegmentId seed = segmentOf(decisions[0].operands[1]);
    QVERIFY(seed.step >= 0 && seed.step < 5);
    QVERIFY(failed(decisions[0].tests) == std::vector<std::string_view>{"points"});
    QCOMPARE(testOf(decisions[0].tests, "points").value, 150.0);
}

void FitPlanesTest::nothingIsExplainedWhereNobodyAsks()
{
    Clustered clustered(wall(6).segments() + wall(2, 1.0).segments());
    StepReport report;
    StepRecorder silent(report, {}, false);

    fitPlanes(clustered.map, clustered.parameters, silent);

    QCOMPARE(clustered.map.planes.size(), std::size_t{1});
    QVERIFY(report.decisions.empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::FitPlanesTest)
#include "fit_planes_test.moc"
