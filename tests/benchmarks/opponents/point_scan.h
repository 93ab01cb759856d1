// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/simulation/simulation_noise.h"
#include "core/types/recording.h"

namespace planewright {

/// A scan as plane extractors for point clouds take it: its returns in scan order, and all that one knows of the
/// scanner.
///
/// Frame: the sensor's at its pitch axis, x right, y forward, z up, metres.
struct PointScan {
    std::vector<Eigen::Vector3d> points;
    std::vector<int> slice;  ///< of each point
    std::vector<int> beam;   ///< of each point
    std::vector<int> grid;   ///< point of (slice, beam), or −1 without return: slice · beams + beam
    int slices = 0;
    int beams = 0;
    double tiltStep = 0.0;        ///< between slices [rad]
    double bearingStep = 0.0;     ///< between beams [rad]
    SimulationNoise noise;        ///< the true noise: opponents are told what nobody has to tell the product
    double medianRange = 0.0;     ///< [m]
    std::int64_t minReturns = 0;  ///< returns that a plane of the smallest solid angle worth finding has

    int at(int sliceIndex, int beamIndex) const
    {
        return grid[static_cast<std::size_t>(sliceIndex) * static_cast<std::size_t>(beams) +
                    static_cast<std::size_t>(beamIndex)];
    }

    /// Standard deviation of a range at the median range [m]: the scale of the noise.
    double sigma() const { return noise.rangeSigma(medianRange); }

    /// Distance between neighbouring slices at the median range [m]: the scale of the sampling.
    double spacing() const { return medianRange * std::max(tiltStep, bearingStep); }

    /// Standard deviation of a point's distance to a plane of this unit normal [m], by range and pitch noise.
    double sigmaAcross(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;
};

/// The returns of a recording as points. Smallest planes are those that the product itself looks for
/// (`likelihood.min-solid-angle`).
PointScan pointScanOf(const Recording& recording, const SimulationNoise& noise);

}  // namespace planewright
