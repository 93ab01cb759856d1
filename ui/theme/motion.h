// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace planewright {

/// Whether somebody who uses this desktop has asked for as little motion as possible: nothing pulses then.
bool isMotionReduced();
/// What the desktop says of it, from now on.
void setMotionReduced(bool reduced);

}  // namespace planewright
