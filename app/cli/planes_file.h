// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "core/formats/plane_record.h"
#include "core/types/error.h"

namespace planewright {

/// Reads the planes of a result, .csv or .json. Errors: Usage for another suffix, Unreadable otherwise.
Result<std::vector<PlaneRecord>> readPlanesFile(const std::string& path);

}  // namespace planewright
