// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/acquisition_settings.h"

#include <array>
#include <string>

namespace planewright {

namespace {

/// A column of Table X. The paper gives the width of the tilt range; where it begins is taken from Table VIII.
AcquisitionSettings tableX(double tiltStep, int slices, double firstBearing, double bearingStep, int beams)
{
    AcquisitionSettings settings;
    settings.tiltStep = tiltStep;
    settings.slices = slices;
    settings.firstBearing = firstBearing;
    settings.bearingStep = bearingStep;
    settings.beams = beams;
    return settings;
}

/// The most that the product is made for: all round the pitch axis, all that the laser sees.
AcquisitionSettings largest()
{
    AcquisitionSettings settings;
    settings.slices = 1024;
    settings.firstTilt = 0.0;
    settings.tiltStep = degrees(180.0) / (settings.slices - 1);
    settings.firstBearing = degrees(-45.0);
    settings.beams = 1081;
    return settings;
}

const std::array kPresets{
    NamedSettings{"table8", AcquisitionSettings{}},
    NamedSettings{"table10-1", tableX(degrees(2.32), 56, degrees(0.0), degrees(0.5), 361)},
    NamedSettings{"table10-2", tableX(degrees(1.16), 111, degrees(0.0), degrees(0.5), 361)},
    NamedSettings{"table10-3", tableX(degrees(1.16), 120, degrees(0.0), degrees(0.25), 721)},
    NamedSettings{"table10-4", tableX(degrees(1.16), 137, degrees(-20.0), degrees(0.25), 881)},
    NamedSettings{"table10-5", tableX(degrees(0.58), 257, degrees(-10.0), degrees(0.25), 801)},
    NamedSettings{"table10-6", tableX(degrees(0.58), 274, degrees(-20.0), degrees(0.25), 881)},
    NamedSettings{"table10-7", tableX(degrees(0.29), 444, degrees(0.0), degrees(0.25), 721)},
    NamedSettings{"table10-8", tableX(degrees(0.29), 513, degrees(-10.0), degrees(0.25), 801)},
    NamedSettings{"largest", largest()},
};

}  // namespace

std::span<const NamedSettings> acquisitionPresets()
{
    return kPresets;
}

Result<AcquisitionSettings> acquisitionSettings(std::string_view name)
{
    std::string known;
    for (const NamedSettings& preset : kPresets) {
        if (preset.name == name)
            return preset.settings;
        known += (known.empty() ? "" : ", ") + std::string(preset.name);
    }
    return fail(ErrorCode::Usage,
                "No acquisition setting is called '" + std::string(name) + "'. Known: " + known + ".");
}

}  // namespace planewright
