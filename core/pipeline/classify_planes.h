// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/types/plane.h"
#include "core/types/segment_log.h"

namespace planewright {

/// What planes are by their normal and height: `wall`, where plumb within 15°; `floor` or `ceiling`, where level within
/// 15° and at the height of the lowest level plane below the laser, or of the highest above it; `other`. A level plane
/// with less than a fifth of the points of the largest on its side sets no height: it may be a step, or a reflection.
///
/// One for each plane, in their order. The frame must be level.
std::vector<std::string_view> classesOf(const std::vector<std::shared_ptr<const Plane>>& planes, const SegmentLog& log);

}  // namespace planewright
