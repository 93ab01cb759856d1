// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace planewright {

/// The noise that planes were estimated with: as told by the parameters, or as found in the scan itself.
struct SensorNoise {
    double rangeConstant = 0.0;      ///< standard deviation of a range at distance zero [m]
    double rangeProportional = 0.0;  ///< what distance adds to it, per metre (root of the sum of squares)
    double pitch = 0.0;              ///< standard deviation of a slice's pitch [rad]
    bool estimated = false;          ///< found in the scan
    double fineness = 1.0;           ///< of the lengths that decide, see Parameters::makeFiner
};

}  // namespace planewright
