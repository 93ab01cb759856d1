// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/pipeline/plane_lives.h"

namespace planewright {

/// What happened to a plane of a family, told once where it happened to several.
struct FamilyEvent {
    PlaneId plane = kNoPlane;
    LifeEventKind kind = LifeEventKind::Fitted;
    int step = 0;                 ///< −1: in the forced last pass
    int order = 0;                ///< running number over all planes' events
    std::vector<PlaneId> others;  ///< the other planes of it
    std::vector<ClusterId> from;  ///< of Fitted: the clusters that its first segments were in
    int segments = 0;             ///< of the plane after it; 0 where it is no more

    friend bool operator==(const FamilyEvent&, const FamilyEvent&) = default;
};

/// A plane's life as a bar over the steps.
struct LifeBar {
    PlaneId plane = kNoPlane;
    int first = 0;  ///< moment of its birth: a step, or the moment after the last one for the forced last pass
    int last = 0;   ///< moment at which it ended, or the newest one
    bool isOver = false;
    std::vector<PlaneLife::Size> sizes;  ///< with moments for steps
};

/// A line between two bars: what one plane handed on to another.
struct LifeJoint {
    int from = 0;  ///< place of the bar
    int to = 0;
    int moment = 0;
    std::size_t event = 0;  ///< place of what it stands for
};

/// A family of planes as a graph.
struct LineageChart {
    std::vector<LifeBar> bars;  ///< in order of id
    std::vector<LifeJoint> joints;
    std::vector<FamilyEvent> events;  ///< as they happened
    int newestStep = -1;              ///< of the scan; the forced last pass comes at the moment after it
    bool hasLastPass = false;
    int mostSegments = 1;

    int lastMoment() const { return newestStep + (hasLastPass ? 1 : 0); }
    int momentOf(int step) const { return step < 0 ? newestStep + 1 : step; }
    int stepOf(int moment) const { return moment > newestStep ? -1 : moment; }
    std::optional<std::size_t> barOf(PlaneId plane) const;
};

/// The graph of some planes, in order of id; the scan has come to a newest step, and to its forced last pass or not.
LineageChart lineageChart(const PlaneLives& lives, const std::vector<PlaneId>& family, int newestStep,
                          bool hasLastPass);

/// "P07 split into P15, P16"
QString eventText(const FamilyEvent& event);

}  // namespace planewright
