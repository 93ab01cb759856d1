// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/test_words.h"

namespace planewright {

std::span<const TestWords> allTestWords()
{
    using enum TestAbout;
    using enum TestScale;
    using Keys = std::array<std::string_view, 2>;
    static constexpr std::array kTestWords{
        TestWords{"points", Piece, "points", Count, Keys{"segments.min-points", ""},
                  "How many points the piece had; those beside it may have taken some of them. By likelihood fewer do "
                  "where beams are wider apart."},
        TestWords{"length", Piece, "length", Metre, Keys{"segments.min-length", ""},
                  "From the first point of the piece to the last."},
        TestWords{"points_of_run", Piece, "points of the run", Count, Keys{},
                  "How many points are between two breakpoints; one alone is no line."},
        TestWords{"points_of_line", Piece, "points for a line", Count, Keys{},
                  "How many points the piece had when its run was divided; the line of so few rests on its ends."},
        TestWords{"line_distance", Piece, "off the line", Metre,
                  Keys{"segments.split-distance", "segments.split-sigmas"},
                  "How far the point is from the line of the piece beside it. The limit is larger where the point is "
                  "noisy."},
        TestWords{"line_chi2", Piece, "χ² to the line", ChiSquare, Keys{},
                  "Squared distance of the point from the line of the piece beside it, in variances."},
        TestWords{"plane_distance", Any, "D", Metre,
                  Keys{"assignment.plane-distance", "assignment.plane-distance-sigmas"},
                  "How far the farther end of the segment is from the plane. The limit is larger where that end "
                  "is noisy."},
        TestWords{"plane_distance", Move, "D", Metre, Keys{},
                  "How far the farther end of the segment is from the other plane; the limit is what it is from "
                  "its own."},
        TestWords{"plane_distance", Merge, "D", Metre, Keys{"planes.merge-distance", "planes.merge-sigmas"},
                  "The largest distance of an end point of one plane's segments from the other plane. The limit "
                  "is larger where that end is noisy."},
        TestWords{"orthogonality", Any, "|n·δ|", Plain,
                  Keys{"assignment.orthogonality", "assignment.orthogonality-sigmas"},
                  "Sine of the angle between the segment and the plane. The limit is larger for short segments."},
        TestWords{"contested", Join, "leans out", Flag, Keys{"planes.run-lean", "planes.run-step"},
                  "Whether the segment is of a run that leans out of this young plane."},
        TestWords{"contested", Any, "contested", Share, Keys{"planes.max-contested", "planes.run-lean"},
                  "Share of the plane that is on runs of segments which lean out of it."},
        TestWords{"in_other_plane", Any, "in another plane", Flag, Keys{},
                  "Whether the segment already belongs to another plane; then it can only move."},
        TestWords{"distance_of_next", Any, "D", Metre, Keys{},
                  "How far the segment is from the plane; the limit is its distance from the nearest other "
                  "plane that it fits."},
        TestWords{"distance_of_own", Any, "D", Metre, Keys{},
                  "How far the segment is from the plane; the limit is its distance from its own plane."},
        TestWords{"direction_similarity", Any, "|δ·δ|", Cosine, Keys{"clusters.direction-limit", ""},
                  "Cosine of the angle between the segment and the nearest cluster's direction. Where it fails, "
                  "the segment begins a new cluster."},
        TestWords{"similarity", Any, "|δ·δ|", Cosine, Keys{"clusters.direction-limit", ""},
                  "Cosine of the angle between the segment and the nearest cluster's direction. Where it fails, "
                  "the segment begins a new cluster."},
        TestWords{"cluster_segments", Any, "segments", Count, Keys{"planes.min-cluster-segments", ""},
                  "A cluster is searched for planes when it holds so many segments."},
        TestWords{"cluster_slices", Any, "slices", Count, Keys{"planes.min-cluster-slices", ""},
                  "A cluster is searched for planes when its segments are of so many slices."},
        TestWords{"segments", Any, "segments", Count, Keys{"planes.min-segments", ""},
                  "How many segments the plane has."},
        TestWords{"segments", Absorb, "segments", Count, Keys{},
                  "The larger plane has more segments than the smaller one."},
        TestWords{"slices", Any, "slices", Count, Keys{"planes.min-slices", ""},
                  "How many slices the plane's segments are of."},
        TestWords{"points", Any, "points", Count, Keys{"planes.min-points", ""}, "How many scan points the plane has."},
        TestWords{"points", Keep, "points", Count, Keys{"likelihood.min-solid-angle", "likelihood.enough-points"},
                  "How many scan points the plane has, against those that fill the smallest solid angle of a "
                  "plane."},
        TestWords{
            "spread_points", Any, "points, spread", Count, Keys{},
            "How many scan points the plane has, each counted by how far slices are apart there: next to the pitch "
            "axis all slices see the same."},
        TestWords{"extent", Any, "extent", Metre, Keys{"planes.min-extent", "planes.min-extent-angle"},
                  "How far the plane's segments reach in its shorter direction. The limit grows with range."},
        TestWords{"normal_sigma", Any, "σ of n", Angle, Keys{"planes.max-normal-sigma", ""},
                  "How well the plane's normal is known: its largest standard deviation."},
        TestWords{"normal_sigma", Seed, "σ of n", Angle, Keys{"likelihood.seed-angle", ""},
                  "How well the normal of the three segments' plane is known: its largest standard deviation."},
        TestWords{"incidence", Any, "incidence", Sine, Keys{"planes.min-incidence", ""},
                  "Angle at which the laser's rays meet the plane on average; a slice's own plane is none."},
        TestWords{"contradictions", Any, "segments standing off", Count, Keys{},
                  "Segments that face the plane and stand a little off it, as steps do off a stair's slope; no "
                  "more than it has itself."},
        TestWords{"fitting_error", Any, "E", Plain, Keys{"planes.error-limit", ""},
                  "Fitting error: mean squared Mahalanobis distance of the end points from the plane, Eq. (16)."},
        TestWords{"fitting_error", Merge, "E", Plain, Keys{"planes.error-limit", ""},
                  "Fitting error of either plane's end points to the plane of both, the larger of the two."},
        TestWords{"normal_alignment", Any, "|n·n|", Cosine, Keys{"planes.merge-angle", "planes.merge-sigmas"},
                  "Cosine of the angle between the two planes, Eq. (21). The limit is lower where a normal is "
                  "not well known."},
        TestWords{"normal_alignment", Tracks, "|n·n|", Cosine, Keys{},
                  "Cosine of the angle between the two planes; those that differ more are not compared."},
        TestWords{"in_plane_gap", Any, "gap", Metre, Keys{"planes.merge-gap", ""},
                  "Gap between the two planes' segments along the plane; none where they face each other."},
        TestWords{"shared_segments", Any, "shared", Share, Keys{"planes.merge-share", ""},
                  "Share of the smaller plane's segments that fit the larger one."},
        TestWords{"facing", Any, "faces it", Flag, Keys{},
                  "Whether the segment faces one of the plane's segments in the slices around it."},
        TestWords{"certain_elsewhere", Any, "χ² of the best", ChiSquare, Keys{},
                  "Whether the segment fits the plane beside it so well that no other is asked."},
        TestWords{"steepness", Any, "plane to slice", SquaredSine, Keys{},
                  "Angle between the plane and the slice: a slice's own plane takes every line."},
        TestWords{"join_chi2", Any, "χ²", ChiSquare, Keys{"likelihood.join-gate", "likelihood.apart-gate"},
                  "How badly the segment fits the plane, with the covariances of both: 2 degrees of freedom. "
                  "The limit is smaller for a plane that it does not face."},
        TestWords{"join_chi2", Known, "χ²", ChiSquare, Keys{"likelihood.apart-gate", ""},
                  "How badly the segment fits the plane that it does not face, with the covariances of both: 2 "
                  "degrees of freedom."},
        TestWords{"join_chi2", Move, "χ²", ChiSquare, Keys{},
                  "How badly the segment fits the other plane; the limit is how badly it fits its own, less 2."},
        TestWords{"rival_chi2", Any, "χ²", ChiSquare, Keys{},
                  "How badly the segment fits the plane; the limit is how badly it fits the plane that it fits "
                  "best."},
        TestWords{"fits_facing_plane", Any, "fits a facing plane", Flag, Keys{},
                  "Whether the segment fits a plane that it faces; then no other is asked."},
        TestWords{"normal_variance", Any, "σ of n", Variance, Keys{"likelihood.known-angle", ""},
                  "How well the plane's normal is known: its standard deviation."},
        TestWords{"place_sigma", Any, "σ there", Metre, Keys{},
                  "How well the plane tells where it is at the segment, as a standard deviation; the limit is what the "
                  "segment itself tells."},
        TestWords{"slices_away", Any, "slices away", Count, Keys{},
                  "How many slices ago the plane met a segment last; after eight it is out of sight."},
        TestWords{"own_chi2", Any, "χ² to its own", ChiSquare, Keys{},
                  "How badly the segment fits its own plane; one that fits well stays."},
        TestWords{"moved_chi2", Any, "χ² + 2", ChiSquare, Keys{},
                  "How badly the segment fits the other plane, and 2 more; the limit is how badly it fits its "
                  "own."},
        TestWords{"near_chi2", Any, "χ², near", ChiSquare, Keys{"likelihood.merge-gate", ""},
                  "How far the planes are from each other by their covariances: 3 degrees of freedom. Below "
                  "this limit they are looked at more closely."},
        TestWords{"scattered_chi2", Any, "χ², scattered", ChiSquare, Keys{"likelihood.merge-gate", ""},
                  "The same with covariances that grow by as much as the planes' segments scatter."},
        TestWords{"adjacent", Any, "side by side", Flag, Keys{"likelihood.merge-angle", ""},
                  "Whether segments of the two planes are beside each other, or both normals are known so well "
                  "that it does not matter."},
        TestWords{"merge_chi2", Any, "χ²", ChiSquare, Keys{"likelihood.merge-gate", ""},
                  "How far the planes are from each other by their covariances: 3 degrees of freedom."},
        TestWords{
            "parts_chi2", Any, "χ² of the parts", ChiSquare, Keys{"likelihood.merge-gate", "likelihood.chance-planes"},
            "How far the plane of a part that lies apart is from the plane of the others, by their covariances: 3 "
            "degrees of freedom. The limit is lower where little is known of them, so that another plane may lie "
            "there by chance."},
        TestWords{
            "deviance", Any, "−2 ln p", Plain, Keys{},
            "How badly the other plane foretells the segment: minus twice the logarithm of the probability density "
            "of its place and slope, 9.2 less where that plane is on both sides of it. The limit is how badly the "
            "others of its own plane do, less 2."},
        TestWords{"worse_together", Any, "E of both / E", Plain, Keys{},
                  "How much worse one plane explains the segments of both than each explains its own."},
        TestWords{"seed_chi2", Any, "χ²", ChiSquare, Keys{"likelihood.seed-gate", ""},
                  "How badly the three segments lie in one plane: 3 degrees of freedom."},
        TestWords{"pair_chi2", Any, "χ²", ChiSquare, Keys{"likelihood.join-gate", ""},
                  "How badly the two segments lie in one plane."},
        TestWords{"parallel_chi2", Any, "χ², parallel", ChiSquare, Keys{},
                  "How badly the plane of the two segments is parallel to the best of the other planes."},
        TestWords{"run_gain", Any, "χ² gained", ChiSquare, Keys{},
                  "How much better a plane of its own explains the run that leans out."},
        TestWords{"contested_share", Any, "contested", Share, Keys{"planes.max-contested", "planes.run-lean"},
                  "Share of the plane's points that are on runs of segments which lean out of it."},
        TestWords{"contested_remains", Any, "remains", Share, Keys{},
                  "Share of the plane's points that were on planes taken apart before, which it lies like."},
        TestWords{"reduced_chi2", Any, "χ² / freedom", Plain, Keys{"likelihood.split-sigmas", ""},
                  "How badly the plane's segments fit it, over their degrees of freedom."},
        TestWords{"free_strip_share", Any, "stands free", Share,
                  Keys{"likelihood.strip-share", "likelihood.strip-width"},
                  "Share of its slices in which a narrow plane stands free on both sides, as a pole does."},
        TestWords{"bent_share", Any, "bent", Share, Keys{"likelihood.bent-share", ""},
                  "Share of the plane's points that are in segments which are no straight lines."},
    };
    return kTestWords;
}

}  // namespace planewright
