// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/params/parameters.h"
#include "core/types/edit.h"
#include "core/types/edited_plane.h"
#include "core/types/recording.h"
#include "core/types/snapshot.h"

namespace planewright {

/// The planes of a snapshot after its edits.
struct EditedPlanes {
    std::vector<EditedPlane> planes;    ///< in order of id; deleted ones are gone, hidden ones are here
    std::vector<std::string> problems;  ///< of each edit that was not applied, which and why
};

/// Applies edits, those that are not undone, in their order. The snapshot stays as it is, and planes that no edit
/// changes are shared with it.
///
/// A merge makes one plane of all segments of several, refitted by the estimator that found them; it has the name,
/// class, and hidden state of the first. A split searches the segments of a plane for planes anew. What they make has
/// new ids from kFirstEditedPlane on, the same for the same edits, and the lineage of a merge or split; names and
/// classes of a plane that was split are gone. Classes that nobody has given are those of classesOf.
///
/// `description` and `parameters` are what the snapshot was extracted with. An edit of a plane that is not there, or is
/// locked, or a merge or split that gives no plane, or no second one, is a problem and changes nothing.
EditedPlanes applyEdits(const Snapshot& snapshot, std::span<const Edit> edits, const ScanDescription& description,
                        const Parameters& parameters);

/// The snapshot with these planes in place of its own, for results that go by segments: labels, points, segments.
Snapshot withPlanes(const Snapshot& snapshot, const EditedPlanes& edited);

}  // namespace planewright
