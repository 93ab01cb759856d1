// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <limits>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "tests/core/pipeline/told_step.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// The plane of least squares through weighted points, by the smallest eigenvector of their scatter.
struct FittedPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;

    void fit(const std::vector<std::pair<Eigen::Vector3d, double>>& points)
    {
        double weight = 0.0;
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const auto& [point, w] : points) {
            weight += w;
            mean += w * point;
        }
        mean /= weight;
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        for (const auto& [point, w] : points)
            scatter += w * (point - mean) * (point - mean).transpose();
        normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
        distance = normal.dot(mean);
    }
    double strayOf(const LineSegment& s) const
    {
        return std::max(std::abs(normal.dot(s.start) - distance), std::abs(normal.dot(s.end) - distance));
    }
};

/// Where a segment is met by a beam, as its ends say.
Eigen::Vector3d pointAt(double beam, const LineSegment& s)
{
    const double part = (beam - s.firstBeam) / (s.lastBeam - s.firstBeam);
    return (1.0 - part) * s.start + part * s.end;
}

/// The middle of the beams that two segments share.
double middleOf(const LineSegment& a, const LineSegment& b)
{
    return 0.5 * (std::max(a.firstBeam, b.firstBeam) + std::min(a.lastBeam, b.lastBeam));
}

int overlapOf(const LineSegment& a, const LineSegment& b)
{
    return std::min(a.lastBeam, b.lastBeam) - std::max(a.firstBeam, b.firstBeam);
}

/// What leads from slice to slice: segments of one surface, in steps no longer than `run-step`, over five slices each
/// way, cut shorter until it is flat.
class RunTwin {
public:
    RunTwin(const SegmentLog& log, const PlaneParameters& parameters) : log_(log), p_(parameters) {}

    /// Whether the run around a segment leans out of a plane and is explained better by its own, by χ² > 9.
    bool contests(const SegmentId& id, const Eigen::Vector3d& normal, double distance) const
    {
        if (!leadsOut(log_[id], normal, -1) && !leadsOut(log_[id], normal, 1))
            return false;
        std::vector<const LineSegment*> run = follow(log_[id], -1);
        std::reverse(run.begin(), run.end());
        run.push_back(&log_[id]);
        const std::vector<const LineSegment*> later = follow(log_[id], 1);
        run.insert(run.end(), later.begin(), later.end());
        FittedPlane own;
        while (run.size() >= 3) {
            std::vector<std::pair<Eigen::Vector3d, double>> ends;
            for (const LineSegment* s : run)
                ends.insert(ends.end(), {{s->start, 1.0}, {s->end, 1.0}});
            own.fit(ends);
            if (std::all_of(run.begin(), run.end(),
                            [&](const LineSegment* s) { return own.strayOf(*s) <= p_.inlierDistance; }))
                break;
            const bool keepsLast = run.back()->id == id;
            const bool keepsFirst = run.front()->id == id;
            if (keepsLast || (!keepsFirst && own.strayOf(*run.front()) > own.strayOf(*run.back())))
                run.erase(run.begin());
            else
                run.pop_back();
        }
        if (run.size() < 3 || std::abs(own.normal.dot(normal)) > std::cos(p_.runLean))
            return false;
        double gain = 0.0;
        for (const LineSegment* s : run)
            gain += surprise(*s, normal, distance) - surprise(*s, own.normal, own.distance);
        return gain > 9.0;
    }

    /// Share of a plane's segments that contest it, asked of a dozen spread over it.
    double share(const std::vector<SegmentId>& members, const Eigen::Vector3d& normal, double distance) const
    {
        double asked = 0.0;
        double contested = 0.0;
        for (std::size_t i = 0; i < members.size(); i += members.size() / 12 + 1) {
            asked += 1.0;
            contested += contests(members[i], normal, distance) ? 1.0 : 0.0;
        }
        return contested / asked;
    }

private:
    /// Whether a step to one of the segments around leads out of a plane by more than T, before one that is far.
    bool leadsOut(const LineSegment& from, const Eigen::Vector3d& normal, int direction) const
    {
        for (int away = 1; away <= 5; ++away) {
            const std::size_t place = log_.find(from.id.step + direction * away);
            if (place == log_.slices())
                continue;
            Segments segments = log_.slice(place);
            if (direction < 0)
                std::reverse(segments.begin(), segments.end());
            for (const LineSegment& other : segments) {
                if (overlapOf(from, other) <= 0)
                    continue;
                if (stepTo(from, other) > p_.runStep)
                    return false;
                const double middle = middleOf(from, other);
                if (std::abs(normal.dot(pointAt(middle, other) - pointAt(middle, from))) > p_.inlierDistance)
                    return true;
            }
        }
        return false;
    }

    std::vector<const LineSegment*> follow(const LineSegment& from, int direction) const
    {
        std::vector<const LineSegment*> run;
        const LineSegment* here = &from;
        for (int step = from.id.step + direction;
             std::abs(step - from.id.step) <= 5 && std::abs(step - here->id.step) <= 2; step += direction) {
            const std::size_t place = log_.find(step);
            if (place == log_.slices())
                continue;
            const LineSegment* next = nullptr;
            int most = 0;
            for (const LineSegment& other : log_.slice(place)) {
                const int shared = std::min(overlapOf(from, other), overlapOf(*here, other));
                // Of those that share as much the one that lies nearer in the order of time.
                const bool isMore = direction > 0 ? shared > most : shared >= most;
                if (shared > 0 && isMore && stepTo(*here, other) <= p_.runStep) {
                    most = shared;
                    next = &other;
                }
            }
            if (next != nullptr) {
                run.push_back(next);
                here = next;
            }
        }
        return run;
    }

    /// How far a segment is from another across it, at the middle of the beams that both share.
    static double stepTo(const LineSegment& from, const LineSegment& to)
    {
        const double middle = middleOf(from, to);
        return (pointAt(middle, to) - pointAt(middle, from)).cross(from.direction).norm();
    }

    /// −2 ln of the likelihood of the range of a segment's middle, but for a constant.
    double surprise(const LineSegment& s, const Eigen::Vector3d& normal, double distance) const
    {
        const Eigen::Vector3d middle = 0.5 * (s.start + s.end);
        const double residual = normal.dot(middle) - distance;
        const Eigen::Matrix3d covariance = 0.5 * (s.startCovariance + s.endCovariance);
        const double variance = normal.dot(covariance * normal) + p_.flatness * p_.flatness;
        const double incidence = std::max(1e-3, std::abs(normal.dot((middle - s.viewpoint).normalized())));
        return std::min(16.0, residual * residual / variance) + std::log(variance) - 2.0 * std::log(incidence);
    }

    const SegmentLog& log_;
    const PlaneParameters& p_;
};

/// Smallest distance between two segments: it is convex along the first, where it is looked for.
double distanceOf(const LineSegment& a, const LineSegment& b)
{
    const auto fromB = [&](double t) {
        const Eigen::Vector3d point = (1.0 - t) * a.start + t * a.end;
        const Eigen::Vector3d along = b.end - b.start;
        const double part = std::clamp(along.dot(point - b.start) / along.squaredNorm(), 0.0, 1.0);
        return (point - b.start - part * along).norm();
    };
    double low = 0.0;
    double high = 1.0;
    for (int round = 0; round < 100; ++round) {
        const double left = low + (high - low) / 3.0;
        const double right = high - (high - low) / 3.0;
        (fromB(left) < fromB(right) ? high : low) = fromB(left) < fromB(right) ? right : left;
    }
    return fromB(0.5 * (low + high));
}

bool faces(const LineSegment& a, const LineSegment& b)
{
    if (std::abs(a.id.step - b.id.step) > 5)
        return false;
    if (a.firstBeam > b.firstBeam)
        return faces(b, a);
    return b.firstBeam <= a.lastBeam || (a.endShadowed && b.startShadowed);
}

/// Gap of two planes: none where segments face each other; where boxes along the axes are farther apart than asked for,
/// that of the boxes, which it is at least; otherwise that of the nearest two segments.
double gapOf(const std::vector<SegmentId>& a, const std::vector<SegmentId>& b, const SegmentLog& log, double enough)
{
    for (const SegmentId& i : a) {
        for (const SegmentId& j : b) {
            if (faces(log[i], log[j]))
                return 0.0;
        }
    }
    const auto boxOf = [&](const std::vector<SegmentId>& ids) {
        Eigen::AlignedBox3d box;
        for (const SegmentId& id : ids)
            box.extend(log[id].start).extend(log[id].end);
        return box;
    };
    const double apart = boxOf(a).exteriorDistance(boxOf(b));
    if (apart > enough)
        return apart;
    double least = kEndless;
    for (const SegmentId& i : a) {
        for (const SegmentId& j : b)
            least = std::min(least, distanceOf(log[i], log[j]));
    }
    return least;
}

/// The plane of two and the larger of their errors against it: each end weighs by its variance across its own plane.
struct TogetherTwin {
    FittedPlane plane;
    double error = 0.0;

    TogetherTwin(const Plane& a, const Plane& b, const SegmentLog& log, const PlaneParameters& p)
    {
        std::vector<std::pair<Eigen::Vector3d, double>> all;
        std::array<std::vector<std::pair<Eigen::Vector3d, double>>, 2> own;
        for (const Plane* of : {&a, &b}) {
            for (const SegmentId& id : of->segments) {
                const LineSegment& s = log[id];
                const auto weigh = [&](const Eigen::Matrix3d& covariance) {
                    return 1.0 / (of->normal.dot(covariance * of->normal) + p.flatness * p.flatness + 1e-12);
                };
                own[of == &a ? 0 : 1].emplace_back(s.start, weigh(s.startCovariance));
                own[of == &a ? 0 : 1].emplace_back(s.end, weigh(s.endCovariance));
            }
        }
        for (const auto& points : own)
            all.insert(all.end(), points.begin(), points.end());
        plane.fit(all);
        for (const auto& points : own) {
            double sum = 0.0;
            for (const auto& [point, weight] : points)
                sum += weight * std::pow(plane.normal.dot(point) - plane.distance, 2);
            error = std::max(error, sum / static_cast<double>(points.size()));
        }
    }
};

}  // namespace

/// What `paper` says of runs that lean out of planes, and of gaps between them, worked out anew from segments.
class ToldPaperRunsTest : public QObject {
    Q_OBJECT

private slots:
    void planesAreContestedByTheRunsOnThem_data() { scenes(); }
    void planesAreContestedByTheRunsOnThem();
    void segmentsThatLeanOutAreOfSuchRuns_data() { scenes(); }
    void segmentsThatLeanOutAreOfSuchRuns();
    void pairsAreAsFarApartAsTold_data() { scenes(); }
    void pairsAreAsFarApartAsTold();

private:
    static void scenes()
    {
        QTest::addColumn<QString>("scene");
        for (const char* scene : {"corridor", "office", "stairs", "clutter", "hall", "curved"})
            QTest::newRow(scene) << scene;
    }
};

void ToldPaperRunsTest::planesAreContestedByTheRunsOnThem()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    const PlaneParameters& p = scan.parameters.planes;
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        const RunTwin runs(phase.after->segments, p);
        for (const Decision& decision : phase.decisions()) {
            const Plane* plane = nullptr;
            if (decision.kind == DecisionKind::Fit)
                plane = planeIn(*phase.after, planeOf(decision.result[0]));
            if (decision.kind == DecisionKind::Split && decision.tests.front().name == "contested")
                plane = planeIn(*phase.before, planeOf(decision.operands[0]));
            if (plane == nullptr)
                continue;
            const Test& told = testOf(decision.tests, "contested");
            QVERIFY(recomputed.agree(phase, told, runs.share(plane->segments, plane->normal, plane->distance),
                                     p.maxContested));
        }
    }
    QVERIFY(recomputed.counts["contested"] > 4);
}

void ToldPaperRunsTest::segmentsThatLeanOutAreOfSuchRuns()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        if (phase.phase != Phase::Assign)
            continue;
        const RunTwin runs(phase.after->segments, scan.parameters.planes);
        for (const Decision& decision : phase.decisions()) {
            if (decision.kind != DecisionKind::Reject || decision.tests.empty() ||
                decision.tests.front().name != "contested")
                continue;
            const Plane& plane = *planeIn(*phase.before, planeOf(decision.operands[1]));
            const SegmentId segment = segmentOf(decision.operands[0]);
            const bool leans = plane.segments.size() < 100 && runs.contests(segment, plane.normal, plane.distance);
            QVERIFY(recomputed.agree(phase, decision.tests.front(), leans ? 1.0 : 0.0, 0.0));
        }
        // And one that joined a young plane is of none.
        for (const Decision& decision : phase.decisions()) {
            if (decision.kind != DecisionKind::Assign)
                continue;
            const Plane& plane = *planeIn(*phase.before, planeOf(decision.operands[1]));
            if (plane.segments.size() < 90 && plane.revision == planeIn(*phase.after, plane.id)->revision - 1) {
                QVERIFY2(!runs.contests(segmentOf(decision.operands[0]), plane.normal, plane.distance),
                         phase.text().c_str());
                ++recomputed.counts["joined"];
            }
        }
    }
    QVERIFY(recomputed.counts["joined"] > 20);
}

void ToldPaperRunsTest::pairsAreAsFarApartAsTold()
{
    QFETCH(QString, scene);
    const ToldScan scan("paper", scene.toStdString(), 3);
    const PlaneParameters& p = scan.parameters.planes;
    Recomputed recomputed;
    for (const ToldPhase& phase : scan.phases) {
        const SegmentLog& log = phase.after->segments;
        const RunTwin runs(log, p);
        std::set<PlaneId> changed;
        for (const Decision& decision : phase.decisions()) {
            const auto asBefore = [&](const Operand& operand) -> const Plane* {
                return changed.contains(planeOf(operand)) ? nullptr : planeIn(*phase.before, planeOf(operand));
            };
            const bool isPair = decision.kind == DecisionKind::Merge || decision.kind == DecisionKind::Near;
            if (isPair && asBefore(decision.operands[0]) != nullptr && asBefore(decision.operands[1]) != nullptr) {
                const Plane& a = *asBefore(decision.operands[0]);
                const Plane& b = *asBefore(decision.operands[1]);
                // The larger takes in the smaller one where that fits it, or both are held against the plane of both.
                const bool isTakenIn = decision.tests.front().name == "shared_segments";
                const Test& gap = testOf(decision.tests, "in_plane_gap");
                QVERIFY(recomputed.agree(phase, gap, gapOf(a.segments, b.segments, log, p.mergeGap), p.mergeGap, 1e-6));
                const TogetherTwin together(a, b, log, p);
                if (!isTakenIn) {
                    QVERIFY(recomputed.agree(phase, testOf(decision.tests, "fitting_error"), together.error,
                                             p.errorLimit, 0.002));
                }
                const auto told = std::find_if(decision.tests.begin(), decision.tests.end(),
                                               [](const Test& test) { return test.name == "contested"; });
                if (told != decision.tests.end()) {
                    const double share =
                        isTakenIn ? runs.share(b.segments, a.normal, a.distance)
                                  : std::max(runs.share(a.segments, together.plane.normal, together.plane.distance),
                                             runs.share(b.segments, together.plane.normal, together.plane.distance));
                    QVERIFY(recomputed.agree(phase, *told, share, p.maxContested));
                }
            }
            if (decision.kind == DecisionKind::Merge || decision.kind == DecisionKind::Split) {
                for (const Operand& operand : decision.operands)
                    changed.insert(planeOf(operand));
                for (const Operand& result : decision.result)
                    changed.insert(planeOf(result));
            }
        }
    }
    if (scene == "curved")
        QVERIFY(recomputed.counts["in_plane_gap"] > 20 && recomputed.counts["contested"] > 3);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ToldPaperRunsTest)
#include "told_paper_runs_test.moc"
