// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/organized_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include "tests/benchmarks/opponents/grid_normals.h"

namespace planewright {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Segmentation = pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>;

/// Neighbours are on one plane where their normals are alike and neither is off the plane of the other.
class NoiseComparator : public pcl::PlaneCoefficientComparator<pcl::PointXYZ, pcl::Normal> {
public:
    NoiseComparator(const PointScan& scan, const std::vector<int>& pointOf, const OrganizedPlanesParameters& parameters)
        : scan_(scan), pointOf_(pointOf), cosine_(std::cos(parameters.angle)), sigmas_(parameters.distanceSigmas)
    {
    }

    bool compare(int a, int b) const override
    {
        const Eigen::Vector3f first = (*normals_)[static_cast<std::size_t>(a)].getNormalVector3fMap();
        const Eigen::Vector3f second = (*normals_)[static_cast<std::size_t>(b)].getNormalVector3fMap();
        if (!(static_cast<double>(first.dot(second)) > cosine_))
            return false;
        const Eigen::Vector3d& point = scan_.points[static_cast<std::size_t>(pointOf_[static_cast<std::size_t>(a)])];
        const Eigen::Vector3d& other = scan_.points[static_cast<std::size_t>(pointOf_[static_cast<std::size_t>(b)])];
        const Eigen::Vector3d normal = (first + second).cast<double>().normalized();
        // Both points have noise of their own.
        return std::abs(normal.dot(other - point)) < sigmas_ * std::sqrt(2.0) * scan_.sigmaAcross(point, normal);
    }

private:
    const PointScan& scan_;
    const std::vector<int>& pointOf_;
    double cosine_;
    double sigmas_;
};

/// The same for points beside a plane that was found.
class NoiseRefinement : public pcl::PlaneRefinementComparator<pcl::PointXYZ, pcl::Normal, pcl::Label> {
public:
    NoiseRefinement(const PointScan& scan, const std::vector<int>& pointOf, double sigmas)
        : scan_(scan), pointOf_(pointOf), sigmas_(sigmas)
    {
    }

    bool compare(int a, int b) const override
    {
        const auto label = (*labels_)[static_cast<std::size_t>(a)].label;
        const auto other = (*labels_)[static_cast<std::size_t>(b)].label;
        if (!(*refine_labels_)[label] || (*refine_labels_)[other])
            return false;
        const std::vector<float>& plane = (*models_)[static_cast<std::size_t>((*label_to_model_)[label])].values;
        const Eigen::Vector3d normal = Eigen::Vector3f(plane[0], plane[1], plane[2]).cast<double>();
        const Eigen::Vector3d& point = scan_.points[static_cast<std::size_t>(pointOf_[static_cast<std::size_t>(b)])];
        return std::abs(normal.dot(point) + static_cast<double>(plane[3])) < sigmas_ * scan_.sigmaAcross(point, normal);
    }

private:
    const PointScan& scan_;
    const std::vector<int>& pointOf_;
    double sigmas_;
};

}  // namespace

OpponentResult OrganizedPlanes::extract(const PointScan& scan) const
{
    const auto reach = [](double angle, double step) {
        return std::max(1, static_cast<int>(std::lround(angle / step)));
    };
    const std::vector<Eigen::Vector3d> found = gridNormals(scan, reach(parameters_.windowTilt, scan.tiltStep),
                                                           reach(parameters_.windowBearing, scan.bearingStep));
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    const auto cloud = pcl::make_shared<Cloud>(static_cast<unsigned>(scan.beams), static_cast<unsigned>(scan.slices),
                                               pcl::PointXYZ(kNone, kNone, kNone));
    cloud->is_dense = false;
    const auto normals = pcl::make_shared<Normals>(
        static_cast<unsigned>(scan.beams), static_cast<unsigned>(scan.slices), pcl::Normal(kNone, kNone, kNone));
    for (std::size_t place = 0; place < scan.grid.size(); ++place) {
        if (scan.grid[place] < 0)
            continue;
        const auto i = static_cast<std::size_t>(scan.grid[place]);
        const Eigen::Vector3f p = scan.points[i].cast<float>();
        (*cloud)[place] = pcl::PointXYZ(p.x(), p.y(), p.z());
        const Eigen::Vector3f n = found[i].cast<float>();
        if (n.squaredNorm() > 0.5F)
            (*normals)[place] = pcl::Normal(n.x(), n.y(), n.z());
    }

    const auto minReturns = static_cast<std::int64_t>(parameters_.least * static_cast<double>(scan.minReturns));
    Segmentation segmentation;
    segmentation.setInputCloud(cloud);
    segmentation.setInputNormals(normals);
    segmentation.setMinInliers(static_cast<unsigned>(minReturns));
    segmentation.setMaximumCurvature(parameters_.maxCurvature);
    segmentation.setComparator(pcl::make_shared<NoiseComparator>(scan, scan.grid, parameters_));
    segmentation.setRefinementComparator(pcl::make_shared<NoiseRefinement>(scan, scan.grid, parameters_.refineSigmas));
    std::vector<pcl::ModelCoefficients> models;
    std::vector<pcl::PointIndices> inliers;
    std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>> centroids;
    std::vector<Eigen::Matrix3f, Eigen::aligned_allocator<Eigen::Matrix3f>> covariances;
    auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
    std::vector<pcl::PointIndices> labelIndices;
    segmentation.segment(models, inliers, centroids, covariances, *labels, labelIndices);
    if (!models.empty())
        segmentation.refine(models, inliers, labels, labelIndices);

    OpponentResult result;
    result.labels.assign(scan.points.size(), -1);
    for (const pcl::PointIndices& plane : inliers) {
        for (const pcl::index_t place : plane.indices) {
            const int point = scan.grid[static_cast<std::size_t>(place)];
            if (point >= 0)
                result.labels[static_cast<std::size_t>(point)] = static_cast<int>(result.planes.size());
        }
        result.planes.emplace_back();  // fitted below
    }
    finishPlanes(scan, parameters_.finish, result);
    return result;
}

}  // namespace planewright
