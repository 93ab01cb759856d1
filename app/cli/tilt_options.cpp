// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/tilt_options.h"

#include <cmath>
#include <optional>

#include "app/cli/angle_range.h"
#include "core/types/angle.h"
#include "core/types/recording.h"

namespace planewright {

Result<void> takeTilt(const std::string& tilt, int slices, AcquisitionSettings& settings)
{
    if (!tilt.empty()) {
        const auto most = slices > 0 ? std::nullopt : std::optional{kMaxSlices};
        const auto range = parseAngleRange("--tilt", tilt, RangeEnd::Open, most);
        if (!range)
            return tl::unexpected{range.error()};
        settings.firstTilt = range->first;
        settings.tiltStep = range->step;
        settings.slices = range->count;
    }
    if (slices > 0)
        settings.slices = slices;
    if (std::abs(settings.firstTilt + settings.tiltStep * (settings.slices - 1)) > degrees(360.0))
        return fail(ErrorCode::Usage, "--slices: the last of so many slices tilts beyond 360 degrees; give fewer");
    return {};
}

}  // namespace planewright
