// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/efficient_ransac.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace planewright {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PointWithNormal = std::tuple<Kernel::Point_3, Kernel::Vector_3, std::size_t>;  // with its voxel
using PointsWithNormals = std::vector<PointWithNormal>;
using PointMap = CGAL::Nth_of_tuple_property_map<0, PointWithNormal>;
using NormalMap = CGAL::Nth_of_tuple_property_map<1, PointWithNormal>;
using Traits = CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, PointsWithNormals, PointMap, NormalMap>;
using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
using RansacPlane = CGAL::Shape_detection::Plane<Traits>;

}  // namespace

OpponentResult EfficientRansac::extract(const PointScan& scan) const
{
    const VoxelGrid grid = reduced(scan, parameters_.reduction);
    PointsWithNormals points;
    for (const Eigen::Vector3d& p : grid.means)
        points.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(0.0, 0.0, 0.0), points.size());
    CGAL::pca_estimate_normals<CGAL::Sequential_tag>(points, static_cast<unsigned>(parameters_.neighbours),
                                                     CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));

    CGAL::get_default_random() = CGAL::Random(1);
    Ransac ransac;
    ransac.set_input(points);  // and puts them into an order of its own
    ransac.add_shape_factory<RansacPlane>();
    Ransac::Parameters limits;
    limits.probability = parameters_.probability;
    limits.min_points = static_cast<std::size_t>(parameters_.minPoints);
    limits.epsilon = parameters_.toleranceSigmas * placeSigma(scan);
    limits.cluster_epsilon = parameters_.gap * scan.spacing();
    limits.normal_threshold = std::cos(parameters_.normalAngle);
    ransac.detect(limits);

    OpponentResult result;
    std::vector<int> voxelLabels(grid.means.size(), -1);
    for (const auto& shape : ransac.shapes()) {
        const auto* plane = dynamic_cast<const RansacPlane*>(shape.get());
        if (plane == nullptr)
            continue;
        for (const std::size_t i : plane->indices_of_assigned_points())
            voxelLabels[std::get<2>(points[i])] = static_cast<int>(result.planes.size());
        result.planes.emplace_back();  // fitted below
    }
    result.labels = pointLabels(grid, voxelLabels);
    finishPlanes(scan, parameters_.finish, result);
    return result;
}

}  // namespace planewright
