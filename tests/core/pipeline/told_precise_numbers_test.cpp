// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <utility>

#include <Eigen/Eigenvalues>

#include "tests/core/pipeline/likelihood_twin.h"
#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Covariances are those of where a plane was linearised, some way from where a young one is: numbers are compared
/// where the plane's own makes less than this share of the variance.
constexpr double kSmallShare = 0.1;

/// A plane's points, each counted by the sine of its angle to the pitch axis.
double spreadPoints(const Plane& plane, const Snapshot& snapshot)
{
    double sum = 0.0;
    for (const SegmentId& id : plane.segments) {
        const LineSegment& s = snapshot.segments[id];
        const Eigen::Vector3d ray = s.moments.mean - s.viewpoint;
        sum += s.points * ray.tail<2>().norm() / ray.norm();
    }
    return sum;
}

double meanIncidence(const Plane& plane, const Snapshot& snapshot)
{
    double sum = 0.0;
    double points = 0.0;
    for (const SegmentId& id : plane.segments) {
        const LineSegment& s = snapshot.segments[id];
        sum += s.points * std::abs(plane.normal.dot((s.moments.mean - s.viewpoint).normalized()));
        points += s.points;
    }
    return sum / points;
}

/// How many points fill the smallest solid angle of a plane, from beam to beam and from slice to slice: a dozen at
/// least, and no more than are enough.
double pointsOfSmallest(const ToldScan& scan)
{
    const std::vector<ScanSlice>& slices = scan.recording.slices;
    double travelled = 0.0;
    for (std::size_t i = 1; i < slices.size(); ++i)
        travelled += std::abs(slices[i].tilt - slices[i - 1].tilt);
    const double angle = slices.front().bearingStep * travelled / static_cast<double>(slices.size() - 1);
    const LikelihoodParameters& p = scan.parameters.likelihood;
    return std::clamp(p.minSolidAngle / angle, 12.0, static_cast<double>(p.enoughPoints));
}

}  // namespace

/// Numbers of decisions of `precise`, worked out anew from segments and planes of the history.
class ToldPreciseNumbersTest : public QObject {
    Q_OBJECT

private slots:
    void segmentsJoinByTheirChiSquare_data() { scenes(); }
    void segmentsJoinByTheirChiSquare();
    void segmentsLeftOverJoinByTheirChiSquare();
    void segmentsMoveInTheLastPassByTheirChiSquare();
    void pairsNearlyMergeByTheirChiSquare();
    void unfoundedPlanesAreTooSmallOrMetTooShallow();
    void clusteredSegmentsAreAsSimilarAsTold_data() { scenes(); }
    void clusteredSegmentsAreAsSimilarAsTold();

private:
    static void scenes()
    {
        QTest::addColumn<QString>("scene");
        for (const char* scene : {"corridor", "office", "stairs", "clutter", "hall", "curved"})
            QTest::newRow(scene) << scene;
    }
};

void ToldPreciseNumbersTest::segmentsJoinByTheirChiSquare()
{
    QFETCH(QString, scene);
    const ToldScan scan("precise", scene.toStdString(), 3);
    const LikelihoodParameters& p = scan.parameters.likelihood;
    Recomputed recomputed;
    int undirected = 0;
    int young = 0;
    for (const ToldPhase& phase : scan.phases) {
        if (phase.phase != Phase::Assign)
            continue;
        for (const Decision& decision : phase.decisions()) {
            if (decision.kind != DecisionKind::Assign)
                continue;
            const Test& told = decision.tests.front();
            QCOMPARE(told.name, std::string_view{"join_chi2"});
            // Planes are asked as they were before the slice: its segments join them together.
            const Plane& plane = *planeIn(*phase.before, planeOf(decision.operands[1]));
            const LineSegment& segment = phase.before->segments[segmentOf(decision.operands[0])];
            const bool isFacing = told.limit == p.joinGate;
            QVERIFY(isFacing || told.limit == p.apartGate);
            const double floor = scan.parameters.flatnessFloor() * (isFacing ? 1.0 : 0.5);
            const JoinTwin twin(segment, plane, phase.before->noise, floor);
            if (!twin.directed) {
                ++undirected;
                continue;
            }
            QVERIFY2(twin.chi < 1.2 * told.limit, qPrintable(QString::number(twin.chi)));
            if (twin.ofPlane > kSmallShare) {
                ++young;
                continue;
            }
            const double difference = std::abs(twin.chi - told.value);
            QVERIFY2(difference < 0.03 * told.value + 0.03,
                     qPrintable(QString("%1 against %2").arg(told.value).arg(twin.chi)));
            ++recomputed.counts["join_chi2"];
        }
    }
    QVERIFY2(recomputed.counts["join_chi2"] > 100, qPrintable(QString::number(recomputed.counts["join_chi2"])));
    QVERIFY2(young < recomputed.counts["join_chi2"], qPrintable(QString::number(young)));
    QVERIFY2(undirected * 20 < recomputed.counts["join_chi2"], qPrintable(QString::number(undirected)));
}

/// They join one by one: of each plane the first is compared, before it has changed.
void ToldPreciseNumbersTest::segmentsLeftOverJoinByTheirChiSquare()
{
    Recomputed recomputed;
    for (const char* scene : {"corridor", "office", "stairs", "clutter", "hall", "curved"}) {
        const ToldScan scan("precise", scene, 3);
        const LikelihoodParameters& p = scan.parameters.likelihood;
        for (const ToldPhase& phase : scan.phases) {
            if (phase.phase != Phase::Remaining && phase.pass != "remaining")
                continue;
            std::set<PlaneId> changed;
            for (const Decision& decision : phase.decisions()) {
                if (decision.kind != DecisionKind::Assign || !changed.insert(planeOf(decision.operands[1])).second)
                    continue;
                const Test& told = decision.tests.front();
                const bool isFacing = told.limit == p.joinGate;
                QVERIFY(isFacing || told.limit == p.apartGate);
                const JoinTwin twin(phase.before->segments[segmentOf(decision.operands[0])],
                                    *planeIn(*phase.before, planeOf(decision.operands[1])), phase.before->noise,
                                    scan.parameters.flatnessFloor() * (isFacing ? 1.0 : 0.5));
                if (twin.directed && twin.ofPlane < kSmallShare && told.value > 0.5)
                    QVERIFY(recomputed.agree(phase, "join_chi2", told.value, twin.chi, 0.1));
            }
        }
    }
    QVERIFY2(recomputed.counts["join_chi2"] > 20, qPrintable(QString::number(recomputed.counts["join_chi2"])));
}

void ToldPreciseNumbersTest::segmentsMoveInTheLastPassByTheirChiSquare()
{
    Recomputed recomputed;
    for (const auto& [scene, seed] :
         {std::pair("office", 3), std::pair("office", 4), std::pair("stairs", 3), std::pair("clutter", 3),
          std::pair("clutter", 4), std::pair("clutter", 5), std::pair("curved", 2), std::pair("curved", 5),
          std::pair("curved", 6), std::pair("hall", 3), std::pair("corridor", 4)}) {
        const ToldScan scan("precise", scene, static_cast<std::uint64_t>(seed));
        const double floor = scan.parameters.flatnessFloor();
        for (const ToldPhase& phase : scan.phases) {
            if (phase.pass != "split")
                continue;
            const auto twinOf = [&](const Decision& decision, PlaneId plane) {
                return JoinTwin(phase.before->segments[segmentOf(decision.operands[0])], *planeIn(*phase.before, plane),
                                phase.before->noise, floor);
            };
            for (const Decision& decision : phase.decisions()) {
                if (decision.kind != DecisionKind::Assign && decision.kind != DecisionKind::Reject)
                    continue;
                const Test& told = testOf(decision.tests, "join_chi2");
                const JoinTwin own = twinOf(decision, planeOf(decision.operands[1]));
                if (decision.kind == DecisionKind::Reject) {
                    // It fits its own plane no more, and no other better.
                    if (own.directed && own.ofPlane < kSmallShare)
                        QVERIFY(recomputed.agree(phase, told, own.chi, scan.parameters.likelihood.joinGate, 0.05));
                    continue;
                }
                const JoinTwin there = twinOf(decision, planeOf(decision.result[0]));
                if (!own.directed || own.ofPlane > kSmallShare || there.ofPlane > kSmallShare)
                    continue;
                QVERIFY(recomputed.agree(phase, "moved_chi2", told.value, there.chi, 0.05));
                // Another plane must fit better by two.
                QVERIFY(recomputed.agree(phase, "moved_chi2", told.limit, own.chi - 2.0, 0.05));
            }
        }
    }
    QVERIFY2(recomputed.counts["moved_chi2"] > 10, qPrintable(QString::number(recomputed.counts["moved_chi2"])));
    QVERIFY2(recomputed.counts["join_chi2"] > 10, qPrintable(QString::number(recomputed.counts["join_chi2"])));
}

void ToldPreciseNumbersTest::pairsNearlyMergeByTheirChiSquare()
{
    Recomputed recomputed;
    for (const char* scene : {"corridor", "office", "clutter", "hall", "curved"}) {
        const ToldScan scan("precise", scene, 3);
        const double floor = 0.5 * scan.parameters.flatnessFloor();
        for (const ToldPhase& phase : scan.phases) {
            // Planes are solved before they are compared, and stay so where they are not merged: as shown afterwards.
            std::set<PlaneId> merged;
            for (const Decision& decision : phase.decisions()) {
                if (decision.kind == DecisionKind::Merge)
                    merged.insert({planeOf(decision.operands[0]), planeOf(decision.operands[1])});
            }
            for (const Decision& decision : phase.decisions()) {
                if (decision.kind != DecisionKind::Near || merged.contains(planeOf(decision.operands[0])) ||
                    merged.contains(planeOf(decision.operands[1])))
                    continue;
                const Plane& a = *planeIn(*phase.after, planeOf(decision.operands[0]));
                const Plane& b = *planeIn(*phase.after, planeOf(decision.operands[1]));
                QVERIFY(recomputed.agree(phase, "normal_alignment", decision.tests[0].value,
                                         std::abs(a.normal.dot(b.normal))));
                const Test& last = decision.tests.back();
                if (last.name == "merge_chi2")
                    QVERIFY(recomputed.agree(phase, last, mergeChi(a, ownCovariance(a), b, ownCovariance(b), floor),
                                             scan.parameters.likelihood.mergeGate, 0.02));
            }
        }
    }
    QVERIFY(recomputed.counts["normal_alignment"] >= 5);
    QVERIFY(recomputed.counts["merge_chi2"] >= 2);
}

void ToldPreciseNumbersTest::unfoundedPlanesAreTooSmallOrMetTooShallow()
{
    Recomputed recomputed;
    for (const char* scene : {"corridor", "office", "clutter", "curved"}) {
        const ToldScan scan("precise", scene, 3);
        const PlaneParameters& p = scan.parameters.planes;
        const double fewestPoints = pointsOfSmallest(scan);
        std::set<PlaneId> ofPair;
        for (const ToldPhase& phase : scan.phases) {
            for (const Decision& decision : phase.decisions()) {
                if (decision.kind == DecisionKind::Fit && decision.tests.front().name == "pair_chi2")
                    ofPair.insert(planeOf(decision.result[0]));
                if (decision.kind != DecisionKind::NoFit || phase.pass != "drop_unfounded")
                    continue;
                const Plane& plane = *planeIn(*phase.before, planeOf(decision.operands[0]));
                std::set<int> steps;
                for (const SegmentId& id : plane.segments)
                    steps.insert(id.step);
                const auto told = [&](std::string_view name) { return testOf(decision.tests, name); };
                const bool isPair = ofPair.contains(plane.id);
                QVERIFY(recomputed.agree(phase, told("points"), plane.points, fewestPoints, 1e-6));
                QVERIFY(recomputed.agree(phase, told("spread_points"), spreadPoints(plane, *phase.before), 10.0, 1e-2));
                QVERIFY(recomputed.agree(phase, told("segments"), static_cast<double>(plane.segments.size()),
                                         isPair ? 2.0 : p.minSegments));
                QVERIFY(recomputed.agree(phase, told("slices"), static_cast<double>(steps.size()),
                                         isPair ? 2.0 : p.minSlices));
                const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> angles(plane.covariance.topLeftCorner<2, 2>());
                QVERIFY(recomputed.agree(phase, told("normal_sigma"), std::sqrt(angles.eigenvalues()[1]),
                                         p.maxNormalSigma, 1e-6));
                QVERIFY(recomputed.agree(phase, told("incidence"), meanIncidence(plane, *phase.before),
                                         std::sin(p.minIncidence), 1e-6));
            }
        }
    }
    QVERIFY(recomputed.counts["points"] > 10);
}

void ToldPreciseNumbersTest::clusteredSegmentsAreAsSimilarAsTold()
{
    QFETCH(QString, scene);
    const ToldScan scan("precise", scene.toStdString(), 3);
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        if (phase.phase != Phase::Cluster)
            continue;
        if (phase.decisions().empty())
            continue;
        // Until the first segment of the slice has moved a cluster, all are as they were.
        const Decision& first = phase.decisions().front();
        const Eigen::Vector3d direction = phase.after->segments[segmentOf(first.operands[0])].direction;
        double most = 0.0;
        for (const auto& cluster : phase.before->clusters)
            most = std::max(most, std::abs(direction.dot(cluster->direction)));
        QVERIFY(recomputed.agree(phase, first.tests.front(), most, std::cos(scan.parameters.clusters.directionLimit)));
    }
    QVERIFY(recomputed.counts["similarity"] > 10);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldPreciseNumbersTest)
#include "told_precise_numbers_test.moc"
