// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/types/snapshot.h"

namespace planewright {

/// What changed a plane from a surface of its own, or to one.
enum class LifeEventKind {
    Fitted,      ///< was made of segments that belonged to no plane
    SplitFrom,   ///< was made of a part of others
    SplitInto,   ///< parts of it became planes of their own
    MergedFrom,  ///< took in another
    MergedInto,  ///< went into another, and is no more
    TakenApart,  ///< became others, and is no more
    Deleted,     ///< its segments belong to no plane any more
};

struct LifeEvent {
    LifeEventKind kind = LifeEventKind::Fitted;
    int step = 0;                   ///< −1: in the forced last pass
    int order = 0;                  ///< running number over all planes' events
    std::vector<PlaneId> others;    ///< the other planes of it
    std::vector<ClusterId> from{};  ///< of Fitted: the clusters that its first segments were in
};

/// A plane from its first step to its last.
struct PlaneLife {
    /// Its segments after a step that changed their number.
    struct Size {
        int step = 0;
        int segments = 0;
    };

    PlaneId id = kNoPlane;
    std::vector<LifeEvent> events;  ///< in the order in which they happened; the first is its birth
    std::vector<Size> sizes;        ///< empty for one that no snapshot shows: made and gone in one step
    bool isOver = false;            ///< the last event is its end

    int bornStep() const { return events.front().step; }
};

/// Where planes come from and what becomes of them, from the snapshots of a scan with explained reports. Of reports
/// without decisions it knows what the planes themselves say: no clusters, and no planes that were made and gone in one
/// step.
class PlaneLives {
public:
    /// The next step of the scan; its report has every decision.
    void add(const Snapshot& snapshot);

    /// All planes that there were, in order of id, but for those that were given up in the step that made them.
    const std::map<PlaneId, PlaneLife>& lives() const { return lives_; }

    /// The planes that a plane came from and those that it became, and their own, with itself, in order of id: their
    /// events are the edges of its family tree. Empty for a plane that there was not.
    std::vector<PlaneId> familyOf(PlaneId plane) const;

    /// The planes that are after another step what a plane is at one step: itself where it is there, what was split
    /// from it or what it went into since; or, back in time, what it was split from and what it took in. `to` and
    /// `from` are steps of the scan, −1 the forced last pass.
    std::vector<PlaneId> follow(PlaneId plane, int from, int to) const;

    /// Whether the snapshot of a step shows a plane.
    bool isThere(PlaneId plane, int step) const;

private:
    void hear(const Decision& decision);
    void fit(const Decision& decision, PlaneId plane);
    void split(const Decision& decision, PlaneId plane);
    void merge(PlaneId first, PlaneId second, PlaneId kept);
    PlaneId dissolvedOwner(const SegmentId& segment) const;
    void endDissolved();
    void compare(const Snapshot& snapshot);
    void forgetGivenUp();
    LifeEvent& happen(PlaneId plane, LifeEventKind kind, std::vector<PlaneId> others);

    /// A plane that is no more, with what was made of its segments.
    struct Dissolved {
        int order = 0;
        std::vector<PlaneId> parts;
    };

    std::map<PlaneId, PlaneLife> lives_;
    std::map<SegmentId, ClusterId> clusters_;                // that a segment joined last
    std::map<PlaneId, std::shared_ptr<const Plane>> shown_;  // after the step before
    int events_ = 0;
    int step_ = 0;                            // that is added
    std::map<PlaneId, Dissolved> dissolved_;  // in this step
    std::vector<PlaneId> made_;               // in this step
    std::map<SegmentId, PlaneId> joined_;     // in this step
};

}  // namespace planewright
