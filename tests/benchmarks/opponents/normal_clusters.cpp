// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/normal_clusters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace planewright {

namespace {

/// Cells of like size on the sphere: bands of latitude, each divided into as many pieces as its circumference needs.
constexpr int kBands = 36;

int pieces(int band)
{
    const double latitude = std::numbers::pi * (band + 0.5) / kBands;
    return std::max(1, static_cast<int>(std::lround(2.0 * kBands * std::sin(latitude))));
}

}  // namespace

std::vector<std::vector<int>> clustersOfNormals(const std::vector<Eigen::Vector3d>& normals, double angle,
                                                std::size_t minSize)
{
    std::vector<int> firstCell(kBands + 1, 0);
    for (int band = 0; band < kBands; ++band)
        firstCell[static_cast<std::size_t>(band) + 1] = firstCell[static_cast<std::size_t>(band)] + pieces(band);
    const auto cellOf = [&](const Eigen::Vector3d& n) {
        const int band =
            std::min(kBands - 1, static_cast<int>(std::acos(std::clamp(n.z(), -1.0, 1.0)) / std::numbers::pi * kBands));
        const double turn = (std::atan2(n.y(), n.x()) + std::numbers::pi) / (2.0 * std::numbers::pi);
        return firstCell[static_cast<std::size_t>(band)] +
               std::min(pieces(band) - 1, static_cast<int>(turn * pieces(band)));
    };

    std::vector<int> rest;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        if (normals[i].squaredNorm() > 0.5)
            rest.push_back(static_cast<int>(i));
    }
    std::vector<std::vector<int>> clusters;
    const double cosine = std::cos(angle);
    while (rest.size() >= minSize && !rest.empty()) {
        std::vector<int> count(static_cast<std::size_t>(firstCell.back()), 0);
        std::vector<Eigen::Vector3d> sum(count.size(), Eigen::Vector3d::Zero());
        for (const int i : rest) {
            const auto cell = static_cast<std::size_t>(cellOf(normals[static_cast<std::size_t>(i)]));
            ++count[cell];
            sum[cell] += normals[static_cast<std::size_t>(i)];
        }
        const auto densest = static_cast<std::size_t>(std::max_element(count.begin(), count.end()) - count.begin());
        Eigen::Vector3d direction = sum[densest].normalized();
        for (int iteration = 0; iteration < 5; ++iteration) {  // mean shift with half the angle
            Eigen::Vector3d mean = Eigen::Vector3d::Zero();
            for (const int i : rest) {
                if (normals[static_cast<std::size_t>(i)].dot(direction) > std::cos(0.5 * angle))
                    mean += normals[static_cast<std::size_t>(i)];
            }
            if (mean.squaredNorm() > 0.0)
                direction = mean.normalized();
        }
        std::vector<int> cluster;
        std::erase_if(rest, [&](int i) {
            if (normals[static_cast<std::size_t>(i)].dot(direction) <= cosine)
                return false;
            cluster.push_back(i);
            return true;
        });
        if (cluster.size() < minSize)
            break;
        clusters.push_back(std::move(cluster));
    }
    return clusters;
}

}  // namespace planewright
