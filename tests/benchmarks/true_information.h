// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "core/evaluation/label_groups.h"
#include "core/simulation/nodding_scanner.h"

namespace planewright {

/// Fisher information that all points of a true plane have of it, in (two tangent angles of its normal, d): its inverse
/// is the Cramér-Rao bound. Of range and bearing each point has an error of its own, of the pitch a slice has one.
Eigen::Matrix3d trueInformation(const SimulatedScan& scan, const PlaneGroup& ids, const TruePlane& plane,
                                const SimulationNoise& noise);

}  // namespace planewright
