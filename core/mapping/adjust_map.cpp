// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/mapping/adjust_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/product_manifold.h>
#include <ceres/solver.h>
#include <ceres/sphere_manifold.h>

#include "core/geometry/tangents.h"

namespace planewright {

namespace {

using PoseBlock = std::array<double, 7>;   // rotation x, y, z, w; translation
using PlaneBlock = std::array<double, 4>;  // normal; distance

constexpr std::size_t kMostOtherSightings = 32;

template <int N>
using Square = Eigen::Matrix<double, N, N>;

/// W with W'W = C⁻¹: residuals in their standard deviations.
template <int N>
Square<N> whitening(const Square<N>& covariance)
{
    return covariance.llt().matrixL().solve(Square<N>::Identity());
}

/// A plane of the map against what a stop saw of it, in the stop's frame.
struct SightingResidual {
    Eigen::Matrix<double, 2, 3> across;
    Eigen::Vector3d middle;  ///< of what was seen: angles and the distance from there are nearly independent
    double distance;
    Eigen::Matrix3d weight;

    explicit SightingResidual(const ObservedPlane& plane) : middle(middleOf(plane))
    {
        const UncertainPlane seen = seenFrom(plane.parameters, middle);
        across = seen.tangents.transpose();
        distance = seen.distance;
        weight = whitening<3>(seen.covariance);
    }

    template <class T>
    bool operator()(const T* pose, const T* plane, T* residual) const
    {
        const Eigen::Map<const Eigen::Quaternion<T>> rotation(pose);
        const Eigen::Map<const Eigen::Matrix<T, 3, 1>> translation(pose + 4);
        const Eigen::Map<const Eigen::Matrix<T, 3, 1>> normal(plane);
        Eigen::Matrix<T, 3, 1> apart;
        const Eigen::Matrix<T, 3, 1> turned = rotation.conjugate() * normal;
        apart.template head<2>() = across.cast<T>() * turned;
        apart[2] = plane[3] - normal.dot(translation) - turned.dot(middle.cast<T>()) - distance;
        Eigen::Map<Eigen::Matrix<T, 3, 1>> weighted(residual);
        weighted = weight.cast<T>() * apart;
        return true;
    }
};

/// Two stops against the motion between them, in the frame of the first.
struct MotionResidual {
    Pose motion;
    Matrix6d weight;

    explicit MotionResidual(const Motion& told) : motion(told.pose), weight(whitening<6>(told.covariance)) {}

    template <class T>
    bool operator()(const T* from, const T* to, T* residual) const
    {
        using Rotation = Eigen::Map<const Eigen::Quaternion<T>>;
        using Place = Eigen::Map<const Eigen::Matrix<T, 3, 1>>;
        const Eigen::Quaternion<T> back = Rotation(from).conjugate();
        const Eigen::Quaternion<T> turn = back * Rotation(to) * motion.rotation.conjugate().cast<T>();
        const T twice = turn.w() < T(0.0) ? T(-2.0) : T(2.0);
        Eigen::Matrix<T, 6, 1> apart;
        apart.template head<3>() = twice * turn.vec();
        apart.template tail<3>() = back * (Place(to + 4) - Place(from + 4)) - motion.translation.cast<T>();
        Eigen::Map<Eigen::Matrix<T, 6, 1>> weighted(residual);
        weighted = weight.cast<T>() * apart;
        return true;
    }
};

using PoseManifold = ceres::ProductManifold<ceres::EigenQuaternionManifold, ceres::EuclideanManifold<3>>;
using PlaneManifold = ceres::ProductManifold<ceres::SphereManifold<3>, ceres::EuclideanManifold<1>>;

/// The unknowns of an adjustment, and what Ceres is told of them.
class Adjustment {
public:
    explicit Adjustment(const BuildingMap& map)
        : poses_(map.stops.size()), planes_(map.planes.size()), problem_(options())
    {
    }

    void addPose(const BuildingMap& map, std::size_t stop, bool held)
    {
        if (poses_[stop])
            return;
        const Pose& pose = map.stops[stop].pose;
        poses_[stop] = std::make_unique<PoseBlock>(PoseBlock{pose.rotation.x(), pose.rotation.y(), pose.rotation.z(),
                                                             pose.rotation.w(), pose.translation.x(),
                                                             pose.translation.y(), pose.translation.z()});
        problem_.AddParameterBlock(poses_[stop]->data(), 7, &poseManifold_);
        if (held)
            problem_.SetParameterBlockConstant(poses_[stop]->data());
    }

    void addPlane(const BuildingMap& map, std::size_t plane, bool held)
    {
        const UncertainPlane& known = map.planes[plane].parameters;
        planes_[plane] = std::make_unique<PlaneBlock>(
            PlaneBlock{known.normal.x(), known.normal.y(), known.normal.z(), known.distance});
        problem_.AddParameterBlock(planes_[plane]->data(), 4, &planeManifold_);
        if (held)
            problem_.SetParameterBlockConstant(planes_[plane]->data());
    }

    bool hasPlane(std::size_t plane) const { return planes_[plane] != nullptr; }

    void addSighting(const BuildingMap& map, std::size_t plane, const Sighting& sighting)
    {
        const ObservedPlane& seen = map.stops[sighting.stop].stop->planes[sighting.plane];
        problem_.AddResidualBlock(
            new ceres::AutoDiffCostFunction<SightingResidual, 3, 7, 4>(new SightingResidual(seen)), &sightingLoss_,
            poses_[sighting.stop]->data(), planes_[plane]->data());
    }

    void addMotion(const BuildingMap& map, std::size_t to)
    {
        const StopMotion& odometry = *map.stops[to].odometry;
        problem_.AddResidualBlock(
            new ceres::AutoDiffCostFunction<MotionResidual, 6, 7, 7>(new MotionResidual(odometry.motion)), &motionLoss_,
            poses_[odometry.from]->data(), poses_[to]->data());
    }

    Result<MapAdjustment> solve(BuildingMap& map)
    {
        ceres::Solver::Options options;
        // Without BLAS, whose results differ from library to library.
        options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
        options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
        options.num_threads = 1;
        options.logging_type = ceres::SILENT;
        options.max_num_iterations = 50;
        options.function_tolerance = 1e-9;
        options.parameter_tolerance = 1e-10;
        ceres::Solver::Summary summary;
        ceres::Solve(options, &problem_, &summary);
        if (!summary.IsSolutionUsable())
            return fail(ErrorCode::Internal, "The map could not be adjusted: " + summary.message +
                                                 ". Remove the stop that was added last and try again.");
        MapAdjustment done;
        done.iterations = static_cast<int>(summary.iterations.size());
        done.costBefore = summary.initial_cost;
        done.costAfter = summary.final_cost;
        done.heldOff = heldOff();
        write(map);
        return done;
    }

private:
    static ceres::Problem::Options options()
    {
        ceres::Problem::Options options;
        options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
        options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
        return options;
    }

    int heldOff()
    {
        std::vector<ceres::ResidualBlockId> blocks;
        problem_.GetResidualBlocks(&blocks);
        int count = 0;
        for (const ceres::ResidualBlockId block : blocks) {
            double plain = 0.0;
            double robust = 0.0;
            problem_.EvaluateResidualBlockAssumingParametersUnchanged(block, false, &plain, nullptr, nullptr);
            problem_.EvaluateResidualBlockAssumingParametersUnchanged(block, true, &robust, nullptr, nullptr);
            count += robust < plain ? 1 : 0;
        }
        return count;
    }

    void write(BuildingMap& map) const
    {
        for (std::size_t stop = 0; stop < poses_.size(); ++stop) {
            if (!poses_[stop])
                continue;
            const PoseBlock& block = *poses_[stop];
            map.stops[stop].pose = {Eigen::Quaterniond(block[3], block[0], block[1], block[2]).normalized(),
                                    {block[4], block[5], block[6]}};
        }
        for (std::size_t plane = 0; plane < planes_.size(); ++plane) {
            if (!planes_[plane])
                continue;
            UncertainPlane& parameters = map.planes[plane].parameters;
            const UncertainPlane before = parameters;
            const PlaneBlock& block = *planes_[plane];
            parameters.normal = Eigen::Vector3d(block[0], block[1], block[2]).normalized();
            parameters.distance = block[3];
            parameters.tangents = tangentsOf(parameters.normal);
            parameters.covariance = covarianceIn(parameters, before);
        }
    }

    PoseManifold poseManifold_;
    PlaneManifold planeManifold_;
    ceres::HuberLoss sightingLoss_{std::sqrt(chiSquareLimit(3))};
    ceres::HuberLoss motionLoss_{std::sqrt(chiSquareLimit(6))};
    std::vector<std::unique_ptr<PoseBlock>> poses_;
    std::vector<std::unique_ptr<PlaneBlock>> planes_;
    ceres::Problem problem_;
};

/// The stop to which odometry leads on from one.
std::size_t nextPlaced(const BuildingMap& map, std::size_t stop)
{
    do
        ++stop;
    while (stop < map.stops.size() && !map.stops[stop].isPlaced());
    return stop;
}

}  // namespace

Result<MapAdjustment> adjustMap(BuildingMap& map)
{
    Adjustment adjustment(map);
    for (std::size_t stop = 0; stop < map.stops.size(); ++stop) {
        if (!map.stops[stop].isPlaced())
            continue;
        adjustment.addPose(map, stop, map.stops[stop].trust == StopTrust::First);
        if (map.stops[stop].odometry)
            adjustment.addMotion(map, stop);
    }
    for (std::size_t plane = 0; plane < map.planes.size(); ++plane) {
        if (map.planes[plane].sightings.empty())
            continue;
        adjustment.addPlane(map, plane, false);
        for (const Sighting& sighting : map.planes[plane].sightings)
            adjustment.addSighting(map, plane, sighting);
    }
    return adjustment.solve(map);
}

Result<MapAdjustment> adjustStops(BuildingMap& map, const std::vector<std::size_t>& stops)
{
    Adjustment adjustment(map);
    for (const std::size_t stop : stops)
        adjustment.addPose(map, stop, map.stops[stop].trust == StopTrust::First);
    for (const std::size_t stop : stops) {
        for (const std::size_t to : {stop, nextPlaced(map, stop)}) {
            if (to >= map.stops.size() || !map.stops[to].odometry)
                continue;
            const std::size_t from = map.stops[to].odometry->from;
            adjustment.addPose(map, from, true);
            adjustment.addPose(map, to, true);
            const bool isAddedByTheOther = to != stop && std::ranges::find(stops, to) != stops.end();
            if (!isAddedByTheOther && (to == stop || from == stop))
                adjustment.addMotion(map, to);
        }
        for (const MapMatch& match : map.stops[stop].matches) {
            if (!match.plane || adjustment.hasPlane(*match.plane))
                continue;
            const auto& sightings = map.planes[*match.plane].sightings;
            const bool held = sightings.size() > kMostOtherSightings + stops.size();
            adjustment.addPlane(map, *match.plane, held);
            if (held)
                continue;
            for (const Sighting& sighting : sightings) {
                adjustment.addPose(map, sighting.stop, true);
                adjustment.addSighting(map, *match.plane, sighting);
            }
        }
    }
    // What the stops saw of the planes that are held.
    for (const std::size_t stop : stops) {
        const auto& matches = map.stops[stop].matches;
        for (std::size_t i = 0; i < matches.size(); ++i) {
            if (matches[i].plane && map.planes[*matches[i].plane].sightings.size() > kMostOtherSightings + stops.size())
                adjustment.addSighting(map, *matches[i].plane, {stop, i});
        }
    }
    return adjustment.solve(map);
}

}  // namespace planewright
