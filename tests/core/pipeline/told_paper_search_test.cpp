// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <optional>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "tests/core/pipeline/leaning_runs_twin.h"
#include "tests/core/pipeline/new_plane_twin.h"
#include "tests/core/pipeline/plane_pair_twin.h"
#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A plane that segments of a cluster suggest, grown over those that hang together with the one that suggested it.
class SearchTwin {
public:
    SearchTwin(const ToldPhase& phase, const std::vector<SegmentId>& candidates, const PlaneParameters& parameters)
        : snapshot_(*phase.after),
          log_(phase.after->segments),
          candidates_(candidates),
          p_(parameters),
          runs_(log_, parameters)
    {
    }

    /// The plane of a segment and the two nearest of other slices, or that of the run around it.
    std::optional<FittedPlane> suggestionOf(const SegmentId& seed, bool byRun) const
    {
        if (byRun) {
            const RunTwin::Run run = runs_.around(seed);
            return run.segments.size() < 3 ? std::nullopt : std::optional(run.plane);
        }
        std::vector<std::pair<double, SegmentId>> near;
        const LineSegment& s = log_[seed];
        const double variance = 0.5 * (s.startCovariance.trace() + s.endCovariance.trace());
        for (const SegmentId& id : candidates_) {
            const Eigen::Vector3d away = log_[id].midpoint() - s.midpoint();
            if (id.step != seed.step &&
                away.cross(s.direction).squaredNorm() >= std::pow(p_.baselineSigmas, 2) * variance)
                near.emplace_back(away.norm(), id);
        }
        std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        const auto second = std::find_if(
            near.begin(), near.end(), [&](const auto& other) { return other.second.step != near.front().second.step; });
        if (second == near.end())
            return std::nullopt;
        std::vector<std::pair<Eigen::Vector3d, double>> ends;
        for (const SegmentId& id : {seed, near.front().second, second->second})
            ends.insert(ends.end(), {{log_[id].start, 1.0}, {log_[id].end, 1.0}});
        FittedPlane plane;
        plane.fit(ends);
        return plane;
    }

    /// Takes in what supports the plane and refines it, up to five times.
    Plane grown(const SegmentId& seed, const FittedPlane& suggestion) const
    {
        Plane plane;
        plane.normal = suggestion.normal;
        plane.distance = suggestion.distance;
        for (int round = 0; round < 5; ++round) {
            const std::vector<SegmentId> support = supportOf(plane, seed);
            if (support == plane.segments || support.size() < 3)
                break;
            plane.segments = support;
            refine(plane);
        }
        return plane;
    }

    /// Whether these are the numbers that were told of a plane.
    bool agrees(const std::vector<Test>& tests, const Plane& plane) const
    {
        const auto isTold = [&](std::string_view name, double value, double limit, double relative) {
            const Test& told = testOf(tests, name);
            return std::abs(told.value - value) <= relative * std::max(std::abs(value), 1e-9) &&
                   std::abs(told.limit - limit) <= std::max(relative, 1e-9) * std::abs(limit);
        };
        const auto count = static_cast<double>(plane.segments.size());
        int points = 0;
        for (const SegmentId& id : plane.segments)
            points += log_[id].points;
        if (!isTold("segments", count, p_.minSegments, 0.0) ||
            !isTold("slices", static_cast<double>(slicesOf(plane.segments)), p_.minSlices, 0.0) ||
            !isTold("points", points, p_.minPoints, 0.0))
            return false;
        if (plane.segments.empty())
            return tests.size() == 3;
        // The refinement ends when it gains little, a little before the best plane.
        const Shape shape(plane, snapshot_, p_);
        const double extent =
            std::max(p_.minExtent, shape.range * std::tan(p_.minExtentAngle) * (1.0 - 0.5 * shape.incidence));
        const bool isSame = isTold("extent", shape.extent, extent, 0.01) &&
                            isTold("incidence", shape.incidence, std::sin(p_.minIncidence), 0.01) &&
                            isTold("normal_sigma", std::sqrt(largestAngleVariance(plane)), p_.maxNormalSigma, 0.02) &&
                            isTold("fitting_error", shape.error, p_.errorLimit, 0.01) &&
                            isTold("contradictions", contradictionsOf(plane, candidates_, log_, p_), count, 0.0);
        const bool isAsked =
            std::all_of(tests.begin(), tests.begin() + 8, [](const Test& test) { return test.pass(); });
        return isSame && tests.size() == (isAsked ? 9 : 8) &&
               (!isAsked ||
                isTold("contested", runs_.share(plane.segments, plane.normal, plane.distance), p_.maxContested, 1e-9));
    }

private:
    bool supports(const SegmentId& id, const Plane& plane) const
    {
        const auto isNear = [&](const Eigen::Vector3d& point, const Eigen::Matrix3d& covariance) {
            const double sigma = std::sqrt(plane.normal.dot(covariance * plane.normal));
            return distanceOf(point, plane) < std::max(p_.inlierDistance, p_.inlierSigmas * sigma);
        };
        return isNear(log_[id].start, log_[id].startCovariance) && isNear(log_[id].end, log_[id].endCovariance);
    }

    /// Of all that are near enough those that hang together with the seed, in the order of the cluster.
    std::vector<SegmentId> supportOf(const Plane& plane, const SegmentId& seed) const
    {
        std::vector<SegmentId> near;
        for (const SegmentId& id : candidates_) {
            if (supports(id, plane))
                near.push_back(id);
        }
        if (!holds(near, seed))
            return {};
        std::vector<SegmentId> reached{seed};
        for (std::size_t next = 0; next < reached.size(); ++next) {
            const LineSegment& here = log_[reached[next]];
            for (const SegmentId& id : near) {
                const LineSegment& other = log_[id];
                if (!holds(reached, id) && std::abs(here.id.step - id.step) <= 5 &&
                    (faces(here, other) || distanceOf(here, other) <= p_.mergeGap))
                    reached.push_back(id);
            }
        }
        std::erase_if(near, [&](const SegmentId& id) { return !holds(reached, id); });
        return near;
    }

    /// Distances of the end points in standard deviations, Eq. (16).
    Eigen::VectorXd residualsOf(const Plane& plane, const Eigen::Vector3d& change) const
    {
        const Eigen::Vector3d normal = (plane.normal + plane.tangents * change.head<2>()).normalized();
        Eigen::VectorXd residuals(2 * static_cast<Eigen::Index>(plane.segments.size()));
        Eigen::Index row = 0;
        for (const SegmentId& id : plane.segments) {
            const LineSegment& s = log_[id];
            for (const auto& [end, covariance] :
                 {std::pair{s.start, s.startCovariance}, std::pair{s.end, s.endCovariance}})
                residuals[row++] = (normal.dot(end) - plane.distance - change[2]) /
                                   std::sqrt(normal.dot(covariance * normal) + p_.flatness * p_.flatness + 1e-12);
        }
        return residuals;
    }

    /// Least squares by derivatives in numbers.
    void refine(Plane& plane) const
    {
        Eigen::MatrixXd derivatives(2 * static_cast<Eigen::Index>(plane.segments.size()), 3);
        for (int round = 0; round < p_.refineIterations; ++round) {
            const Eigen::Vector3d first = plane.normal.unitOrthogonal();
            plane.tangents << first, plane.normal.cross(first);
            for (Eigen::Index i = 0; i < 3; ++i) {
                const Eigen::Vector3d little = 1e-6 * Eigen::Vector3d::Unit(i);
                derivatives.col(i) = (residualsOf(plane, little) - residualsOf(plane, -little)) / 2e-6;
            }
            const Eigen::VectorXd residuals = residualsOf(plane, Eigen::Vector3d::Zero());
            Eigen::Vector3d step = -derivatives.colPivHouseholderQr().solve(residuals);
            while (residualsOf(plane, step).squaredNorm() > residuals.squaredNorm() && step.norm() > 1e-12)
                step *= 0.5;
            plane.normal = (plane.normal + plane.tangents * step.head<2>()).normalized();
            plane.distance += step[2];
            if (step.norm() < 1e-9)
                break;
        }
        plane.covariance = (derivatives.transpose() * derivatives).inverse();
    }

    const Snapshot& snapshot_;
    const SegmentLog& log_;
    const std::vector<SegmentId>& candidates_;
    const PlaneParameters& p_;
    RunTwin runs_;
};

}  // namespace

/// Why segments of a cluster gave no plane: what they suggest is in no snapshot, and is searched for once more.
class ToldPaperSearchTest : public QObject {
    Q_OBJECT

private slots:
    void suggestionsFailForTheNumbersThatAreTold();
};

void ToldPaperSearchTest::suggestionsFailForTheNumbersThatAreTold()
{
    int suggestions = 0;
    int same = 0;
    const auto compare = [&](const ToldScan& scan, const ToldPhase& phase) {
        std::vector<SegmentId> taken;  // by planes that the phase made before
        for (const Decision& decision : phase.decisions()) {
            if (decision.kind == DecisionKind::Fit) {
                const Plane& plane = *planeIn(*phase.after, planeOf(decision.result[0]));
                taken.insert(taken.end(), plane.segments.begin(), plane.segments.end());
            }
            if (decision.kind != DecisionKind::NoFit || decision.operands.size() < 2)
                continue;
            std::vector<SegmentId> candidates = clusterIn(*phase.before, clusterOf(decision.operands[0]))->segments;
            std::erase_if(candidates, [&](const SegmentId& segment) { return holds(taken, segment); });
            const SearchTwin twin(phase, candidates, scan.parameters.planes);
            const SegmentId seed = segmentOf(decision.operands[1]);
            const auto agrees = [&](bool byRun) {
                const auto suggestion = twin.suggestionOf(seed, byRun);
                return suggestion && twin.agrees(decision.tests, twin.grown(seed, *suggestion));
            };
            ++suggestions;
            same += agrees(false) || agrees(true) ? 1 : 0;
        }
    };
    for (const char* scene : {"corridor", "office", "stairs", "clutter", "hall", "curved"}) {
        for (const std::uint64_t seed : {3U, 4U, 5U}) {
            const ToldScan scan("paper", scene, seed);
            for (const ToldPhase& phase : scan.phases)
                compare(scan, phase);
        }
    }
    // A plane of few segments that lies almost in their slices is still on its way when its refinement ends.
    QVERIFY2(suggestions > 300 && 10 * same > 9 * suggestions,
             qPrintable(QString("%1 of %2").arg(same).arg(suggestions)));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldPaperSearchTest)
#include "told_paper_search_test.moc"
