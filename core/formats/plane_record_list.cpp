// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/plane_record_list.h"

#include <cmath>

#include "core/formats/number_text.h"

namespace planewright {

namespace {
constexpr double kLengthTolerance = 1e-3;  // files written by hand have few digits
}

std::string PlaneRecordList::add(PlaneRecord plane)
{
    if (planes_.size() == kMaxPlaneRecords)
        return "more than " + std::to_string(kMaxPlaneRecords) + " planes; give a smaller file";
    if (plane.id < 0)
        return "the id " + std::to_string(plane.id) + " is negative; ids count from 0";
    if (plane.points && *plane.points < 0)
        return "plane " + std::to_string(plane.id) + " has a negative number of points; correct it";
    if (!ids_.insert(plane.id).second)
        return "the id " + std::to_string(plane.id) + " is there twice; give every plane its own";
    const double length = plane.normal.norm();
    if (!(std::abs(length - 1.0) <= kLengthTolerance))
        return "the normal of plane " + std::to_string(plane.id) + " has the length " + formatNumber(length) +
               "; a normal has the length 1";
    plane.normal /= length;
    makeCanonical(plane.normal, plane.distance);
    planes_.push_back(std::move(plane));
    return {};
}

}  // namespace planewright
