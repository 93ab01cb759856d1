// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "core/mapping/building_map.h"

namespace planewright {

/// What a stop's place rests on, in a word or two.
std::string trustText(StopTrust trust);

/// What a person must know who uses a stop's place, and what to do; empty where it is fixed by planes, all along.
std::string warningOf(const MapStop& stop);

}  // namespace planewright
