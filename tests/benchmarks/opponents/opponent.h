// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "tests/benchmarks/opponents/point_scan.h"

namespace planewright {

/// A plane n·p = d with |n| = 1 [m].
struct OpponentPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double distance = 0.0;
};

/// What an extractor makes of a scan.
struct OpponentResult {
    std::vector<OpponentPlane> planes;
    std::vector<int> labels;  ///< of each point: its plane's place in `planes`, or −1
};

/// A plane extractor for point clouds that the product is measured against.
class Opponent {
public:
    Opponent() = default;
    Opponent(const Opponent&) = delete;
    Opponent& operator=(const Opponent&) = delete;
    virtual ~Opponent() = default;

    virtual std::string_view name() const = 0;

    /// The planes of a scan, on one thread, each by least squares over its points; the same scan gives the same planes.
    virtual OpponentResult extract(const PointScan& scan) const = 0;
};

}  // namespace planewright
