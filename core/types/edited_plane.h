// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/types/plane.h"

namespace planewright {

/// A plane as the operator sees it: found by an extraction or made by an edit, with what was said about it.
struct EditedPlane {
    std::shared_ptr<const Plane> plane;
    std::string name;       ///< empty if none
    std::string className;  ///< given by the operator, or else floor, ceiling, wall or other
    bool hidden = false;
    bool locked = false;
};

/// Ids of planes that edits make begin here: no extraction counts as far, so that they stay what they are while a scan
/// runs on.
inline constexpr PlaneId kFirstEditedPlane = 1'000'000;

}  // namespace planewright
