// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/former_extractions.h"

#include <utility>

namespace planewright {

namespace {

constexpr std::size_t kMostFormer = 8;

}  // namespace

void FormerExtractions::replace(ScanHistory& present, ScanHistory next)
{
    former_.push_back(std::exchange(present, std::move(next)));
    if (former_.size() > kMostFormer)
        former_.erase(former_.begin());
    takenBack_.clear();
}

bool FormerExtractions::exchange(ScanHistory& present, Stack& from, Stack& to)
{
    if (from.empty())
        return false;
    to.push_back(std::exchange(present, std::move(from.back())));
    from.pop_back();
    return true;
}

void FormerExtractions::clear()
{
    former_.clear();
    takenBack_.clear();
}

}  // namespace planewright
