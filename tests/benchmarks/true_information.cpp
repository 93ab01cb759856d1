// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/true_information.h"

#include <algorithm>

#include "core/geometry/sensor_model.h"
#include "core/planes/end_point_cost.h"

namespace planewright {

namespace {

/// Sums over the points of a slice, from which its pitch error is eliminated.
struct SliceSums {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d coupling = Eigen::Vector3d::Zero();  ///< of the plane with the pitch
    double pitch = 0.0;

    /// Adds a point whose distance to the plane changes by `row` with the plane, and by n'J with what was measured.
    void add(const Eigen::Vector3d& row, const Eigen::Vector3d& measured, double rangeSigma, double bearingSigma)
    {
        const double variance = measured[0] * measured[0] * rangeSigma * rangeSigma +
                                measured[1] * measured[1] * bearingSigma * bearingSigma;
        information += row * row.transpose() / variance;
        coupling += measured[2] / variance * row;
        pitch += measured[2] * measured[2] / variance;
    }

    Eigen::Matrix3d withoutPitch(double pitchSigma) const
    {
        const double variance = pitchSigma * pitchSigma;
        return information - variance / (1 + variance * pitch) * coupling * coupling.transpose();
    }
};

}  // namespace

Eigen::Matrix3d trueInformation(const SimulatedScan& scan, const PlaneGroup& ids, const TruePlane& plane,
                                const SimulationNoise& noise)
{
    const SensorModel sensor = sensorOf(scan.recording.description);
    const Eigen::Matrix<double, 3, 2> tangents = tangentsOf(plane.normal);
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < scan.recording.slices.size(); ++k) {
        const ScanSlice& slice = scan.recording.slices[k];
        SliceSums sums;
        for (std::size_t beam = 0; beam < slice.ranges.size(); ++beam) {
            if (std::find(ids.begin(), ids.end(), scan.labels[k][beam]) == ids.end())
                continue;
            const double range = slice.ranges[beam];
            const Eigen::Vector3d point = toCartesian(range, slice.bearing(beam), slice.tiltAt(beam), sensor);
            const Eigen::Matrix3d jacobian = cartesianJacobian(range, slice.bearing(beam), slice.tiltAt(beam), sensor);
            sums.add({tangents.col(0).dot(point), tangents.col(1).dot(point), -1.0},
                     jacobian.transpose() * plane.normal, noise.rangeSigma(range), noise.bearing);
        }
        information += sums.withoutPitch(noise.pitch);
    }
    return information;
}

}  // namespace planewright
