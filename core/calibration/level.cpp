// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/level.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/calibration/robust_spread.h"
#include "core/types/angle.h"
#include "core/types/square.h"

namespace planewright {

namespace {

constexpr double kMostTilted = degrees(20.0);
/// Planes within this of level or plumb speak for a direction.
constexpr double kNear = degrees(1.0);
/// Of these, planes beyond so many standard deviations are neither.
constexpr double kOutlier = 3.0;
constexpr double kRollBefore = degrees(3.0);
/// A pitch that is known less well is not known.
constexpr double kUseful = degrees(0.5);
/// Walls this far from parallel give a direction by their line of intersection.
constexpr double kApart = degrees(30.0);
constexpr int kRounds = 10;

/// A plane that is level or plumb, but for an angle.
struct Used {
    std::size_t plane;
    bool isLevel;
    double deviation;  // [rad]
    double sigma;      // of its normal [rad]
};

/// Angle by which a plane is neither level nor plumb.
double deviationOf(const Eigen::Vector3d& normal, const Eigen::Vector3d& up, bool& isLevel)
{
    const double along = std::abs(normal.dot(up));
    const double fromPlumb = std::asin(std::min(1.0, along));
    const double fromLevel = std::acos(std::min(1.0, along));
    isLevel = fromLevel < fromPlumb;
    return std::min(fromLevel, fromPlumb);
}

/// Directions that planes propose for up.
std::vector<Eigen::Vector3d> proposals(const std::vector<Eigen::Vector3d>& normals)
{
    std::vector<Eigen::Vector3d> all;
    const auto propose = [&](Eigen::Vector3d up) {
        const double length = up.norm();
        if (length < 1e-9)
            return;
        up /= up.z() < 0.0 ? -length : length;
        if (up.z() >= std::cos(kMostTilted))
            all.push_back(up);
    };
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Eigen::Vector3d& n = normals[i];
        propose(n);
        if (std::abs(n.z()) > std::sin(kMostTilted))
            continue;
        if (std::abs(n.y()) > std::sin(kApart))
            propose({0.0, -n.z(), n.y()});  // the pitch alone makes it plumb
        for (std::size_t j = 0; j < i; ++j) {
            const Eigen::Vector3d line = n.cross(normals[j]);
            if (line.norm() > std::sin(kApart))
                propose(line);
        }
    }
    return all;
}

/// The proposal that most points speak for.
std::optional<Eigen::Vector3d> mostSpokenFor(const SeenPlanes& seen, const std::vector<Eigen::Vector3d>& normals)
{
    std::optional<Eigen::Vector3d> best;
    double most = 0.0;
    for (const Eigen::Vector3d& up : proposals(normals)) {
        double score = 0.0;
        for (std::size_t i = 0; i < normals.size(); ++i) {
            bool isLevel = false;
            const double share = deviationOf(normals[i], up, isLevel) / kNear;
            score += std::sqrt(static_cast<double>(seen.planes[i].points)) * std::max(0.0, 1.0 - share * share);
        }
        if (score > most) {
            most = score;
            best = up;
        }
    }
    return best;
}

/// A least-squares system for up = (x, y, 1), normalised: deviations, their derivatives by x and y and by all planes'
/// tangent angles.
struct System {
    Eigen::VectorXd deviations;
    Eigen::MatrixXd byUp;
    Eigen::MatrixXd byPlanes;
};

System systemOf(const PlanesEstimate& planes, const std::vector<Used>& used, const Eigen::Vector3d& up)
{
    Eigen::Index rows = 0;
    for (const Used& d : used)
        rows += d.isLevel ? 2 : 1;
    System system;
    system.deviations.resize(rows);
    system.byUp.resize(rows, 2);
    system.byPlanes.setZero(rows, planes.covariance.rows());
    Eigen::Index row = 0;
    for (const Used& d : used) {
        const Eigen::Vector3d& n = planes.normals[d.plane];
        const auto& tangents = planes.tangents[d.plane];
        const Eigen::Index column = 3 * static_cast<Eigen::Index>(d.plane);
        if (!d.isLevel) {
            system.deviations[row] = n.dot(up) / up.norm();
            system.byUp.row(row) = n.head<2>().transpose();
            system.byPlanes.block<1, 2>(row, column) = up.transpose() * tangents;
            ++row;
            continue;
        }
        // Level: up less its part along the normal.
        const double side = n.z() < 0.0 ? -1.0 : 1.0;
        for (int axis = 0; axis < 2; ++axis, ++row) {
            system.deviations[row] = up[axis] - n[axis] / n.z();
            system.byUp.row(row) = Eigen::RowVector2d(axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0);
            system.byPlanes.block<1, 2>(row, column) = -side * tangents.row(axis);
        }
    }
    return system;
}

struct Solution {
    Eigen::Vector2d move;
    Eigen::Matrix2d covariance;
    double chi = 0.0;
    int freedom = 0;
};

Solution solve(const System& system, const Eigen::MatrixXd& planes, const Eigen::Vector3d& up, double tolerance)
{
    Eigen::MatrixXd noise = system.byPlanes * planes * system.byPlanes.transpose();
    noise.diagonal().array() += square(tolerance) + 1e-14;
    const Eigen::LDLT<Eigen::MatrixXd> factors(noise);
    Eigen::Matrix2d information = system.byUp.transpose() * factors.solve(system.byUp);
    Eigen::Vector2d gradient = system.byUp.transpose() * factors.solve(system.deviations);
    information(0, 0) += 1.0 / square(kRollBefore);
    gradient[0] += up.x() / square(kRollBefore);
    Solution solution;
    information(1, 1) += 1e-6;
    solution.covariance = information.inverse();
    solution.move = -solution.covariance * gradient;
    const Eigen::VectorXd rest = system.deviations + system.byUp * solution.move;
    solution.chi = rest.dot(factors.solve(rest));
    solution.freedom = static_cast<int>(rest.size()) - 2;
    return solution;
}

/// The planes that are level or plumb but for what is not known of them and for a spread [rad].
std::vector<Used> nearlyLevelOrPlumb(const PlanesEstimate& planes, const Eigen::Vector3d& up, double spread)
{
    std::vector<Used> used;
    for (std::size_t i = 0; i < planes.normals.size(); ++i) {
        Used plane{i, false, 0.0, 0.0};
        const auto place = 3 * static_cast<Eigen::Index>(i);
        plane.sigma = std::sqrt(std::max(planes.covariance(place, place), planes.covariance(place + 1, place + 1)));
        plane.deviation = deviationOf(planes.normals[i], up.normalized(), plane.isLevel);
        if (plane.sigma < kNear && plane.deviation < kOutlier * std::hypot(plane.sigma, spread))
            used.push_back(plane);
    }
    return used;
}

/// By how much planes stray from level and plumb, beside what is not known of them [rad].
double spreadAbout(const Eigen::Vector3d& up, const PlanesEstimate& planes)
{
    std::vector<Deviation> deviations;
    for (const Used& plane : nearlyLevelOrPlumb(planes, up, kNear / kOutlier))
        deviations.push_back({square(plane.deviation), square(plane.sigma)});
    return spreadOf(deviations, kNear);
}

}  // namespace

std::optional<Level> findLevel(const SeenPlanes& seen, const PlanesEstimate& planes, double tolerance)
{
    const std::optional<Eigen::Vector3d> start = mostSpokenFor(seen, planes.normals);
    if (!start)
        return std::nullopt;
    Eigen::Vector3d up = *start / start->z();
    double spread = kNear / kOutlier;
    std::vector<Used> used;
    Solution solution;
    for (int round = 0; round < kRounds; ++round) {
        used = nearlyLevelOrPlumb(planes, up, spread);
        if (used.empty())
            return std::nullopt;
        const System system = systemOf(planes, used, up);
        double allowed = tolerance;
        solution = solve(system, planes.covariance, up, allowed);
        // Where the planes disagree by more than their tolerance, it was too small.
        while (solution.freedom > 0 && solution.chi > solution.freedom && allowed < kNear) {
            allowed = std::max(1.2 * allowed, degrees(0.002));
            solution = solve(system, planes.covariance, up, allowed);
        }
        up += Eigen::Vector3d{solution.move.x(), solution.move.y(), 0.0};
        spread = std::max({tolerance, degrees(0.02), spreadAbout(up, planes)});
    }
    if (std::sqrt(solution.covariance(1, 1)) > kUseful)
        return std::nullopt;
    Level level;
    level.pitch = std::atan2(up.y(), up.z());
    level.roll = std::atan2(up.x(), up.z());
    level.covariance = solution.covariance.reverse();
    for (const Used& plane : used)
        ++(plane.isLevel ? level.levelPlanes : level.plumbPlanes);
    return level;
}

}  // namespace planewright
