// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/segment_run.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <Eigen/Geometry>

#include "core/planes/neighbourhood.h"
#include "core/planes/plane_fit.h"

namespace planewright {

namespace {

constexpr std::size_t kFewestOfRun = 3;

/// By how much a plane of its own may explain a run better by chance: χ² of three degrees of freedom at 97 %.
constexpr double kChance = 9.0;

/// Segments of a plane that are asked at most.
constexpr std::size_t kAsked = 12;

int sharedBeams(const LineSegment& a, const LineSegment& b)
{
    return std::min(a.lastBeam, b.lastBeam) - std::max(a.firstBeam, b.firstBeam);
}

Eigen::Vector3d pointAt(double beam, const LineSegment& segment)
{
    const double part = (beam - segment.firstBeam) / (segment.lastBeam - segment.firstBeam);
    return segment.start + part * (segment.end - segment.start);
}

/// Distance of two segments across the first, in the middle of the beams that both share.
double stepBetween(const LineSegment& a, const LineSegment& b)
{
    const double beam = 0.5 * (std::max(a.firstBeam, b.firstBeam) + std::min(a.lastBeam, b.lastBeam));
    return (pointAt(beam, b) - pointAt(beam, a)).cross(a.direction).norm();
}

/// Adds what follows a segment in one direction of time.
void follow(SegmentNumber seed, int direction, const SegmentTable& table, double longest,
            std::vector<SegmentNumber>& run)
{
    const LineSegment& from = table[seed];
    SegmentNumber here = seed;
    SegmentNumber next = seed;  // the best of the slice that is looked at
    int most = 0;
    for (SegmentNumber i = seed + direction; i >= 0 && i < table.size(); i += direction) {
        const LineSegment& other = table[i];
        if (next != here && other.id.step != table[next].id.step) {
            run.push_back(next);
            here = next;
            most = 0;
        }
        if (std::abs(other.id.step - from.id.step) > kNeighbourSlices ||
            std::abs(other.id.step - table[here].id.step) > 2)
            break;
        const int shared = std::min(sharedBeams(from, other), sharedBeams(table[here], other));
        if (other.id.step != table[here].id.step && shared > most && stepBetween(table[here], other) <= longest) {
            next = i;
            most = shared;
        }
    }
    if (next != here)
        run.push_back(next);
}

void fitTo(SegmentRun& run, const SegmentTable& table)
{
    WeightedSums sums;
    for (const SegmentNumber i : run.segments) {
        sums.add(table[i].start, 1.0);
        sums.add(table[i].end, 1.0);
    }
    const PlaneFit fit = fitPlane(sums, Eigen::Vector3d::UnitZ());
    run.normal = fit.normal;
    run.distance = fit.distance;
}

/// How far the farther end point of a segment is from the plane of a run.
double strayOf(const SegmentRun& run, const LineSegment& segment)
{
    return std::max(std::abs(run.normal.dot(segment.start) - run.distance),
                    std::abs(run.normal.dot(segment.end) - run.distance));
}

bool isFlat(const SegmentRun& run, const SegmentTable& table, double limit)
{
    return std::all_of(run.segments.begin(), run.segments.end(),
                       [&](SegmentNumber i) { return strayOf(run, table[i]) <= limit; });
}

/// −2 ln of the likelihood of a segment's range, but for a constant.
double surprise(const LineSegment& segment, const Eigen::Vector3d& normal, double distance,
                const PlaneParameters& parameters)
{
    const Eigen::Vector3d point = segment.midpoint();
    const Eigen::Vector3d ray = (point - segment.viewpoint).normalized();
    const double residual = normal.dot(point) - distance;
    const double variance =
        0.5 * (normal.dot(segment.startCovariance * normal) + normal.dot(segment.endCovariance * normal)) +
        parameters.flatness * parameters.flatness;
    const double incidence = std::max(std::abs(normal.dot(ray)), 1e-3);
    return std::min(residual * residual / variance, 16.0) + std::log(variance / (incidence * incidence));
}

/// Whether the step to one of the nearest segments leads out of a plane: a cheap question that most segments deny.
bool mayLean(SegmentNumber segment, const Eigen::Vector3d& normal, const SegmentTable& table,
             const PlaneParameters& parameters)
{
    const LineSegment& from = table[segment];
    for (const int direction : {-1, 1}) {
        for (SegmentNumber i = segment + direction; i >= 0 && i < table.size(); i += direction) {
            const LineSegment& other = table[i];
            if (std::abs(other.id.step - from.id.step) > kNeighbourSlices)
                break;
            if (other.id.step == from.id.step || sharedBeams(from, other) <= 0)
                continue;
            const double beam =
                0.5 * (std::max(from.firstBeam, other.firstBeam) + std::min(from.lastBeam, other.lastBeam));
            const Eigen::Vector3d step = pointAt(beam, other) - pointAt(beam, from);
            const double across = step.cross(from.direction).norm();
            if (across > parameters.runStep)
                break;
            if (std::abs(normal.dot(step)) > parameters.inlierDistance)
                return true;
        }
    }
    return false;
}

}  // namespace

std::optional<SegmentRun> runAround(SegmentNumber segment, const SegmentTable& table, const PlaneParameters& parameters)
{
    SegmentRun run;
    run.segments.push_back(segment);
    follow(segment, -1, table, parameters.runStep, run.segments);
    follow(segment, 1, table, parameters.runStep, run.segments);
    std::sort(run.segments.begin(), run.segments.end());
    while (run.segments.size() >= kFewestOfRun) {
        fitTo(run, table);
        if (isFlat(run, table, parameters.inlierDistance))
            return run;
        // A corner is cut off at the end that strays more.
        const bool cutsFirst = run.segments.back() == segment ||
                               (run.segments.front() != segment &&
                                strayOf(run, table[run.segments.front()]) > strayOf(run, table[run.segments.back()]));
        run.segments.erase(cutsFirst ? run.segments.begin() : run.segments.end() - 1);
    }
    return std::nullopt;
}

bool isContested(SegmentNumber segment, const Eigen::Vector3d& normal, double distance, const SegmentTable& table,
                 const PlaneParameters& parameters)
{
    if (!mayLean(segment, normal, table, parameters))
        return false;
    const auto run = runAround(segment, table, parameters);
    if (!run || std::abs(run->normal.dot(normal)) > std::cos(parameters.runLean))
        return false;
    double gain = 0.0;
    for (const SegmentNumber i : run->segments)
        gain += surprise(table[i], normal, distance, parameters) -
                surprise(table[i], run->normal, run->distance, parameters);
    return gain > kChance;
}

double contestedShare(const std::vector<SegmentNumber>& members, const Eigen::Vector3d& normal, double distance,
                      const SegmentTable& table, const PlaneParameters& parameters)
{
    const std::size_t stride = members.size() / kAsked + 1;
    int contested = 0;
    int asked = 0;
    for (std::size_t i = 0; i < members.size(); i += stride) {
        ++asked;
        contested += isContested(members[i], normal, distance, table, parameters) ? 1 : 0;
    }
    return asked == 0 ? 0.0 : static_cast<double>(contested) / static_cast<double>(asked);
}

}  // namespace planewright
