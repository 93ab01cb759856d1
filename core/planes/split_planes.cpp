// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <utility>

#include "core/planes/segment_run.h"
#include "core/planes/split_and_merge.h"

namespace planewright {

namespace {

/// Hypotheses that a split starts from at most; neighbouring segments start nearly the same one.
constexpr std::size_t kSplitSeeds = 48;

std::vector<Candidate> candidatesOf(const std::vector<SegmentNumber>& members)
{
    std::vector<Candidate> candidates;
    candidates.reserve(members.size());
    const std::size_t stride = members.size() / kSplitSeeds + 1;
    for (std::size_t i = 0; i < members.size(); ++i)
        candidates.push_back({members[i], i % stride == 0});
    return candidates;
}

/// Replaces the plane at a place in the map by its parts.
void split(std::size_t place, const Test& why, PlaneMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const PlaneId id = map.planes[place].id();
    const int bornStep = map.planes[place].bornStep();
    std::vector<SegmentNumber> left = map.planes[place].members();
    std::vector<FoundPlane> parts = partsOf(left, map.segments, parameters.planes);
    for (const SegmentNumber segment : map.planes[place].members())
        map.segments.owner(segment) = kNoPlane;

    std::vector<Operand> result;
    if (parts.empty()) {
        map.planes.erase(map.planes.begin() + static_cast<std::ptrdiff_t>(place));
    } else {
        const auto largest = std::max_element(parts.begin(), parts.end(), [](const FoundPlane& a, const FoundPlane& b) {
            return a.members.size() < b.members.size();
        });
        std::rotate(parts.begin(), largest, largest + 1);
        const bool several = parts.size() > 1;
        for (const SegmentNumber segment : parts.front().members)
            map.segments.owner(segment) = id;
        GrowingPlane kept(id, parts.front().fit, std::move(parts.front().members), map.segments, parameters.planes,
                          bornStep);
        kept.continueFrom(map.planes[place], map.step);
        map.planes[place] = std::move(kept);
        result.emplace_back(PlaneRef{id});
        for (std::size_t i = 1; i < parts.size(); ++i) {
            GrowingPlane& part = map.makePlane(parts[i].fit, std::move(parts[i].members), parameters.planes);
            part.setLineage({Lineage::Kind::Split, {id}});
            result.emplace_back(PlaneRef{part.id()});
        }
        if (several)
            map.plane(id).setLineage({Lineage::Kind::Split, {id}});
    }
    ++recorder.counts().splits;
    recorder.decide(DecisionKind::Split, {PlaneRef{id}}, {why}, std::move(result));
    addToClusters(left, map, parameters.clusters, recorder);
}

/// The test by which a plane is to be split, passed or not: its error, or, until it is settled and whenever it has
/// grown, the runs that have come up and lean out of it.
Test splitTest(GrowingPlane& plane, const SegmentTable& table, const PlaneParameters& parameters)
{
    const Test error{"fitting_error", plane.error(), Comparison::Greater, parameters.errorLimit};
    if (error.pass() || plane.members().size() >= kSettled || !plane.hasGrownSinceAsked())
        return error;
    return {"contested", contestedShare(plane.members(), plane.normal(), plane.distance(), table, parameters),
            Comparison::Greater, parameters.maxContested};
}

}  // namespace

std::vector<FoundPlane> partsOf(std::vector<SegmentNumber>& members, const SegmentTable& table,
                                const PlaneParameters& parameters)
{
    std::vector<FoundPlane> parts;
    while (auto found = findPlane(candidatesOf(members), table, parameters, nullptr)) {
        std::erase_if(members, [&](SegmentNumber segment) {
            return std::binary_search(found->members.begin(), found->members.end(), segment);
        });
        parts.push_back(std::move(*found));
    }
    return parts;
}

void splitPlanes(PlaneMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    // Parts pass the tests of new planes, and are appended: one pass sees every plane that was there.
    const std::size_t before = map.planes.size();
    std::vector<std::pair<PlaneId, Test>> grownWrong;
    for (std::size_t i = 0; i < before; ++i) {
        const Test test = splitTest(map.planes[i], map.segments, parameters.planes);
        if (test.pass())
            grownWrong.emplace_back(map.planes[i].id(), test);
    }
    for (const auto& [id, test] : grownWrong) {
        const auto place = std::find_if(map.planes.begin(), map.planes.end(),
                                        [id = id](const GrowingPlane& plane) { return plane.id() == id; });
        split(static_cast<std::size_t>(place - map.planes.begin()), test, map, parameters, recorder);
    }
}

}  // namespace planewright
