// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/core/pipeline/new_plane_twin.h"
#include "tests/core/pipeline/paper_twin.h"
#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Clusters as they move from decision to decision, by Eq. (9) to (12).
struct ClusterTwin {
    struct Moving {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        int count = 0;
    };
    std::map<ClusterId, Moving> clusters;

    /// |δ·δ̄| with the most similar cluster; 0 where there is none.
    double similarity(const Eigen::Vector3d& direction) const
    {
        double most = 0.0;
        for (const auto& [id, cluster] : clusters)
            most = std::max(most, std::abs(direction.dot(cluster.mean)) / cluster.mean.norm());
        return most;
    }

    void join(ClusterId id, const Eigen::Vector3d& direction, const ClusterParameters& p)
    {
        Moving& cluster = clusters[id];
        const double side = cluster.mean.dot(direction) < 0.0 ? -1.0 : 1.0;
        const double n = cluster.count++;
        if (n == 0.0) {
            cluster.mean = direction;
            return;
        }
        // Weights of the mean so far and of the new direction: (n, 1), (1 + … + n, n + 1), (1 − τ, τ).
        double mean = n;
        double fresh = 1.0;
        if (p.average == MovingAverage::LinearlyWeighted) {
            mean = n * (n + 1.0) / 2.0;
            fresh = n + 1.0;
        } else if (p.average == MovingAverage::ExponentiallyWeighted) {
            mean = 1.0 - p.decay;
            fresh = p.decay;
        }
        cluster.mean = (mean * cluster.mean + fresh * side * direction) / (mean + fresh);
    }

    /// Segments have left; a cluster without any is gone.
    void follow(const Snapshot& snapshot)
    {
        std::erase_if(clusters, [&](const auto& entry) { return clusterIn(snapshot, entry.first) == nullptr; });
        for (auto& [id, cluster] : clusters)
            cluster.count = static_cast<int>(clusterIn(snapshot, id)->segments.size());
    }
};

}  // namespace

/// Every number of a decision of `paper`, worked out anew from segments and planes of the history.
class ToldPaperNumbersTest : public QObject {
    Q_OBJECT

private slots:
    void assignmentsAreComparedByEq8_data() { scenes(); }
    void assignmentsAreComparedByEq8();
    void clustersFollowTheirSegments_data() { scenes(); }
    void clustersFollowTheirSegments();
    void newPlanesAreWhatTheirSegmentsSay_data() { scenes(); }
    void newPlanesAreWhatTheirSegmentsSay();
    void segmentsMoveToPlanesAsNearAsTold();
    void splitsAndMergesAreComparedByEq21And22_data() { scenes(); }
    void splitsAndMergesAreComparedByEq21And22();

private:
    static void scenes()
    {
        QTest::addColumn<QString>("scene");
        for (const char* scene : {"corridor", "office", "stairs", "clutter", "hall", "curved"})
            QTest::newRow(scene) << scene;
    }
};

void ToldPaperNumbersTest::assignmentsAreComparedByEq8()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        if (phase.phase != Phase::Assign && phase.phase != Phase::Remaining && phase.pass != "remaining")
            continue;
        // A plane is fitted anew after so many additions: within a phase it may turn once.
        std::map<PlaneId, int> additions;
        for (const Decision& decision : phase.decisions())
            additions[decision.result.empty() ? kNoPlane : planeOf(decision.result.front())] += 1;
        std::set<PlaneId> turned;
        for (const Decision& decision : phase.decisions()) {
            if (decision.operands.size() < 2 || decision.tests.front().name == "contested")
                continue;
            const PlaneId id = planeOf(decision.operands[1]);
            QVERIFY2(additions[id] <= scan.parameters.assignment.refitEvery, phase.text().c_str());
            const LineSegment& segment = phase.after->segments[segmentOf(decision.operands[0])];
            const Match before(segment, *planeIn(*phase.before, id), scan.parameters.assignment);
            const Match after(segment, *planeIn(*phase.after, id), scan.parameters.assignment);
            if (!turned.contains(id) && !before.isSame(decision.tests[0].value))
                turned.insert(id);
            const Match& match = turned.contains(id) ? after : before;
            QVERIFY(recomputed.agree(phase, testOf(decision.tests, "plane_distance"), match.distance,
                                     match.distanceLimit, 1e-7));
            QVERIFY(recomputed.agree(phase, testOf(decision.tests, "orthogonality"), match.orthogonality,
                                     match.orthogonalityLimit, 1e-7));
            // No plane that a segment was rejected by was farther than another.
            if (decision.kind == DecisionKind::Reject && turned.empty() && phase.phase == Phase::Assign) {
                for (const auto& other : phase.before->planes)
                    QVERIFY(Match(segment, *other, scan.parameters.assignment).distance > match.distance - 1e-9);
            }
        }
    }
    QVERIFY(recomputed.counts["plane_distance"] > 200);
}

void ToldPaperNumbersTest::clustersFollowTheirSegments()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    Recomputed recomputed;
    ClusterTwin twin;
    for (const ToldPhase& phase : scan.phases) {
        for (const Decision& decision : phase.decisions()) {
            if (decision.kind != DecisionKind::Cluster)
                continue;
            const Eigen::Vector3d direction = phase.after->segments[segmentOf(decision.operands[0])].direction;
            QVERIFY(recomputed.agree(phase, decision.tests.front(), twin.similarity(direction),
                                     std::cos(scan.parameters.clusters.directionLimit), 1e-9));
            twin.join(clusterOf(decision.result[0]), direction, scan.parameters.clusters);
        }
        twin.follow(*phase.after);
        for (const auto& cluster : phase.after->clusters) {
            QVERIFY(twin.clusters.contains(cluster->id));
            QVERIFY((twin.clusters[cluster->id].mean.normalized() - cluster->direction).norm() < 1e-9);
        }
    }
    QVERIFY(recomputed.counts["direction_similarity"] > 40);
}

void ToldPaperNumbersTest::newPlanesAreWhatTheirSegmentsSay()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    const PlaneParameters& p = scan.parameters.planes;
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        std::vector<SegmentId> taken;  // by planes that the phase made before
        for (const Decision& decision : phase.decisions()) {
            if (decision.kind == DecisionKind::NoFit && decision.tests.front().name == "cluster_segments") {
                const DirectionCluster& cluster = *clusterIn(*phase.before, clusterOf(decision.operands[0]));
                QVERIFY(recomputed.agree(phase, decision.tests[0], static_cast<double>(cluster.segments.size()),
                                         p.minClusterSegments));
                QVERIFY(recomputed.agree(phase, decision.tests[1], static_cast<double>(slicesOf(cluster.segments)),
                                         p.minClusterSlices));
            }
            if (decision.kind != DecisionKind::Fit)
                continue;
            const Plane& plane = *planeIn(*phase.after, planeOf(decision.result[0]));
            const Shape shape(plane, *phase.after, p);
            const auto told = [&](std::string_view name) { return testOf(decision.tests, name); };
            const auto segments = static_cast<double>(plane.segments.size());
            QVERIFY(recomputed.agree(phase, told("segments"), segments, p.minSegments));
            QVERIFY(
                recomputed.agree(phase, told("slices"), static_cast<double>(slicesOf(plane.segments)), p.minSlices));
            QVERIFY(recomputed.agree(phase, told("points"), shape.points, p.minPoints));
            QVERIFY(recomputed.agree(
                phase, told("extent"), shape.extent,
                std::max(p.minExtent, shape.range * std::tan(p.minExtentAngle) * (1.0 - 0.5 * shape.incidence)), 1e-6));
            QVERIFY(recomputed.agree(phase, told("normal_sigma"), std::sqrt(largestAngleVariance(plane)),
                                     p.maxNormalSigma, 1e-6));
            QVERIFY(recomputed.agree(phase, told("incidence"), shape.incidence, std::sin(p.minIncidence), 1e-9));
            QVERIFY(recomputed.agree(phase, told("fitting_error"), shape.error, p.errorLimit, 1e-4));
            std::vector<SegmentId> candidates = clusterIn(*phase.before, clusterOf(decision.operands[0]))->segments;
            std::erase_if(candidates, [&](const SegmentId& segment) { return holds(taken, segment); });
            taken.insert(taken.end(), plane.segments.begin(), plane.segments.end());
            QVERIFY(recomputed.agree(phase, told("contradictions"),
                                     contradictionsOf(plane, candidates, phase.after->segments, p), segments));
        }
    }
    QVERIFY(recomputed.counts["extent"] > 4);
    QVERIFY(recomputed.counts["cluster_segments"] > 4);
}

void ToldPaperNumbersTest::segmentsMoveToPlanesAsNearAsTold()
{
    Recomputed recomputed;
    for (const char* scene : {"corridor", "office", "stairs", "clutter", "hall", "curved"}) {
        const ToldScan scan("paper", scene, 3);
        for (const ToldPhase& phase : scan.phases) {
            if (phase.pass != "reassign")
                continue;
            // All moves are decided on the planes as they were.
            for (const Decision& decision : phase.decisions()) {
                if (decision.kind != DecisionKind::Assign)
                    continue;
                const LineSegment& segment = phase.before->segments[segmentOf(decision.operands[0])];
                const Plane& own = *planeIn(*phase.before, planeOf(decision.operands[1]));
                const Match there(segment, *planeIn(*phase.before, planeOf(decision.result[0])),
                                  scan.parameters.assignment);
                const Match here(segment, own, scan.parameters.assignment);
                QVERIFY(holds(own.segments, segment.id));
                QVERIFY(recomputed.agree(phase, decision.tests.front(), there.distance, here.distance));
                QVERIFY(there.distance < there.distanceLimit && there.orthogonality < there.orthogonalityLimit);
            }
        }
    }
    QVERIFY2(recomputed.counts["plane_distance"] > 20,
             qPrintable(QString::number(recomputed.counts["plane_distance"])));
}

void ToldPaperNumbersTest::splitsAndMergesAreComparedByEq21And22()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    const PlaneParameters& p = scan.parameters.planes;
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        std::set<PlaneId> changed;
        for (const Decision& decision : phase.decisions()) {
            if (decision.kind == DecisionKind::Split) {
                const Plane& plane = *planeIn(*phase.before, planeOf(decision.operands[0]));
                if (decision.tests.front().name == "fitting_error")
                    QVERIFY(recomputed.agree(phase, decision.tests.front(), Shape(plane, *phase.before, p).error,
                                             p.errorLimit, 1e-2));
            }
            const bool isPair = (decision.kind == DecisionKind::Merge || decision.kind == DecisionKind::Near) &&
                                decision.tests.front().name == "normal_alignment";
            const auto asBefore = [&](const Operand& operand) -> const Plane* {
                return changed.contains(planeOf(operand)) ? nullptr : planeIn(*phase.before, planeOf(operand));
            };
            if (isPair && asBefore(decision.operands[0]) != nullptr && asBefore(decision.operands[1]) != nullptr) {
                const Plane& a = *asBefore(decision.operands[0]);
                const Plane& b = *asBefore(decision.operands[1]);
                const double sigma = std::sqrt(largestAngleVariance(a) + largestAngleVariance(b));
                const double angle = std::clamp(p.mergeSigmas * sigma, p.mergeAngle, 4.0 * p.mergeAngle);
                QVERIFY(recomputed.agree(phase, decision.tests[0], std::abs(a.normal.dot(b.normal)), std::cos(angle),
                                         1e-9));
                const auto [distance, limit] = pairDistance(a, b, *phase.before, scan.parameters);
                QVERIFY(recomputed.agree(phase, testOf(decision.tests, "plane_distance"), distance, limit, 1e-6));
            }
            const bool isTakenIn = decision.kind == DecisionKind::Merge && !isPair;
            if (isTakenIn && asBefore(decision.operands[0]) != nullptr && asBefore(decision.operands[1]) != nullptr) {
                // The share of the smaller plane's segments that match the larger one.
                const Plane& larger = *asBefore(decision.operands[0]);
                const Plane& smaller = *asBefore(decision.operands[1]);
                const auto fitting =
                    std::count_if(smaller.segments.begin(), smaller.segments.end(), [&](const SegmentId& id) {
                        const Match match(phase.before->segments[id], larger, scan.parameters.assignment);
                        return match.distance < match.distanceLimit && match.orthogonality < match.orthogonalityLimit;
                    });
                QVERIFY(recomputed.agree(phase, testOf(decision.tests, "shared_segments"),
                                         static_cast<double>(fitting) / static_cast<double>(smaller.segments.size()),
                                         p.mergeShare));
            }
            if (decision.kind == DecisionKind::Merge || decision.kind == DecisionKind::Split) {
                for (const Operand& operand : decision.operands)
                    changed.insert(planeOf(operand));
                for (const Operand& result : decision.result)
                    changed.insert(planeOf(result));
            }
        }
    }
    // Nothing comes near another in a corridor and on stairs; a curved wall is many planes that nearly are one.
    if (scene == "curved")
        QVERIFY(recomputed.counts["normal_alignment"] > 40 && recomputed.counts["fitting_error"] > 0 &&
                recomputed.counts["shared_segments"] > 0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldPaperNumbersTest)
#include "told_paper_numbers_test.moc"
