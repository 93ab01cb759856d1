// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/grid_normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Eigenvalues>

namespace planewright {

std::vector<Eigen::Vector3d> gridNormals(const PointScan& scan, int windowSlices, int windowBeams)
{
    // A wall met at 10° changes range by 6 arc lengths from beam to beam.
    constexpr double kSteepest = 6.0;
    const int area = (2 * windowSlices + 1) * (2 * windowBeams + 1);
    std::vector<double> ranges;
    ranges.reserve(scan.points.size());
    for (const Eigen::Vector3d& point : scan.points)
        ranges.push_back(point.norm());
    std::vector<Eigen::Vector3d> normals(scan.points.size(), Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const Eigen::Vector3d& centre = scan.points[i];
        const double noise = 4.0 * scan.noise.rangeSigma(ranges[i]);
        double n = 0.0;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
        for (int slice = std::max(0, scan.slice[i] - windowSlices);
             slice <= std::min(scan.slices - 1, scan.slice[i] + windowSlices); ++slice) {
            for (int beam = std::max(0, scan.beam[i] - windowBeams);
                 beam <= std::min(scan.beams - 1, scan.beam[i] + windowBeams); ++beam) {
                const int j = scan.at(slice, beam);
                if (j < 0)
                    continue;
                const Eigen::Vector3d p = scan.points[static_cast<std::size_t>(j)] - centre;
                const double jump = std::abs(ranges[static_cast<std::size_t>(j)] - ranges[i]);
                // The distance across the ray stands in for the arc: p² = jump² + across².
                const double across = p.squaredNorm() - jump * jump;
                if (jump > noise && (jump - noise) * (jump - noise) > kSteepest * kSteepest * across)
                    continue;
                n += 1.0;
                sum += p;
                xx += p.x() * p.x();
                xy += p.x() * p.y();
                xz += p.x() * p.z();
                yy += p.y() * p.y();
                yz += p.y() * p.z();
                zz += p.z() * p.z();
            }
        }
        if (2.0 * n < area)
            continue;
        Eigen::Matrix3d scatter;
        scatter << xx, xy, xz, xy, yy, yz, xz, yz, zz;
        scatter -= sum * sum.transpose() / n;
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
        solver.computeDirect(scatter);
        const Eigen::Vector3d normal = solver.eigenvectors().col(0);
        normals[i] = normal.dot(centre) > 0.0 ? Eigen::Vector3d(-normal) : normal;
    }
    return normals;
}

}  // namespace planewright
