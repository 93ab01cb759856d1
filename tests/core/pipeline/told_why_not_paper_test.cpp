// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/core/pipeline/asked_scan.h"
#include "tests/core/pipeline/leaning_runs_twin.h"
#include "tests/core/pipeline/paper_twin.h"
#include "tests/core/pipeline/plane_pair_twin.h"
#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// What a step left behind, and why not, as somebody sees it who knows no more than the snapshot.
struct PaperTwin {
    const Snapshot& now;
    Parameters parameters;
    RunTwin runs;

    PaperTwin(const Snapshot& snapshot, const Parameters& all)
        : now(snapshot), parameters(all), runs(snapshot.segments, parameters.planes)
    {
    }

    Match match(const SegmentId& segment, const Plane& plane) const
    {
        return {now.segments[segment], plane, parameters.assignment};
    }
    static bool isMatch(const Match& match)
    {
        return match.distance < match.distanceLimit && match.orthogonality < match.orthogonalityLimit;
    }
    /// Of planes of a hundred segments it is not asked.
    bool leansOut(const SegmentId& segment, const Plane& plane) const
    {
        return plane.segments.size() < 100 && runs.contests(segment, plane.normal, plane.distance);
    }

    /// The nearest plane that a segment matches, of all but one; null where there is none.
    const Plane* nearest(const SegmentId& segment, const Plane& without) const
    {
        const Plane* best = nullptr;
        for (const auto& plane : now.planes) {
            if (plane->id == without.id)
                continue;
            const Match here = match(segment, *plane);
            if (isMatch(here) && (best == nullptr || here.distance < match(segment, *best).distance) &&
                !leansOut(segment, *plane))
                best = plane.get();
        }
        return best;
    }

    double shared(const Plane& smaller, const Plane& larger) const
    {
        const auto fitting = std::count_if(smaller.segments.begin(), smaller.segments.end(),
                                           [&](const SegmentId& segment) { return isMatch(match(segment, larger)); });
        return static_cast<double>(fitting) / static_cast<double>(smaller.segments.size());
    }
};

}  // namespace

/// *Why not?* of `paper`: every number, worked out anew from the snapshot of the step.
class ToldWhyNotPaperTest : public QObject {
    Q_OBJECT

private slots:
    void segmentsAreKeptOutForTheNumbersThatAreTold_data() { scenes(); }
    void segmentsAreKeptOutForTheNumbersThatAreTold();
    void planesAreTwoForTheNumbersThatAreTold_data() { scenes(); }
    void planesAreTwoForTheNumbersThatAreTold();

private:
    static void scenes()
    {
        QTest::addColumn<QString>("scene");
        for (const char* scene : {"corridor", "office", "stairs", "clutter"})
            QTest::newRow(scene) << scene;
    }

    template <class Visit>
    static void visitSteps(AskedScan& scan, Visit visit)
    {
        for (int step = 9; step <= scan.steps(); step += 12) {
            const int at = step + 12 > scan.steps() ? kLastPass : step;
            const auto snapshot = (*scan.replay.at(at))->snapshot;
            ToldPhase phase;
            phase.step = at;
            phase.after = snapshot;
            visit(phase, PaperTwin(*snapshot, AskedScan::parametersOf("paper")));
        }
    }
};

void ToldWhyNotPaperTest::segmentsAreKeptOutForTheNumbersThatAreTold()
{
    QFETCH(QString, scene);
    AskedScan scan("paper", scene.toStdString());
    Recomputed recomputed;
    bool isRight = true;
    const auto agree = [&](const ToldPhase& phase, const Test& told, double value, double limit) {
        isRight = recomputed.agree(phase, told, value, limit, 1e-7) && isRight;
    };
    visitSteps(scan, [&](const ToldPhase& phase, const PaperTwin& twin) {
        for (const SegmentId& segment : askedSegments(twin.now)) {
            const Plane* own = ownerOf(segment, twin.now);
            for (const auto& plane : twin.now.planes) {
                const auto answer = scan.replay.whyNot(phase.step, segment, PlaneRef{plane->id});
                const std::vector<Test>& tests = wayOf(*answer, "assign").tests;
                const Match match = twin.match(segment, *plane);
                agree(phase, testOf(tests, "plane_distance"), match.distance, match.distanceLimit);
                agree(phase, testOf(tests, "orthogonality"), match.orthogonality, match.orthogonalityLimit);
                agree(phase, testOf(tests, "contested"), twin.leansOut(segment, *plane) ? 1.0 : 0.0, 0.0);
                const bool isElsewhere = own != nullptr && own != plane.get();
                const Test& taken = testOf(tests, "in_other_plane");
                isRight = isRight && isElsewhere == (taken.name == "in_other_plane");
                if (isElsewhere)
                    agree(phase, taken, 1.0, 0.0);
                const Plane* other = twin.nearest(segment, *plane);
                const Test& next = testOf(tests, "distance_of_next");
                isRight = isRight && (other != nullptr) == (next.name == "distance_of_next");
                if (other != nullptr)
                    agree(phase, next, match.distance, twin.match(segment, *other).distance);
                isRight = isRight && answer->ways.size() == (isElsewhere ? 2 : 1);
                if (!isElsewhere)
                    continue;
                const std::vector<Test>& moves = wayOf(*answer, "reassign").tests;
                agree(phase, testOf(moves, "distance_of_own"), match.distance, twin.match(segment, *own).distance);
                agree(phase, testOf(moves, "plane_distance"), match.distance, match.distanceLimit);
            }
        }
    });
    QVERIFY(isRight);
    QVERIFY(recomputed.counts["plane_distance"] > 200 && recomputed.counts["in_other_plane"] > 50);
    QVERIFY(recomputed.counts["distance_of_next"] > 20 && recomputed.counts["distance_of_own"] > 50);
}

void ToldWhyNotPaperTest::planesAreTwoForTheNumbersThatAreTold()
{
    QFETCH(QString, scene);
    AskedScan scan("paper", scene.toStdString());
    const PlaneParameters p = AskedScan::parametersOf("paper").planes;
    Recomputed recomputed;
    bool isRight = true;
    const auto agree = [&](const ToldPhase& phase, const Test& told, double value, double limit, double relative) {
        isRight = recomputed.agree(phase, told, value, limit, relative) && isRight;
    };
    visitSteps(scan, [&](const ToldPhase& phase, const PaperTwin& twin) {
        const SegmentLog& log = twin.now.segments;
        for (std::size_t i = 0; i < twin.now.planes.size(); ++i) {
            for (std::size_t j = i + 1; j < twin.now.planes.size(); ++j) {
                const Plane& a = *twin.now.planes[i];
                const Plane& b = *twin.now.planes[j];
                const auto answer = scan.replay.whyNot(phase.step, PlaneRef{b.id}, PlaneRef{a.id});
                const std::vector<Test>& merge = wayOf(*answer, "merge").tests;
                const double sigma = std::sqrt(largestAngleVariance(a) + largestAngleVariance(b));
                agree(phase, testOf(merge, "normal_alignment"), std::abs(a.normal.dot(b.normal)),
                      std::cos(std::clamp(p.mergeSigmas * sigma, p.mergeAngle, 4.0 * p.mergeAngle)), 1e-9);
                const auto [distance, limit] = pairDistance(a, b, twin.now, twin.parameters);
                agree(phase, testOf(merge, "plane_distance"), distance, limit, 1e-6);
                const double gap = gapOf(a.segments, b.segments, log, p.mergeGap);
                agree(phase, testOf(merge, "in_plane_gap"), gap, p.mergeGap, 1e-6);
                const TogetherTwin together(a, b, log, p);
                // Of planes far from one another it goes with the square of what the plane of both is turned by.
                const bool isNear = together.error < 2.0 * p.errorLimit;
                agree(phase, testOf(merge, "fitting_error"), together.error, p.errorLimit, isNear ? 0.002 : 0.03);
                const auto contestedBy = [&](const Plane& plane) {
                    return twin.runs.share(plane.segments, together.plane.normal, together.plane.distance);
                };
                agree(phase, testOf(merge, "contested"), std::max(contestedBy(a), contestedBy(b)), p.maxContested,
                      1e-9);

                const Plane& larger = b.segments.size() > a.segments.size() ? b : a;
                const Plane& smaller = &larger == &a ? b : a;
                const std::vector<Test>& absorb = wayOf(*answer, "absorb").tests;
                agree(phase, testOf(absorb, "segments"), static_cast<double>(larger.segments.size()),
                      static_cast<double>(smaller.segments.size()), 1e-9);
                agree(phase, testOf(absorb, "shared_segments"), twin.shared(smaller, larger), p.mergeShare, 1e-9);
                agree(phase, testOf(absorb, "in_plane_gap"), gap, p.mergeGap, 1e-6);
                agree(phase, testOf(absorb, "contested"),
                      twin.runs.share(smaller.segments, larger.normal, larger.distance), p.maxContested, 1e-9);
            }
        }
    });
    QVERIFY(isRight);
    QVERIFY(recomputed.counts["shared_segments"] > 100 && recomputed.counts["plane_distance"] > 100);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldWhyNotPaperTest)
#include "told_why_not_paper_test.moc"
