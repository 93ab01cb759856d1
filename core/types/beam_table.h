// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace planewright {

struct ScanDescription;
struct ScanSlice;

/// Bearings of beams that are not evenly spaced.
///
/// A scanner's are the same in every slice. Those of a flat image (a depth camera, whose row is a slice) draw together
/// as the row goes away from the middle: cot θ is in proportion to cos(φ − imageTilt).
struct BeamTable {
    std::vector<double> bearings;     ///< of each beam [rad], rising
    std::optional<double> imageTilt;  ///< of a flat image: the pitch φ at which the bearings are these [rad]

    /// False for the pitch of a row [rad] that no image has: at a right angle to its middle, or beyond.
    bool isSeenAt(double tilt) const { return !imageTilt || std::cos(tilt - *imageTilt) > 0.01; }
};

/// The bearings at a pitch [rad]: the table's own, shared, or a list of their own for a row of an image.
std::shared_ptr<const std::vector<double>> bearingsAt(const std::shared_ptr<const BeamTable>& table, double tilt);

/// Lays the beams of a slice, whose tilt is known, as the description says.
void layBeams(ScanSlice& slice, const ScanDescription& description);

}  // namespace planewright
