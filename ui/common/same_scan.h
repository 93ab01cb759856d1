// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "ui/common/shown_map.h"

namespace planewright {

/// True where two maps are of one scan and one extraction: they share the segments of their first slice. Only then do
/// equal ids and revisions mean the same plane. Maps before the first slice are of no scan.
inline bool isSameScan(const ShownMap& a, const ShownMap& b)
{
    const auto begun = [](const ShownMap& map) { return map.snapshot && map.snapshot->segments.slices() > 0; };
    return begun(a) && begun(b) && &a.snapshot->segments.slice(0) == &b.snapshot->segments.slice(0);
}

}  // namespace planewright
