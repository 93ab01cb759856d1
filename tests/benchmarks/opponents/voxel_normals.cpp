// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/voxel_normals.h"

#include <pcl/features/normal_3d.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

namespace planewright {

PointNormals normalsOf(const std::vector<Eigen::Vector3d>& points, int k)
{
    const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3f p = point.cast<float>();
        cloud->push_back({p.x(), p.y(), p.z()});
    }
    pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud(cloud);
    estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false));
    estimation.setKSearch(k);
    pcl::PointCloud<pcl::Normal> estimated;
    estimation.compute(estimated);

    PointNormals result;
    for (const pcl::Normal& normal : estimated) {
        const Eigen::Vector3d n = normal.getNormalVector3fMap().cast<double>();
        result.normals.push_back(n.allFinite() ? n : Eigen::Vector3d::Zero());
        result.curvature.push_back(n.allFinite() ? static_cast<double>(normal.curvature) : 1.0);
    }
    return result;
}

}  // namespace planewright
