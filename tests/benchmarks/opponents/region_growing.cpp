// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/region_growing.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <iterator>
#include <numbers>
#include <utility>

namespace planewright {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PointWithNormal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using PointsWithNormals = std::vector<PointWithNormal>;
using PointMap = CGAL::First_of_pair_property_map<PointWithNormal>;
using NormalMap = CGAL::Second_of_pair_property_map<PointWithNormal>;
using Neighbours = CGAL::Shape_detection::Point_set::K_neighbor_query<Kernel, PointsWithNormals, PointMap>;
using Region =
    CGAL::Shape_detection::Point_set::Least_squares_plane_fit_region<Kernel, PointsWithNormals, PointMap, NormalMap>;
using Sorting =
    CGAL::Shape_detection::Point_set::Least_squares_plane_fit_sorting<Kernel, PointsWithNormals, Neighbours, PointMap>;
using Growing =
    CGAL::Shape_detection::Region_growing<PointsWithNormals, Neighbours, Region, typename Sorting::Seed_map>;

}  // namespace

OpponentResult RegionGrowing::extract(const PointScan& scan) const
{
    const VoxelGrid grid = reduced(scan, parameters_.reduction);
    PointsWithNormals points;
    for (const Eigen::Vector3d& p : grid.means)
        points.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(0.0, 0.0, 0.0));
    CGAL::pca_estimate_normals<CGAL::Sequential_tag>(points, static_cast<unsigned>(parameters_.normalNeighbours),
                                                     CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));

    Neighbours neighbours(points, static_cast<std::size_t>(parameters_.neighbours));
    Region region(points, parameters_.toleranceSigmas * placeSigma(scan),
                  parameters_.normalAngle * 180.0 / std::numbers::pi, static_cast<std::size_t>(parameters_.minPoints));
    Sorting sorting(points, neighbours);
    sorting.sort();
    Growing growing(points, neighbours, region, sorting.seed_map());
    std::vector<std::vector<std::size_t>> regions;
    growing.detect(std::back_inserter(regions));

    OpponentResult result;
    std::vector<int> voxelLabels(grid.means.size(), -1);
    for (const std::vector<std::size_t>& found : regions) {
        for (const std::size_t i : found)
            voxelLabels[i] = static_cast<int>(result.planes.size());
        result.planes.emplace_back();  // fitted below
    }
    result.labels = pointLabels(grid, voxelLabels);
    finishPlanes(scan, parameters_.finish, result);
    return result;
}

}  // namespace planewright
