// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/params/presets.h"

namespace planewright {

/// The parameters of preset `precise`.
inline Parameters precise()
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), "precise"), parameters);
    return parameters;
}

}  // namespace planewright
