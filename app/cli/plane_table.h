// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>

#include "core/formats/plane_result.h"

namespace planewright {

/// A short table of planes for people to read.
std::string planeTable(std::span<const PlaneResult> planes);

}  // namespace planewright
