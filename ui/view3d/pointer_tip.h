// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QString>

#include "ui/common/shown_map.h"
#include "ui/scene/scene_pick.h"

namespace planewright {

/// What is said at the pointer about what is there; empty for what has no words.
QString pointerTip(const Picked& picked, const ShownMap& map);

}  // namespace planewright
