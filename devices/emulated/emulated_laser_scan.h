// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "devices/emulated/emulated_laser_model.h"
#include "devices/scip/scip_request.h"

namespace planewright {

/// Bytes of an emulated laser's replies.
///
/// A reply: echo, status, and what else belongs to it; the lines end with their sums already.
std::string laserReply(std::string_view echo, std::string_view status, const std::vector<std::string>& lines = {});

/// A line of a VV, PP or II reply.
std::string laserField(std::string_view key, std::string_view value);

/// What a laser sends for a beam: millimetres, or the model's code where there is no return (0).
std::uint32_t laserCode(std::uint32_t millimetres, const EmulatedLaserModel& model);

/// A scan as it is sent. `beams`: what is sent for each beam, before some share a value; `status` 99 in a stream.
std::string laserScan(std::string_view echo, std::string_view status, const ScipMeasurement& measurement,
                      std::uint32_t stamp, const std::vector<std::uint32_t>& beams, const EmulatedLaserModel& model);

/// Bytes of a scan whose echo has so many characters.
std::size_t laserScanSize(const ScipMeasurement& measurement, std::size_t echo);

}  // namespace planewright
