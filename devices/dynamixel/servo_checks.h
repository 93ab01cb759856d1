// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "devices/dynamixel/control_table.h"
#include "devices/dynamixel/register_image.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// Why a servo that is set up like this must not be moved, and what its owner can do about it; empty where it may be.
/// Nothing that survives the power is ever written by us, so that the cure is always the owner's.
///
/// Looked at: limits that make it a wheel, modes that obey no goal, a locked EEPROM, and answers that are switched off.
std::optional<std::string> reasonNotToMove(const DynamixelModel& model, const RegisterImage& image);

/// Why a mounting is none, where it is none: sign, scale, limits or speed that cannot be.
std::optional<std::string> faultOf(const TiltMounting& mounting);

}  // namespace planewright
