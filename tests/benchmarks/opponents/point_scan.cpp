// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/opponents/point_scan.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/sensor_model.h"
#include "core/params/parameters.h"

namespace planewright {

double PointScan::sigmaAcross(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const
{
    const double range = point.norm();
    const double byRange = normal.dot(point) / range * noise.rangeSigma(range);
    const double byPitch = (normal.z() * point.y() - normal.y() * point.z()) * noise.pitch;  // points turn about x
    const double byBearing = range * noise.bearing;
    return std::sqrt(byRange * byRange + byPitch * byPitch + byBearing * byBearing);
}

PointScan pointScanOf(const Recording& recording, const SimulationNoise& noise)
{
    const SensorModel sensor = sensorOf(recording.description);
    PointScan scan;
    scan.noise = noise;
    scan.slices = static_cast<int>(recording.slices.size());
    scan.beams = recording.description.beams;
    scan.grid.assign(static_cast<std::size_t>(scan.slices) * static_cast<std::size_t>(scan.beams), -1);
    std::vector<double> ranges;
    for (int k = 0; k < scan.slices; ++k) {
        const ScanSlice& slice = recording.slices[static_cast<std::size_t>(k)];
        for (std::size_t i = 0; i < slice.ranges.size(); ++i) {
            if (!sensor.hasEcho(slice.ranges[i]))
                continue;
            scan.grid[static_cast<std::size_t>(k) * static_cast<std::size_t>(scan.beams) + i] =
                static_cast<int>(scan.points.size());
            scan.points.push_back(toCartesian(slice.ranges[i], slice.bearing(i), slice.tiltAt(i), sensor));
            scan.slice.push_back(k);
            scan.beam.push_back(static_cast<int>(i));
            ranges.push_back(slice.ranges[i]);
        }
    }
    if (!ranges.empty()) {
        const auto middle = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() / 2);
        std::nth_element(ranges.begin(), middle, ranges.end());
        scan.medianRange = *middle;
    }
    scan.bearingStep = recording.description.bearingStep;
    if (scan.slices > 1)
        scan.tiltStep = std::abs(recording.slices.back().tilt - recording.slices.front().tilt) / (scan.slices - 1);
    const double beamSolidAngle = scan.bearingStep * scan.tiltStep;
    scan.minReturns = std::max<std::int64_t>(
        12, static_cast<std::int64_t>(LikelihoodParameters{}.minSolidAngle / std::max(beamSolidAngle, 1e-9)));
    return scan;
}

}  // namespace planewright
