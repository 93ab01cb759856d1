// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "tests/benchmarks/room_accuracy.h"

namespace planewright {

/// Prints the true planes of a room that were missed, what was found that is none, and planes far from the truth.
void printDetails(const Room& room, const RoomAccuracy& accuracy);

}  // namespace planewright
