// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose.h"

namespace planewright {

/// A return as a point in space.
struct CloudPoint {
    Eigen::Vector3f place = Eigen::Vector3f::Zero();  ///< from the scanner [m]
    int beam = 0;                                     ///< its number in the slice, where the cloud has numbers
};

/// The returns of one sweep in the order of their beams.
using CloudSlice = std::vector<CloudPoint>;

/// A scan that is told as points: slice after slice in the order of measurement, x right, y forward, z up, the scanner
/// at the origin.
struct CloudScan {
    std::vector<CloudSlice> slices;  ///< all of them; one without returns is empty
    int beams = 0;                   ///< in a slice; 0 where the points have no numbers
    std::string scanner;             ///< what a recording calls it
    std::optional<Pose> pose;        ///< from the scan's frame to the one that the file places it in
    std::vector<std::string> notes;  ///< what was taken how, for people
};

/// Divides points in the order of measurement into sweeps: one ends where the bearing turns back, or leaps by more than
/// 45°. Of a scanner that sweeps to and fro, the first point after a turn belongs to the sweep that it begins.
std::vector<CloudSlice> splitSweeps(std::span<const Eigen::Vector3f> points);

}  // namespace planewright
