// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/formats/cloud_recording.h"

namespace planewright {

inline void require(bool holds)
{
    if (!holds)
        std::abort();
}

/// What any reader of clouds promises: points are finite and near, and have beams that there are; and a recording that
/// is made of them is one that files can hold. Errors name what they are about.
inline void checkCloud(Result<CloudScan> cloud)
{
    if (!cloud) {
        require(!cloud.error().message.empty());
        return;
    }
    require(cloud->slices.size() <= static_cast<std::size_t>(kMaxSlices) && cloud->beams <= kMaxBeams);
    for (const CloudSlice& slice : cloud->slices) {
        for (const CloudPoint& point : slice) {
            require(point.place.allFinite() && point.place.norm() <= 1001.0F);
            require(point.beam >= 0 && (cloud->beams == 0 || point.beam < cloud->beams));
        }
    }
    const auto made = recordingOf(std::move(*cloud), "cloud");
    if (!made)
        return;
    const ScanDescription& description = made->recording.description;
    require(description.beams >= 2 && description.bearingStep > 0.0 && description.rangeMax > 0.0);
    for (const ScanSlice& slice : made->recording.slices) {
        require(slice.ranges.size() == static_cast<std::size_t>(description.beams));
        require(!slice.bearings || slice.bearings->size() == slice.ranges.size());
        require(std::abs(slice.tilt) <= 6.3);
    }
}

}  // namespace planewright
