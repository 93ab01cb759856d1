// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/plane_lives.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace planewright {

namespace {

/// Steps in the order of time: the forced last pass comes after all.
int momentOf(int step)
{
    return step < 0 ? std::numeric_limits<int>::max() : step;
}

/// The plane that an operand names; kNoPlane for other operands.
PlaneId namedPlane(const Operand& operand)
{
    const auto* plane = std::get_if<PlaneRef>(&operand);
    return plane == nullptr ? kNoPlane : plane->id;
}

void addOnce(int number, std::vector<int>& numbers)
{
    if (std::find(numbers.begin(), numbers.end(), number) == numbers.end())
        numbers.push_back(number);
}

bool leadsOn(LifeEventKind kind)
{
    return kind == LifeEventKind::SplitInto || kind == LifeEventKind::MergedInto || kind == LifeEventKind::TakenApart;
}

bool leadsBack(LifeEventKind kind)
{
    return kind == LifeEventKind::SplitFrom || kind == LifeEventKind::MergedFrom;
}

/// Follows planes over the events that one plane hands on to another.
struct Walk {
    const std::map<PlaneId, PlaneLife>& lives;
    bool back = false;
    int after = -1;  ///< events of later moments
    int until = std::numeric_limits<int>::max();
    std::set<std::pair<PlaneId, int>> seen{};
    std::set<PlaneId> met{};

    void visit(PlaneId plane, int order)
    {
        const auto life = lives.find(plane);
        if (life == lives.end() || !seen.insert({plane, order}).second)
            return;
        met.insert(plane);
        for (const LifeEvent& event : life->second.events) {
            const int moment = momentOf(event.step);
            const bool isInTime =
                moment > after && moment <= until && (back ? event.order < order : event.order > order);
            if (!isInTime || !(back ? leadsBack(event.kind) : leadsOn(event.kind)))
                continue;
            for (const PlaneId other : event.others)
                visit(other, event.order);
        }
    }
};

}  // namespace

LifeEvent& PlaneLives::happen(PlaneId plane, LifeEventKind kind, std::vector<PlaneId> others)
{
    PlaneLife& life = lives_[plane];
    life.id = plane;
    life.events.push_back({kind, step_, events_++, std::move(others)});
    return life.events.back();
}

void PlaneLives::add(const Snapshot& snapshot)
{
    step_ = snapshot.report.step;
    for (const Decision& decision : snapshot.report.decisions)
        hear(decision);
    endDissolved();
    compare(snapshot);
    forgetGivenUp();
}

void PlaneLives::hear(const Decision& decision)
{
    const PlaneId result = decision.result.empty() ? kNoPlane : namedPlane(decision.result.front());
    switch (decision.kind) {
        case DecisionKind::Assign:
            joined_[std::get<SegmentId>(decision.operands.front())] = result;
            break;
        case DecisionKind::Cluster:
            clusters_[std::get<SegmentId>(decision.operands.front())] =
                std::get<ClusterRef>(decision.result.front()).id;
            break;
        case DecisionKind::Fit:
            fit(decision, result);
            break;
        case DecisionKind::Split:
            split(decision, namedPlane(decision.operands.front()));
            break;
        case DecisionKind::Merge:
            merge(namedPlane(decision.operands[0]), namedPlane(decision.operands[1]), result);
            break;
        case DecisionKind::NoFit:
            // A plane among the operands was one, and is none any more.
            if (const PlaneId plane = namedPlane(decision.operands.front()); plane != kNoPlane)
                dissolved_[plane] = {events_++, {}};
            break;
        case DecisionKind::Reject:
        case DecisionKind::Near:
            break;
    }
}

/// The plane that has just been dissolved and that a segment belonged to until then; kNoPlane where there is none.
PlaneId PlaneLives::dissolvedOwner(const SegmentId& segment) const
{
    if (const auto joined = joined_.find(segment); joined != joined_.end())
        return dissolved_.contains(joined->second) ? joined->second : kNoPlane;
    for (const auto& [plane, gone] : dissolved_) {
        const auto shown = shown_.find(plane);
        if (shown != shown_.end() &&
            std::binary_search(shown->second->segments.begin(), shown->second->segments.end(), segment))
            return plane;
    }
    return kNoPlane;
}

/// A plane is made of segments: free ones, or those of planes that have just been taken apart.
void PlaneLives::fit(const Decision& decision, PlaneId plane)
{
    std::vector<PlaneId> parents;
    std::vector<ClusterId> from;
    for (const Operand& operand : decision.operands) {
        if (const auto* cluster = std::get_if<ClusterRef>(&operand))
            addOnce(cluster->id, from);
        const auto* segment = std::get_if<SegmentId>(&operand);
        if (segment == nullptr)
            continue;
        const PlaneId owner = dissolvedOwner(*segment);
        if (shown_.contains(owner))
            addOnce(owner, parents);
        else if (owner != kNoPlane) {
            // It was given up in this very step: what it was made of counts.
            for (const PlaneId parent : lives_[owner].events.front().others)
                addOnce(parent, parents);
        }
        if (const auto cluster = clusters_.find(*segment); cluster != clusters_.end())
            addOnce(cluster->second, from);
        joined_[*segment] = plane;
    }
    for (const PlaneId parent : parents) {
        if (const auto gone = dissolved_.find(parent); gone != dissolved_.end())
            addOnce(plane, gone->second.parts);
    }
    made_.push_back(plane);
    if (parents.empty())
        happen(plane, LifeEventKind::Fitted, {}).from = std::move(from);
    else
        happen(plane, LifeEventKind::SplitFrom, std::move(parents));
}

/// A plane loses parts and goes on, or is taken apart as a whole.
void PlaneLives::split(const Decision& decision, PlaneId plane)
{
    if (decision.result.empty()) {
        dissolved_[plane] = {events_++, {}};
        return;
    }
    std::vector<PlaneId> parts;
    for (const Operand& operand : decision.result) {
        if (namedPlane(operand) != plane)
            parts.push_back(namedPlane(operand));
    }
    if (parts.empty())
        return;
    for (const PlaneId part : parts) {
        made_.push_back(part);
        happen(part, LifeEventKind::SplitFrom, {plane});
    }
    happen(plane, LifeEventKind::SplitInto, std::move(parts));
}

void PlaneLives::merge(PlaneId first, PlaneId second, PlaneId kept)
{
    const PlaneId gone = kept == first ? second : first;
    happen(kept, LifeEventKind::MergedFrom, {gone});
    happen(gone, LifeEventKind::MergedInto, {kept});
    lives_[gone].isOver = true;
}

void PlaneLives::endDissolved()
{
    for (auto& [plane, gone] : std::exchange(dissolved_, {})) {
        const LifeEventKind end = gone.parts.empty() ? LifeEventKind::Deleted : LifeEventKind::TakenApart;
        LifeEvent& last = happen(plane, end, std::move(gone.parts));
        last.order = gone.order;
        lives_[plane].isOver = true;
    }
}

/// Takes over the sizes of the planes, begins those that nobody told of, and ends those that are there no more.
void PlaneLives::compare(const Snapshot& snapshot)
{
    joined_.clear();
    shown_.clear();
    for (const auto& plane : snapshot.planes) {
        shown_[plane->id] = plane;
        if (!lives_.contains(plane->id)) {
            const bool isPart = plane->lineage.kind == Lineage::Kind::Split;
            happen(plane->id, isPart ? LifeEventKind::SplitFrom : LifeEventKind::Fitted,
                   isPart ? plane->lineage.parents : std::vector<PlaneId>{});
        }
        std::vector<PlaneLife::Size>& sizes = lives_[plane->id].sizes;
        const auto size = static_cast<int>(plane->segments.size());
        if (sizes.empty() || sizes.back().segments != size)
            sizes.push_back({step_, size});
    }
    for (auto& [id, life] : lives_) {
        if (life.isOver || shown_.contains(id))
            continue;
        const auto heir = std::find_if(snapshot.planes.begin(), snapshot.planes.end(), [id = id](const auto& plane) {
            const std::vector<PlaneId>& parents = plane->lineage.parents;
            return plane->lineage.kind == Lineage::Kind::Merged &&
                   std::find(parents.begin(), parents.end(), id) != parents.end();
        });
        if (heir != snapshot.planes.end()) {
            merge(id, (*heir)->id, (*heir)->id);
            continue;
        }
        happen(id, LifeEventKind::Deleted, {});
        life.isOver = true;
    }
}

/// Planes that were made and deleted in one step have left no trace.
void PlaneLives::forgetGivenUp()
{
    for (const PlaneId plane : std::exchange(made_, {})) {
        const auto life = lives_.find(plane);
        const std::vector<LifeEvent>& events = life->second.events;
        if (events.size() != 2 || !life->second.sizes.empty() || events.back().kind != LifeEventKind::Deleted)
            continue;
        for (const PlaneId parent : events.front().others) {
            for (LifeEvent& event : lives_[parent].events)
                std::erase(event.others, plane);
            LifeEvent& end = lives_[parent].events.back();
            if (end.kind == LifeEventKind::TakenApart && end.others.empty())
                end.kind = LifeEventKind::Deleted;
        }
        lives_.erase(life);
    }
}

bool PlaneLives::isThere(PlaneId plane, int step) const
{
    const auto life = lives_.find(plane);
    return life != lives_.end() && momentOf(life->second.bornStep()) <= momentOf(step) &&
           !(life->second.isOver && momentOf(life->second.events.back().step) <= momentOf(step));
}

std::vector<PlaneId> PlaneLives::familyOf(PlaneId plane) const
{
    Walk ancestors{lives_, true};
    ancestors.visit(plane, std::numeric_limits<int>::max());
    Walk descendants{lives_, false};
    descendants.visit(plane, -1);
    std::set<PlaneId> family = std::move(ancestors.met);
    family.merge(descendants.met);
    return {family.begin(), family.end()};
}

std::vector<PlaneId> PlaneLives::follow(PlaneId plane, int from, int to) const
{
    const int before = momentOf(from);
    const int after = momentOf(to);
    const bool back = after < before;
    Walk walk{lives_, back, std::min(before, after), std::max(before, after)};
    walk.visit(plane, back ? std::numeric_limits<int>::max() : -1);
    std::vector<PlaneId> found;
    for (const PlaneId met : walk.met) {
        if (isThere(met, to))
            found.push_back(met);
    }
    return found;
}

}  // namespace planewright
