// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "core/types/plane.h"

namespace planewright {

/// A plane as a result file gives it back: what two results are compared by.
struct PlaneRecord {
    PlaneId id = kNoPlane;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit length
    double distance = 0.0;                              ///< d ≥ 0 [m]
    std::optional<int> points;                          ///< scan points, where the file says
    std::string name;                                   ///< empty if none
    std::string className;                              ///< empty if none
};

/// Most planes that are read from one file.
inline constexpr std::size_t kMaxPlaneRecords = 1'000'000;

}  // namespace planewright
