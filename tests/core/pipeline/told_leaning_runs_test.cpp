// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <numeric>

#include "tests/core/pipeline/likelihood_twin.h"
#include "tests/core/pipeline/neighbour_slices.h"
#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// −2 ln of the likelihood of a segment's range for a plane, but for a constant: no segment speaks louder than 16.
double surpriseOf(const LineSegment& s, const Eigen::Vector3d& normal, double distance, double pitch, double floor)
{
    const double steepness = steepnessOf(s, normal);
    const double residual = normal.dot(s.moments.mean) - distance;
    const double variance = (s.placeSigma * s.placeSigma + floor * floor) * steepness +
                            std::pow(pitch * normal.dot(turned(s.moments.mean)), 2);
    return std::min(residual * residual / variance, 16.0) + std::log(variance / steepness);
}

/// Runs of three segments, each the one of the nearest slice that shares most beams with the one before it.
class RunsOf {
public:
    RunsOf(const ToldScan& scan, const ToldPhase& phase)
        : parameters_(scan.parameters),
          noise_(phase.after->noise),
          log_(phase.after->segments),
          neighbours_(scan.recording, log_)
    {
    }

    /// By how much a plane of its own explains the segments of a plane on a run better.
    double gainOf(const PlaneSegments& run, const Plane& whole) const
    {
        const LikeliestPlane own(run, noise_.pitch, parameters_.noise.systematic);
        double gain = 0.0;
        for (const LineSegment* s : run) {
            if (holds(whole.segments, s->id))
                gain += surprise(*s, whole.normal, whole.distance) - surprise(*s, own.normal, own.distance);
        }
        return gain;
    }

    /// Share of a plane's points that are on runs which lean out of it.
    double shareOf(const Plane& whole) const
    {
        std::set<SegmentId> on;
        const auto ask = [&](const LineSegment* first) {
            const PlaneSegments run = runFrom(first);
            if (run.size() < 3 || !leansOut(run, whole))
                return;
            for (const LineSegment* s : run) {
                if (holds(whole.segments, s->id))
                    on.insert(s->id);
            }
        };
        for (const SegmentId& id : whole.segments) {
            ask(&log_[id]);
            const LineSegment* before = next(log_[id], -1);
            if (before != nullptr && !holds(whole.segments, before->id))
                ask(before);
        }
        return pointsOf(on) / static_cast<double>(whole.points);
    }

    template <class Ids>
    double pointsOf(const Ids& ids) const
    {
        return std::accumulate(ids.begin(), ids.end(), 0.0,
                               [this](double sum, const SegmentId& id) { return sum + log_[id].points; });
    }

private:
    const LineSegment* next(const LineSegment& from, int direction) const
    {
        const int place = neighbours_.placeOf(from);
        for (int away = 1; away <= neighbours_.reach(place, direction); ++away) {
            const LineSegment* found = nullptr;
            int most = 0;
            for (const LineSegment& other : log_.slice(static_cast<std::size_t>(place + direction * away))) {
                const int shared =
                    std::min(from.lastBeam, other.lastBeam) - std::max(from.firstBeam, other.firstBeam) + 1;
                if (shared > most) {
                    most = shared;
                    found = &other;
                }
            }
            if (found != nullptr)
                return found;
        }
        return nullptr;
    }

    PlaneSegments runFrom(const LineSegment* first) const
    {
        PlaneSegments run;
        for (const LineSegment* s = first; s != nullptr && run.size() < 3; s = next(*s, 1))
            run.push_back(s);
        return run;
    }

    /// Two of its segments are the plane's; it turns out of it by more than it is told to and by three standard
    /// deviations, from first to last as on the whole; and its own plane explains it better by χ² > 9.
    bool leansOut(const PlaneSegments& run, const Plane& whole) const
    {
        const auto own =
            std::count_if(run.begin(), run.end(), [&](const LineSegment* s) { return holds(whole.segments, s->id); });
        const Eigen::Vector3d along = run.front()->direction;
        const Eigen::Vector3d chord = run.back()->moments.mean - run.front()->moments.mean;
        const Eigen::Vector3d across = chord - chord.dot(along) * along;
        const double least = parameters_.planes.runLean;
        if (own < 2 || std::abs(whole.normal.dot(across)) <= std::sin(least) * across.norm())
            return false;
        const LikeliestPlane plane(run, noise_.pitch, parameters_.noise.systematic);
        const double lean = std::acos(std::min(1.0, std::abs(plane.normal.dot(whole.normal))));
        return plane.chi <= 4.0 * parameters_.likelihood.seedGate &&
               lean >= std::max(least, 3.0 * std::sqrt(plane.normalVariance())) && gainOf(run, whole) > 9.0;
    }

    double surprise(const LineSegment& s, const Eigen::Vector3d& normal, double distance) const
    {
        return surpriseOf(s, normal, distance, noise_.pitch, parameters_.noise.systematic);
    }

    const Parameters& parameters_;
    SensorNoise noise_;
    const SegmentLog& log_;
    NeighbourSlices neighbours_;
};

}  // namespace

/// Planes of `precise` are taken apart for runs that lean out of them: rare, and found in clutter.
class ToldLeaningRunsTest : public QObject {
    Q_OBJECT

private slots:
    void planesAreTakenApartForRunsThatLeanOut();
};

void ToldLeaningRunsTest::planesAreTakenApartForRunsThatLeanOut()
{
    Recomputed recomputed;
    int closely = 0;
    for (const std::uint64_t seed : {5U, 18U, 21U, 25U, 27U}) {
        const ToldScan scan("precise", "clutter", seed);
        std::map<SegmentId, Eigen::Vector3d> remainsOf;  // by segment the normal of the plane that was taken apart last
        for (const ToldPhase& phase : scan.phases) {
            if (phase.pass != "split_contested")
                continue;
            const RunsOf runs(scan, phase);
            std::vector<const Plane*> contested;
            for (const Decision& decision : phase.decisions()) {
                const Test& told = decision.tests.front();
                if (decision.kind == DecisionKind::Split) {
                    const Plane& plane = *planeIn(*phase.before, planeOf(decision.operands[0]));
                    if (told.name == "contested_share") {
                        QVERIFY(
                            recomputed.agree(phase, told, runs.shareOf(plane), scan.parameters.planes.maxContested));
                        contested.push_back(&plane);
                        continue;
                    }
                    std::vector<SegmentId> like;
                    for (const SegmentId& id : plane.segments) {
                        const auto before = remainsOf.find(id);
                        if (before != remainsOf.end() &&
                            std::abs(before->second.dot(plane.normal)) > std::cos(scan.parameters.planes.runLean))
                            like.push_back(id);
                    }
                    QVERIFY(
                        recomputed.agree(phase, told, runs.pointsOf(like) / static_cast<double>(plane.points), 0.5));
                }
                if (decision.kind != DecisionKind::Fit || told.name != "run_gain")
                    continue;
                const PlaneSegments run = segmentsOf(decision.operands, phase.after->segments);
                // It leans out of the plane that most of it belonged to.
                const auto whole = std::find_if(contested.begin(), contested.end(), [&](const Plane* plane) {
                    return std::count_if(run.begin(), run.end(),
                                         [&](const LineSegment* s) { return holds(plane->segments, s->id); }) >= 2;
                });
                QVERIFY2(whole != contested.end(), phase.text().c_str());
                // The run's own plane ends up to a degree from where it was linearised, which seldom tells.
                const double gain = runs.gainOf(run, **whole);
                QVERIFY(recomputed.agree(phase, told, gain, 9.0, 0.15));
                closely += std::abs(gain - told.value) < 0.01 * gain ? 1 : 0;
            }
            for (const Plane* plane : contested) {
                for (const SegmentId& id : plane->segments)
                    remainsOf[id] = plane->normal;
            }
        }
    }
    QVERIFY(recomputed.counts["contested_share"] >= 5);
    QVERIFY(recomputed.counts["contested_remains"] >= 2);
    QVERIFY(closely >= 4);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldLeaningRunsTest)
#include "told_leaning_runs_test.moc"
