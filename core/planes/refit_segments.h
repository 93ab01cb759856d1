// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/params/parameters.h"
#include "core/types/recording.h"
#include "core/types/snapshot.h"

namespace planewright {

/// What planes of a snapshot's segments are fitted with again: the estimator and tolerances of its parameters, with the
/// noise that it says it was made with.
struct Refit {
    const Snapshot& snapshot;
    const ScanDescription& description;  ///< as it was extracted: corrected by `sensor.*`
    const Parameters& parameters;
};

/// The plane that these segments of the snapshot support together, all of them, wherever they came from. Nothing where
/// they determine none. The plane is canonical; its id, steps, revision and lineage are the caller's to set.
std::optional<Plane> refitPlane(std::span<const SegmentId> segments, const Refit& refit);

/// The planes that are found among these segments anew, as the method splits a plane that grew wrong, the one with the
/// most points first; some segments may be left in none. Set as above.
std::vector<Plane> searchPlanes(std::span<const SegmentId> segments, const Refit& refit);

}  // namespace planewright
