// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/formats/plane_record.h"

namespace planewright {

/// Collects the planes of a file and holds them against what every planes file must fulfil.
class PlaneRecordList {
public:
    /// Adds a plane, its normal brought to length 1 and both turned so that d ≥ 0. Gives what is wrong with it and what
    /// to do, or nothing.
    std::string add(PlaneRecord plane);

    std::vector<PlaneRecord> take() && { return std::move(planes_); }

private:
    std::vector<PlaneRecord> planes_;
    std::unordered_set<PlaneId> ids_;
};

}  // namespace planewright
