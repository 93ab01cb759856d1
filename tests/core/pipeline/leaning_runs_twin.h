// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/params/parameters.h"
#include "core/types/segment_log.h"

namespace planewright {

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
inline Eigen::Vector3d pointAt(double beam, const LineSegment& s)
{
    const double part = (beam - s.firstBeam) / (s.lastBeam - s.firstBeam);
    return (1.0 - part) * s.start + part * s.end;
}

/// The middle of the beams that two segments share.
inline double middleOf(const LineSegment& a, const LineSegment& b)
{
    return 0.5 * (std::max(a.firstBeam, b.firstBeam) + std::min(a.lastBeam, b.lastBeam));
}

inline int overlapOf(const LineSegment& a, const LineSegment& b)
{
    return std::min(a.lastBeam, b.lastBeam) - std::max(a.firstBeam, b.firstBeam);
}

/// What leads from slice to slice: segments of one surface, in steps no longer than `run-step`, over five slices each
/// way, cut shorter until it is flat.
class RunTwin {
public:
    RunTwin(const SegmentLog& log, const PlaneParameters& parameters) : log_(log), p_(parameters) {}

    /// A run and its plane.
    struct Run {
        std::vector<const LineSegment*> segments;
        FittedPlane plane;
    };

    /// The run around a segment; it has fewer than three segments where there is none.
    Run around(const SegmentId& id) const
    {
        Run found;
        std::vector<const LineSegment*>& run = found.segments;
        run = follow(log_[id], -1);
        std::reverse(run.begin(), run.end());
        run.push_back(&log_[id]);
        const std::vector<const LineSegment*> later = follow(log_[id], 1);
        run.insert(run.end(), later.begin(), later.end());
        while (run.size() >= 3) {
            std::vector<std::pair<Eigen::Vector3d, double>> ends;
            for (const LineSegment* s : run)
                ends.insert(ends.end(), {{s->start, 1.0}, {s->end, 1.0}});
            found.plane.fit(ends);
            if (std::all_of(run.begin(), run.end(),
                            [&](const LineSegment* s) { return found.plane.strayOf(*s) <= p_.inlierDistance; }))
                break;
            const bool keepsLast = run.back()->id == id;
            const bool keepsFirst = run.front()->id == id;
            if (keepsLast || (!keepsFirst && found.plane.strayOf(*run.front()) > found.plane.strayOf(*run.back())))
                run.erase(run.begin());
            else
                run.pop_back();
        }
        return found;
    }

    /// Whether the run around a segment leans out of a plane and is explained better by its own, by χ² > 9.
    bool contests(const SegmentId& id, const Eigen::Vector3d& normal, double distance) const
    {
        if (!leadsOut(log_[id], normal, -1) && !leadsOut(log_[id], normal, 1))
            return false;
        const auto [run, own] = around(id);
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

}  // namespace planewright
