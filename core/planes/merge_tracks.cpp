// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>

#include "core/planes/track_stages.h"

namespace planewright {

namespace {

/// Planes are compared anew once one of them has so many times the points it had.
constexpr double kGrown = 1.25;
/// |n·n| of planes that may be one at least.
constexpr double kAlignment = 0.9;
/// Beams within which segments of two planes count as side by side.
constexpr int kSideMargin = 20;
/// Pairs are told as nearly merged up to this many times the gate.
constexpr double kNearFactor = 4.0;

bool sideBySide(const PlaneTrack& a, const PlaneTrack& b, const TrackMap& map)
{
    for (const SegmentNumber number : a.members) {
        const int place = map.segment(number).slice;
        for (int other = place - map.lookback(place); other <= place + map.lookahead(place); ++other) {
            bool found = false;
            map.visitOverlaps(other, map.firstBeam(number), map.lastBeam(number), kSideMargin,
                              [&](SegmentNumber s) { found = found || map.segment(s).owner == b.id; });
            if (found)
                return true;
        }
    }
    return false;
}

}  // namespace

void mergeTracks(TrackMap& map, const Parameters& parameters, StepRecorder& recorder)
{
    const int step = map.slice(map.slices() - 1).step;
    const double gate = parameters.likelihood.mergeGate;
    const double known = parameters.likelihood.mergeAngle * parameters.likelihood.mergeAngle;
    for (PlaneTrack& plane : map.planes()) {
        if (plane.slicesUnsolved > 0 && plane.estimate.solve())
            plane.slicesUnsolved = 0;
    }
    for (std::size_t i = 0; i < map.planes().size(); ++i) {
        for (std::size_t j = i + 1; j < map.planes().size();) {
            PlaneTrack& a = map.planes()[i];
            PlaneTrack& b = map.planes()[j];
            const bool grown = static_cast<double>(a.points) > kGrown * static_cast<double>(a.comparedAt) ||
                               static_cast<double>(b.points) > kGrown * static_cast<double>(b.comparedAt);
            const double alignment = std::abs(a.estimate.normal().dot(b.estimate.normal()));
            if (!grown || alignment <= kAlignment) {
                ++j;
                continue;
            }
            const double chi = a.estimate.mergeChi(b.estimate, 0.5 * parameters.flatnessFloor(), 1.0);
            if (!(chi < kNearFactor * gate)) {
                ++j;
                continue;
            }
            const bool sharp = a.estimate.normalVariance() < known && b.estimate.normalVariance() < known;
            const bool beside = sharp || sideBySide(a, b, map);
            const bool merges = chi < gate && beside;
            if (recorder.explains())
                recorder.decide(merges ? DecisionKind::Merge : DecisionKind::Near, {PlaneRef{a.id}, PlaneRef{b.id}},
                                {{"normal_alignment", alignment, Comparison::Greater, kAlignment},
                                 {"merge_chi2", chi, Comparison::Less, gate},
                                 {"adjacent", beside ? 1.0 : 0.0, Comparison::GreaterEqual, 1.0}},
                                merges ? std::vector<Operand>{PlaneRef{a.points >= b.points ? a.id : b.id}}
                                       : std::vector<Operand>{});
            if (!merges) {
                ++j;
                continue;
            }
            PlaneTrack& kept = a.points >= b.points ? a : b;
            const PlaneTrack& gone = a.points >= b.points ? b : a;
            for (const SegmentNumber number : gone.members)
                map.segment(number).owner = kept.id;
            std::vector<SegmentNumber> all(kept.members.size() + gone.members.size());
            std::merge(kept.members.begin(), kept.members.end(), gone.members.begin(), gone.members.end(), all.begin());
            kept.members = std::move(all);
            kept.points += gone.points;
            kept.lastSlice = std::max(kept.lastSlice, gone.lastSlice);
            kept.slices = 0;
            int last = -1;
            for (const SegmentNumber number : kept.members) {
                kept.slices += map.segment(number).slice != last ? 1 : 0;
                last = map.segment(number).slice;
            }
            kept.lineage = {Lineage::Kind::Merged, {a.id, b.id}};
            map.rebuild(kept, parameters);
            map.touch(kept, step);
            kept.comparedAt = 0;
            ++recorder.counts().merges;
            map.planes().erase(map.planes().begin() + static_cast<std::ptrdiff_t>(a.points >= b.points ? j : i));
            // Whichever stayed is compared with all that follow once more.
            j = i + 1;
        }
    }
    for (PlaneTrack& plane : map.planes())
        plane.comparedAt = plane.points;
}

}  // namespace planewright
