// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/params/parameters.h"
#include "core/planes/segment_table.h"

namespace planewright {

/// A plane that has grown to this many segments is settled: whether it is contested is asked no more.
inline constexpr std::size_t kSettled = 100;

/// Segments that follow each other from slice to slice in small steps: a piece of one surface, wherever others are.
struct SegmentRun {
    std::vector<SegmentNumber> segments;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of the plane of least squares through their end points
    double distance = 0.0;                              ///< [m]
};

/// The run around a segment, over the neighbouring slices on both sides, with steps no longer than `planes.run-step`.
///
/// It is flat: all its end points are within T of its plane; where it is not, it is cut shorter, from the end that
/// strays more. None where fewer than three segments are left.
std::optional<SegmentRun> runAround(SegmentNumber segment, const SegmentTable& table,
                                    const PlaneParameters& parameters);

/// Whether a segment is on a run that leans out of a plane: a plane of its own explains the run better than this one
/// by more than chance, χ² of three degrees of freedom at 97 %. False where the segment is on no run.
///
/// An addition to the paper. Explained is what was measured, the ranges: a plane met at a shallow angle lets them
/// stray by centimetres where a steep one lets them stray by millimetres, so the slope over the edges of a stair, to
/// which all end points are near, explains less than its risers do.
bool isContested(SegmentNumber segment, const Eigen::Vector3d& normal, double distance, const SegmentTable& table,
                 const PlaneParameters& parameters);

/// Share of a plane's segments that contest it, told by a dozen of them spread over the plane; 0 without segments.
double contestedShare(const std::vector<SegmentNumber>& members, const Eigen::Vector3d& normal, double distance,
                      const SegmentTable& table, const PlaneParameters& parameters);

}  // namespace planewright
