// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "core/formats/scan_extra.h"
#include "core/types/recording.h"

namespace planewright {

/// Keys that a recording has only where its beams are not evenly spaced, or its pitch axis does not lie to the right:
/// `beam_bearings_deg` (a bearing for each beam, separated by blanks), `beam_image_pitch_deg` (of a flat image) and
/// `frame_quaternion` (w x y z of ScanDescription::attitude).
bool isGeometryKey(std::string_view key);

/// The description's extra keys and, after them, those of its geometry.
ExtraKeys keysOf(const ScanDescription& description);

/// Takes the keys of the geometry out of the extra ones, when all else is known of the description. What is wrong with
/// them, with the key's name; empty where nothing is.
std::string takeGeometryKeys(ScanDescription& description);

/// The description as it is read back from a recording, in the geometry of its beams too.
ScanDescription asWritten(ScanDescription description);

}  // namespace planewright
