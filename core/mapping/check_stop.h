// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/mapping/stop.h"
#include "core/types/error.h"

namespace planewright {

/// Fails with Unreadable, and names plane and reason, where a stop holds what no map can be made of: numbers that are
/// not finite, normals that are not of length 1, covariances that are not positive definite.
Result<void> checkStop(const Stop& stop);

}  // namespace planewright
