// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include "core/params/parameters.h"

namespace planewright {

/// Fitting error above which a plane is split; empty where E has no limit, and each segment is tested instead.
inline std::optional<double> errorLimitOf(const Parameters& parameters)
{
    return parameters.method.estimator == Estimator::EndPoints ? std::optional(parameters.planes.errorLimit)
                                                               : std::nullopt;
}

}  // namespace planewright
