// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/prosac_planes.h"

#include <pcl/console/print.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/prosac.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <utility>

namespace planewright {

void takeProsacPlanes(const VoxelGrid& grid, std::vector<int>& members, const ProsacSearch& search, Random& random,
                      std::vector<OpponentPlane>& planes, std::vector<int>& voxelLabels)
{
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // it complains of every collinear draw
    constexpr int kFailures = 2;
    std::int64_t left = 0;
    for (const int member : members)
        left += grid.counts[static_cast<std::size_t>(member)];
    for (int failures = 0; failures < kFailures && members.size() >= 3 && left >= search.minReturns;) {
        if (!search.ordered || failures > 0) {
            for (std::size_t i = members.size() - 1; i > 0; --i)
                std::swap(members[i], members[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
        }
        const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
        for (const int member : members) {
            const Eigen::Vector3f p = grid.means[static_cast<std::size_t>(member)].cast<float>();
            cloud->push_back({p.x(), p.y(), p.z()});
        }
        const auto model = pcl::make_shared<pcl::SampleConsensusModelPlane<pcl::PointXYZ>>(cloud);
        pcl::ProgressiveSampleConsensus<pcl::PointXYZ> prosac(model, search.tolerance);
        prosac.setMaxIterations(search.iterations);
        if (!prosac.computeModel())
            break;
        pcl::Indices inliers;
        Eigen::VectorXf best;
        prosac.getInliers(inliers);
        prosac.getModelCoefficients(best);
        Eigen::VectorXf refined;
        model->optimizeModelCoefficients(inliers, best, refined);
        model->selectWithinDistance(refined, search.tolerance, inliers);

        std::int64_t returns = 0;
        for (const pcl::index_t i : inliers)
            returns += grid.counts[static_cast<std::size_t>(members[static_cast<std::size_t>(i)])];
        if (returns < search.minReturns) {
            ++failures;
            continue;
        }
        failures = 0;
        left -= returns;
        const Eigen::Vector3d normal = refined.head<3>().cast<double>();
        for (const pcl::index_t i : inliers) {
            int& member = members[static_cast<std::size_t>(i)];
            voxelLabels[static_cast<std::size_t>(member)] = static_cast<int>(planes.size());
            member = -1;
        }
        std::erase(members, -1);
        planes.push_back({normal / normal.norm(), -static_cast<double>(refined[3]) / normal.norm()});
    }
}

}  // namespace planewright
