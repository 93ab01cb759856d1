// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/params/parameters.h"

namespace planewright {

/// Parameters in force from a step on.
struct ParametersFrom {
    int step = 0;
    Parameters parameters;
};

}  // namespace planewright
