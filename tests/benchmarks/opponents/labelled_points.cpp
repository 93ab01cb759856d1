// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/labelled_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include <Eigen/Eigenvalues>

namespace planewright {

namespace {

/// Sums over points, relative to the first of them.
struct Sums {
    double count = 0.0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

    void add(const Eigen::Vector3d& point)
    {
        if (count == 0.0)
            first = point;
        const Eigen::Vector3d p = point - first;
        count += 1.0;
        sum += p;
        squares.noalias() += p * p.transpose();
    }

    Eigen::Vector3d mean() const { return first + sum / count; }

    void add(const Sums& other)
    {
        // Moved to this set's first point: (p − first) = (p − other.first) + shift.
        const Eigen::Vector3d shift = other.first - first;
        squares += other.squares + other.sum * shift.transpose() + shift * other.sum.transpose() +
                   other.count * shift * shift.transpose();
        sum += other.sum + other.count * shift;
        count += other.count;
    }

    OpponentPlane plane() const
    {
        const Eigen::Vector3d off = sum / count;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares / count - off * off.transpose());
        OpponentPlane plane;
        plane.normal = solver.eigenvectors().col(0);
        plane.distance = plane.normal.dot(first + off);
        return plane;
    }
};

std::vector<Sums> sumsOf(const PointScan& scan, const OpponentResult& result)
{
    std::vector<Sums> sums(result.planes.size());
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        if (result.labels[i] >= 0)
            sums[static_cast<std::size_t>(result.labels[i])].add(scan.points[i]);
    }
    return sums;
}

void fitAll(const PointScan& scan, OpponentResult& result)
{
    const std::vector<Sums> sums = sumsOf(scan, result);
    for (std::size_t j = 0; j < sums.size(); ++j) {
        if (sums[j].count >= 3.0)
            result.planes[j] = sums[j].plane();
    }
}

/// Merges the plane of most points with those coplanar to it, and so on with the next.
void mergeCoplanar(const PointScan& scan, double angle, double distance, OpponentResult& result)
{
    std::vector<Sums> sums = sumsOf(scan, result);
    std::vector<int> order(sums.size());
    std::iota(order.begin(), order.end(), 0);
    std::erase_if(order, [&](int j) { return sums[static_cast<std::size_t>(j)].count < 3.0; });
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return sums[static_cast<std::size_t>(a)].count > sums[static_cast<std::size_t>(b)].count;
    });
    std::vector<int> into(sums.size());
    std::iota(into.begin(), into.end(), 0);
    const double cosine = std::cos(angle);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto large = static_cast<std::size_t>(order[i]);
        if (into[large] != order[i])
            continue;
        OpponentPlane plane = sums[large].plane();
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const auto small = static_cast<std::size_t>(order[j]);
            if (into[small] != order[j])
                continue;
            const OpponentPlane other = sums[small].plane();
            if (std::abs(plane.normal.dot(other.normal)) < cosine ||
                std::abs(plane.normal.dot(sums[small].mean()) - plane.distance) > distance ||
                std::abs(other.normal.dot(sums[large].mean()) - other.distance) >
                    distance + angle * (sums[large].mean() - sums[small].mean()).norm())
                continue;
            into[small] = order[i];
            sums[large].add(sums[small]);
            plane = sums[large].plane();
        }
    }
    for (int& label : result.labels) {
        if (label >= 0)
            label = into[static_cast<std::size_t>(label)];
    }
}

double deviation(const PointScan& scan, const OpponentPlane& plane, std::size_t i)
{
    return std::abs(plane.normal.dot(scan.points[i]) - plane.distance) / scan.sigmaAcross(scan.points[i], plane.normal);
}

void dropSmall(const PointScan& scan, std::int64_t minReturns, OpponentResult& result)
{
    constexpr int kMinSlices = 3;  // as the product: the points of one slice lie on many planes
    std::vector<std::int64_t> count(result.planes.size(), 0);
    std::vector<int> slices(result.planes.size(), 0);
    std::vector<int> lastSlice(result.planes.size(), -1);
    for (std::size_t i = 0; i < result.labels.size(); ++i) {
        if (result.labels[i] < 0)
            continue;
        const auto label = static_cast<std::size_t>(result.labels[i]);
        ++count[label];
        if (lastSlice[label] != scan.slice[i]) {
            lastSlice[label] = scan.slice[i];
            ++slices[label];
        }
    }
    std::vector<int> renamed(result.planes.size(), -1);
    std::vector<OpponentPlane> kept;
    for (std::size_t j = 0; j < count.size(); ++j) {
        if (count[j] < std::max<std::int64_t>(3, minReturns) || slices[j] < kMinSlices)
            continue;
        renamed[j] = static_cast<int>(kept.size());
        kept.push_back(result.planes[j]);
    }
    result.planes = std::move(kept);
    for (int& label : result.labels) {
        if (label >= 0)
            label = renamed[static_cast<std::size_t>(label)];
    }
}

}  // namespace

void finishPlanes(const PointScan& scan, const FinishParameters& parameters, OpponentResult& result)
{
    constexpr double kSigmas = 4.0;
    if (parameters.mergeSigmas > 0.0)
        mergeCoplanar(scan, parameters.mergeAngle, parameters.mergeSigmas * placeSigma(scan), result);
    fitAll(scan, result);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        int& label = result.labels[i];
        if (label >= 0 && deviation(scan, result.planes[static_cast<std::size_t>(label)], i) > kSigmas)
            label = -1;
    }
    dropSmall(scan, static_cast<std::int64_t>(parameters.support * static_cast<double>(scan.minReturns)), result);
    fitAll(scan, result);
}

void completeLabels(const PointScan& scan, OpponentResult& result)
{
    constexpr int kBeams = 8;
    constexpr double kSigmas = 3.0;
    const std::vector<int> before = result.labels;
    const auto labelAt = [&](int slice, int beam) {
        if (slice < 0 || slice >= scan.slices || beam < 0 || beam >= scan.beams)
            return -1;
        const int point = scan.at(slice, beam);
        return point < 0 ? -1 : before[static_cast<std::size_t>(point)];
    };
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        if (before[i] >= 0)
            continue;
        double best = kSigmas;
        const auto consider = [&](int label) {
            const double d = deviation(scan, result.planes[static_cast<std::size_t>(label)], i);
            if (d < best) {
                best = d;
                result.labels[i] = label;
            }
        };
        for (const int side : {-1, 1}) {
            for (int step = 1; step <= kBeams; ++step) {
                const int label = labelAt(scan.slice[i], scan.beam[i] + side * step);
                if (label >= 0) {
                    consider(label);
                    break;
                }
            }
            const int label = labelAt(scan.slice[i] + side, scan.beam[i]);
            if (label >= 0)
                consider(label);
        }
    }
}

std::vector<int> pointLabels(const VoxelGrid& grid, const std::vector<int>& voxelLabels)
{
    std::vector<int> labels;
    labels.reserve(grid.voxelOf.size());
    for (const int voxel : grid.voxelOf)
        labels.push_back(voxelLabels[static_cast<std::size_t>(voxel)]);
    return labels;
}

double placeSigma(const PointScan& scan)
{
    return std::hypot(scan.sigma(), scan.noise.pitch * scan.medianRange);
}

}  // namespace planewright
