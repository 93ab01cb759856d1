// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/core/pipeline/asked_scan.h"
#include "tests/core/pipeline/likelihood_twin.h"
#include "tests/core/pipeline/neighbour_slices.h"
#include "tests/core/pipeline/precise_twin.h"
#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Chi-squares are compared where the plane's own covariance makes less than this share of the variance: it is that of
/// where the plane was linearised, some way from where a young one is.
constexpr double kShareOfPlane = 0.1;
/// So far may they be off for that, and by as much of one unit in small ones. What is far from a plane says little of
/// its place, and those of many thousand go with the square of what the plane's tangents are turned by.
double toleranceOf(double chi)
{
    return chi < 1e5 ? 0.05 : 0.5;
}
/// The plane of both is worked out for so many segments.
constexpr std::size_t kFew = 60;
/// A segment that fits one plane so well asks no other.
constexpr double kCertainChi = 4.0;

bool isClose(double told, double chi)
{
    return std::abs(told - chi) < toleranceOf(chi) * std::max({1.0, told, chi});
}

/// One of the planes that a segment faces was linearised far from where it is, or noise directs the segment's line.
bool areUnsure(const std::vector<JoinTwin>& fits)
{
    return std::any_of(fits.begin(), fits.end(),
                       [](const JoinTwin& fit) { return !fit.directed || fit.ofPlane > kShareOfPlane; });
}

}  // namespace

/// *Why not?* of `precise`: every number, worked out anew from the snapshot of the step.
class ToldWhyNotPreciseTest : public QObject {
    Q_OBJECT

private slots:
    void segmentsDoNotFaceOrFitAsTold_data() { scenes(); }
    void segmentsDoNotFaceOrFitAsTold();
    void planesAreKnownAsWellAsTold_data() { scenes(); }
    void planesAreKnownAsWellAsTold();
    void segmentsFitOtherPlanesAsTold_data() { scenes(); }
    void segmentsFitOtherPlanesAsTold();
    void planesAreApartAsTold_data() { scenes(); }
    void planesAreApartAsTold();

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
            ToldPhase phase;
            phase.step = at;
            phase.after = (*scan.replay.at(at))->snapshot;
            visit(phase, PreciseTwin(*phase.after, scan.room.scan.recording, AskedScan::parametersOf("precise")));
        }
    }

    /// Segments of the newest slices and of planes, against each plane.
    template <class Visit>
    static void visitSegments(AskedScan& scan, Visit visit)
    {
        visitSteps(scan, [&](const ToldPhase& phase, const PreciseTwin& twin) {
            for (const SegmentId& segment : askedSegments(twin.now)) {
                for (const auto& plane : twin.now.planes)
                    visit(phase, twin, twin.now.segments[segment], *plane,
                          *scan.replay.whyNot(phase.step, segment, PlaneRef{plane->id}));
            }
        });
    }
};

void ToldWhyNotPreciseTest::segmentsDoNotFaceOrFitAsTold()
{
    QFETCH(QString, scene);
    AskedScan scan("precise", scene.toStdString());
    Recomputed recomputed;
    bool isRight = true;
    int lean = 0;
    visitSegments(scan, [&](const ToldPhase& phase, const PreciseTwin& twin, const LineSegment& s, const Plane& plane,
                            const WhyNot& answer) {
        const std::vector<Test>& tests = wayOf(answer, "join_facing").tests;
        const Plane* own = ownerOf(s.id, twin.now);
        const bool isElsewhere = own != nullptr && own != &plane;
        isRight = isRight && isElsewhere == (tests.front().name == "in_other_plane") &&
                  isElsewhere == (answer.ways.size() == 3) && answer.together == (own == &plane);
        if (isElsewhere)
            isRight = recomputed.agree(phase, tests.front(), 1.0, 0.0) && isRight;
        isRight =
            recomputed.agree(phase, testOf(tests, "facing"), twin.faces(s, plane, false) ? 1.0 : 0.0, 1.0) && isRight;

        // It is that of the plane where it was linearised, up to 0.03 from where it is.
        const Test& steep = testOf(tests, "steepness");
        const double steepness = std::max(2.7e-3, steepnessOf(s, plane.normal));
        isRight = isRight && std::abs(steep.value - steepness) < 0.06 * std::sqrt(steepness) + 0.001 &&
                  recomputed.agree(phase, "steepness", steep.limit, 2.7e-3);
        const bool leans = std::abs(steep.value - steepness) > 0.01 * steepness;
        lean += leans ? 1 : 0;

        const Test& joins = testOf(tests, "join_chi2");
        isRight = isRight && steep.pass() == (joins.name == "join_chi2");
        const JoinTwin fit = twin.join(s, plane, 1.0);
        if (joins.name != "join_chi2" || leans || !fit.directed || fit.ofPlane > kShareOfPlane)
            return;
        isRight = recomputed.agree(phase, "join_chi2", joins.limit, twin.parameters.likelihood.joinGate) && isRight;
        isRight = (isClose(joins.value, fit.chi) ||
                   recomputed.agree(phase, "join_chi2", joins.value, fit.chi, toleranceOf(fit.chi))) &&
                  isRight;
    });
    QVERIFY(isRight);
    QVERIFY(recomputed.counts["facing"] > 200 && recomputed.counts["join_chi2"] > 200 &&
            recomputed.counts["in_other_plane"] > 50);
    QVERIFY2(6 * lean < recomputed.counts["steepness"], qPrintable(QString::number(lean)));
}

void ToldWhyNotPreciseTest::planesAreKnownAsWellAsTold()
{
    QFETCH(QString, scene);
    AskedScan scan("precise", scene.toStdString());
    Recomputed recomputed;
    bool isRight = true;
    int closely = 0;
    visitSegments(scan, [&](const ToldPhase& phase, const PreciseTwin& twin, const LineSegment& s, const Plane& plane,
                            const WhyNot& answer) {
        const std::vector<Test>& tests = wayOf(answer, "join_known").tests;
        isRight = recomputed.agree(phase, testOf(tests, "normal_variance"), angleVarianceOf(plane),
                                   std::pow(twin.parameters.likelihood.knownAngle, 2), 1e-4) &&
                  isRight;
        isRight = recomputed.agree(phase, testOf(tests, "slices_away"), twin.slicesAway(s, plane), 8.0) && isRight;
        // Where the plane tells too little, it is not asked of one that a segment would turn parallel to another.
        const Test& placed = testOf(tests, "place_sigma");
        const double sigma = PreciseTwin::sigmaAt(s.moments.mean, plane);
        const double limit = twin.ownSigma(s);
        // Its tangents are shown as they are at right angles to the normal, up to 0.1 from where it was linearised:
        // so much of its distance is a lever more or less.
        const double turned = 0.1 * plane.distance * std::sqrt(angleVarianceOf(plane)) + 0.03 * sigma;
        if (placed.name == "place_sigma") {
            isRight = recomputed.agree(phase, "limit of place_sigma", placed.limit, limit) &&
                      std::abs(placed.value - sigma) < turned && isRight;
            closely += std::abs(placed.value - sigma) < 0.02 * sigma ? 1 : 0;
            ++recomputed.counts["place_sigma"];
        } else {
            isRight = isRight && sigma + turned > limit;
        }

        const Test& joins = testOf(tests, "join_chi2");
        const JoinTwin fit = twin.join(s, plane, 0.5);
        if (joins.name == "join_chi2" && fit.directed && fit.ofPlane < kShareOfPlane) {
            isRight =
                recomputed.agree(phase, "join_chi2", joins.limit, twin.parameters.likelihood.apartGate) && isRight;
            isRight = (isClose(joins.value, fit.chi) ||
                       recomputed.agree(phase, "join_chi2", joins.value, fit.chi, toleranceOf(fit.chi))) &&
                      isRight;
        }
        const std::vector<JoinTwin> facing = twin.facing(s);
        const bool fits = std::any_of(facing.begin(), facing.end(),
                                      [&](const JoinTwin& f) { return f.chi < twin.parameters.likelihood.joinGate; });
        if (!areUnsure(facing))
            isRight = recomputed.agree(phase, testOf(tests, "fits_facing_plane"), fits ? 1.0 : 0.0, 0.0) && isRight;
    });
    QVERIFY(isRight);
    QVERIFY(recomputed.counts["normal_variance"] > 200 && recomputed.counts["slices_away"] > 200);
    QVERIFY(recomputed.counts["place_sigma"] > 50 && recomputed.counts["join_chi2"] > 100 &&
            recomputed.counts["fits_facing_plane"] > 50);
    QVERIFY2(10 * closely > 8 * recomputed.counts["place_sigma"], qPrintable(QString::number(closely)));
}

void ToldWhyNotPreciseTest::segmentsFitOtherPlanesAsTold()
{
    QFETCH(QString, scene);
    AskedScan scan("precise", scene.toStdString());
    Recomputed recomputed;
    bool isRight = true;
    const auto agree = [&](const ToldPhase& phase, std::string_view name, double told, double chi) {
        ++recomputed.counts[name];
        if (!isClose(told, chi))
            isRight = recomputed.agree(phase, name, told, chi, toleranceOf(chi)) && isRight;
    };
    visitSegments(scan, [&](const ToldPhase& phase, const PreciseTwin& twin, const LineSegment& s, const Plane& plane,
                            const WhyNot& answer) {
        const std::vector<Test>& nearby = wayOf(answer, "join_facing").tests;
        const std::vector<JoinTwin> facing = twin.facing(s);
        const auto fitsSo = [&](double chi) {
            return std::any_of(facing.begin(), facing.end(), [chi](const JoinTwin& f) { return isClose(chi, f.chi); });
        };
        if (!areUnsure(facing)) {
            const Test& certain = testOf(nearby, "certain_elsewhere");
            if (certain.name == "certain_elsewhere") {
                isRight = isRight && !certain.pass() && fitsSo(certain.value) &&
                          recomputed.agree(phase, "certain_elsewhere", certain.limit, kCertainChi);
            }
            // One that fits certainly is taken before all are asked.
            const Test& rival = testOf(nearby, "rival_chi2");
            if (rival.name == "rival_chi2") {
                double least = twin.parameters.likelihood.joinGate;
                for (const JoinTwin& fit : facing)
                    least = std::min(least, fit.chi);
                if (rival.limit >= 1.1 * kCertainChi)
                    agree(phase, "rival_chi2", rival.limit, least);
                else
                    isRight = isRight && fitsSo(rival.limit);
                isRight = isRight && rival.value == testOf(nearby, "join_chi2").value;
                ++recomputed.counts["rival"];
            }
        }
        if (answer.ways.size() < 3)
            return;
        const std::vector<Test>& moves = wayOf(answer, "move").tests;
        const JoinTwin own = twin.join(s, *ownerOf(s.id, twin.now), 1.0);
        const JoinTwin there = twin.join(s, plane, 1.0);
        if (own.directed && own.ofPlane < kShareOfPlane) {
            agree(phase, "own_chi2", testOf(moves, "own_chi2").value, own.chi);
            agree(phase, "moved_chi2", testOf(moves, "moved_chi2").limit, own.chi);
            isRight = recomputed.agree(phase, "limit of own_chi2", testOf(moves, "own_chi2").limit, 2.0) && isRight;
        }
        if (own.directed && there.ofPlane < kShareOfPlane && steepnessOf(s, plane.normal) > 0.01) {
            agree(phase, "join_chi2", testOf(moves, "join_chi2").value, there.chi);
            agree(phase, "moved_chi2", testOf(moves, "moved_chi2").value, there.chi + 2.0);
        }
    });
    QVERIFY(isRight);
    QVERIFY(recomputed.counts["certain_elsewhere"] > 100 && recomputed.counts["rival"] > 100);
    QVERIFY(recomputed.counts["own_chi2"] > 200 && recomputed.counts["moved_chi2"] > 400);
}

void ToldWhyNotPreciseTest::planesAreApartAsTold()
{
    QFETCH(QString, scene);
    AskedScan scan("precise", scene.toStdString());
    Recomputed recomputed;
    bool isRight = true;
    int aligned = 0;
    const auto agree = [&](const ToldPhase& phase, const Test& told, double value, double limit, double relative) {
        isRight = recomputed.agree(phase, told, value, limit, relative) && isRight;
    };
    visitSteps(scan, [&](const ToldPhase& phase, const PreciseTwin& twin) {
        const LikelihoodParameters& p = twin.parameters.likelihood;
        const double floor = 0.5 * twin.parameters.flatnessFloor();
        for (std::size_t i = 0; i < twin.now.planes.size(); ++i) {
            for (std::size_t j = i + 1; j < twin.now.planes.size(); ++j) {
                const Plane& a = *twin.now.planes[i];
                const Plane& b = *twin.now.planes[j];
                const auto answer = scan.replay.whyNot(phase.step, PlaneRef{a.id}, PlaneRef{b.id});
                const std::vector<Test>& tests = wayOf(*answer, "merge").tests;
                aligned += std::abs(a.normal.dot(b.normal)) > 0.9 ? 1 : 0;
                agree(phase, testOf(tests, "normal_alignment"), std::abs(a.normal.dot(b.normal)), 0.9, 1e-9);
                const double known = std::pow(p.mergeAngle, 2);
                const PlaneSegments ofA = segmentsOf(a.segments, twin.now.segments);
                const PlaneSegments ofB = segmentsOf(b.segments, twin.now.segments);
                const bool sharp = angleVarianceOf(a) < known && angleVarianceOf(b) < known;
                const bool adjacent = sharp || twin.neighbours.sideBySide(ofA, ofB);
                agree(phase, testOf(tests, "adjacent"), adjacent ? 1.0 : 0.0, 1.0, 1e-9);

                // Planes at an angle are many thousand variances apart, which go with the square of what the tangents
                // are turned by since they were linearised; of others it is seldom as much as of one degree.
                const double tolerance = std::abs(a.normal.dot(b.normal)) > 0.9 ? 0.08 : 0.5;
                const double scatter = std::max({1.0, a.fittingError, b.fittingError});
                const double chi = mergeChi(a, ownCovariance(a), b, ownCovariance(b), floor);
                agree(phase, testOf(tests, "near_chi2"), chi, 4.0 * p.mergeGate * scatter, tolerance);
                const Test& scattered = testOf(tests, "scattered_chi2");
                const bool isAsked = testOf(tests, "near_chi2").value >= p.mergeGate && scatter > 1.0;
                isRight = isRight && isAsked == (scattered.name == "scattered_chi2");
                if (isAsked)
                    agree(phase, scattered, mergeChi(a, a.covariance, b, b.covariance, floor), 4.0 * p.mergeGate,
                          tolerance);

                const Test& last = tests.back();
                isRight = isRight && (isAsked && adjacent) == (last.name == "worse_together");
                if (last.name == "merge_chi2") {
                    agree(phase, last, chi, p.mergeGate, tolerance);
                    continue;
                }
                isRight = recomputed.agree(phase, "limit of worse_together", last.limit, 1.6) && isRight;
                if (ofA.size() + ofB.size() > kFew || std::abs(a.normal.dot(b.normal)) < 0.9)
                    continue;
                PlaneSegments both = ofA;
                both.insert(both.end(), ofB.begin(), ofB.end());
                if (!allDirected(both, twin.now.noise))
                    continue;
                const LikeliestPlane together(both, twin.now.noise.pitch, twin.parameters.noise.systematic);
                const auto weigh = [](const Plane& plane) {
                    return std::max(1.0, plane.fittingError) * static_cast<double>(plane.segments.size());
                };
                const double worse = together.meanError() * static_cast<double>(both.size()) / (weigh(a) + weigh(b));
                // One step of the fit does not turn the plane of both as far as those would have it that are metres
                // apart.
                if (worse < 5.0 || last.value < 5.0)
                    isRight = recomputed.agree(phase, "worse_together", last.value, worse, 0.3) && isRight;
                else
                    ++recomputed.counts["much worse together"];
            }
        }
    });
    QVERIFY(isRight);
    QVERIFY(aligned > 20 && recomputed.counts["near_chi2"] > 200 && recomputed.counts["scattered_chi2"] > 100);
    QVERIFY(recomputed.counts["merge_chi2"] > 20);
    QVERIFY(recomputed.counts["worse_together"] + recomputed.counts["much worse together"] > 2);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldWhyNotPreciseTest)
#include "told_why_not_precise_test.moc"
