// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "core/params/parameter.h"
#include "core/params/parameters.h"
#include "core/types/angle.h"

/// What is said of each parameter. Apart from their values, since few sources read it and it takes long to compile.
namespace planewright {

template <>
struct ChoiceNames<Estimator> {
    static constexpr std::array<std::string_view, 2> names{"end-points", "likelihood"};
};

constexpr auto rowsOf(const MethodParameters& /*part*/)
{
    return std::tuple{
        Parameter{"method.estimator", &MethodParameters::estimator, Unit::Choice, Range{0.0, 1.0}, "",
                  "end-points is the published method; likelihood uses all points of a segment by their sums."},
    };
}
static_assert(defaultsAreInRange<MethodParameters>());

constexpr auto rowsOf(const NoiseParameters& /*part*/)
{
    return std::tuple{
        Parameter{"noise.range-constant", &NoiseParameters::rangeConstant, Unit::Metre, Range{0.0, 1.0}, "sigma_rho,0",
                  "Standard deviation of a range at distance zero."},
        Parameter{"noise.range-proportional", &NoiseParameters::rangeProportional, Unit::None, Range{0.0, 0.1},
                  "sigma_rho,1",
                  "What distance adds to the range's standard deviation, per metre (root of the sum of squares)."},
        Parameter{"noise.bearing", &NoiseParameters::bearing, Unit::Angle, Range{0.0, degrees(5.0)}, "sigma_theta",
                  "Standard deviation of a beam's bearing."},
        Parameter{"noise.pitch", &NoiseParameters::pitch, Unit::Angle, Range{0.0, degrees(5.0)}, "sigma_phi",
                  "Standard deviation of the measured pitch of a slice."},
        Parameter{"noise.systematic", &NoiseParameters::systematic, Unit::Metre, Range{0.0, 0.5}, "",
                  "What a slice's ranges may be off together, beside the noise of each; only planes by likelihood "
                  "allow for it."},
        Parameter{"noise.estimated", &NoiseParameters::estimated, Unit::Switch, Range{0.0, 1.0}, "",
                  "Range and pitch noise are found in the scan itself, from what is told here on; only planes by "
                  "likelihood. Where ranges scatter by less than half of that, segments.split-distance, "
                  "planes.flatness and likelihood.strip-width are less in proportion."},
        Parameter{"noise.pitch-common", &NoiseParameters::pitchCommon, Unit::Switch, Range{0.0, 1.0}, "",
                  "The pitch error is one for all points of a slice; otherwise each point has its own."},
    };
}
static_assert(defaultsAreInRange<NoiseParameters>());

constexpr auto rowsOf(const SensorParameters& /*part*/)
{
    return std::tuple{
        Parameter{"sensor.pitch-zero", &SensorParameters::pitchZero, Unit::Angle, Range{degrees(-45.0), degrees(45.0)},
                  "", "Is added to every measured pitch."},
        Parameter{"sensor.range-offset", &SensorParameters::rangeOffset, Unit::Metre, Range{-1.0, 1.0}, "",
                  "Is added to every return."},
        Parameter{"sensor.lever-arm-correction", &SensorParameters::leverArmCorrection, Unit::Metre, Range{-1.0, 1.0},
                  "d_l", "Is added to the distance from the pitch axis to the laser that the recording gives."},
        Parameter{"sensor.sweep-turn", &SensorParameters::sweepTurn, Unit::None, Range{-4.0, 4.0}, "",
                  "How far the head nods on while the laser sweeps, in steps from slice to slice, beyond what the "
                  "recording says."},
        Parameter{"sensor.pitch-delay", &SensorParameters::pitchDelay, Unit::None, Range{-4.0, 4.0}, "",
                  "How far the head nods on between the moment of the measured pitch and the first beam, in steps "
                  "from slice to slice."},
    };
}
static_assert(defaultsAreInRange<SensorParameters>());

constexpr auto rowsOf(const SegmentParameters& /*part*/)
{
    return std::tuple{
        Parameter{"segments.incidence-limit", &SegmentParameters::incidenceLimit, Unit::Angle,
                  Range{degrees(1.0), degrees(45.0)}, "lambda_u",
                  "Shallowest incidence at which two neighbouring points count as one surface, Eq. (3)."},
        Parameter{"segments.breakpoint-sigmas", &SegmentParameters::breakpointSigmas, Unit::None, Range{0.0, 20.0},
                  "3 sigma_d",
                  "Allowance for range noise in the breakpoint distance, in standard deviations, Eq. (3)."},
        Parameter{"segments.split-distance", &SegmentParameters::splitDistance, Unit::Metre, Range{0.0, 0.5}, "h_o",
                  "A run is split where a point lies farther than this from its chord."},
        Parameter{"segments.split-sigmas", &SegmentParameters::splitSigmas, Unit::None, Range{0.0, 20.0}, "h_o",
                  "The split distance is never less than this many standard deviations of the point across the chord."},
        Parameter{"segments.merge-angle", &SegmentParameters::mergeAngle, Unit::Angle, Range{0.0, degrees(45.0)},
                  "alpha_o", "Neighbouring pieces whose lines differ by less than this are merged, Eq. (4)."},
        Parameter{"segments.merge-angle-sigmas", &SegmentParameters::mergeAngleSigmas, Unit::None, Range{0.0, 20.0},
                  "alpha_o", "The merge angle is never less than this many standard deviations of the difference."},
        Parameter{"segments.merge-gap", &SegmentParameters::mergeGap, Unit::Metre, Range{0.0, 5.0}, "d_o",
                  "Largest gap between the end points of two pieces to be merged, Eq. (4)."},
        Parameter{"segments.merge-gap-steps", &SegmentParameters::mergeGapSteps, Unit::None, Range{0.0, 100.0}, "d_o",
                  "The merge gap is never less than this many distances between beams at that range."},
        Parameter{"segments.min-length", &SegmentParameters::minLength, Unit::Metre, Range{0.0, 10.0}, "L_min",
                  "Shorter segments are removed, Eq. (5)."},
        Parameter{"segments.min-points", &SegmentParameters::minPoints, Unit::Count, Range{4.0, 1000.0}, "N_e",
                  "Segments of fewer scan points are removed, Eq. (5); by likelihood, of fewer still where beams are "
                  "farther apart than 0.25 degrees."},
    };
}
static_assert(defaultsAreInRange<SegmentParameters>());

constexpr auto rowsOf(const AssignmentParameters& /*part*/)
{
    return std::tuple{
        Parameter{"assignment.plane-distance", &AssignmentParameters::planeDistance, Unit::Metre, Range{0.001, 1.0},
                  "D_m", "A segment joins a plane when its farther end point is nearer than this, Eq. (8)."},
        Parameter{"assignment.plane-distance-sigmas", &AssignmentParameters::planeDistanceSigmas, Unit::None,
                  Range{0.0, 20.0}, "D_m",
                  "The distance allowed is never less than this many standard deviations of the end point."},
        Parameter{"assignment.orthogonality", &AssignmentParameters::orthogonality, Unit::Angle,
                  Range{0.0, degrees(45.0)}, "epsilon_o",
                  "Largest angle between a segment and a plane that it joins, Eq. (8)."},
        Parameter{"assignment.orthogonality-sigmas", &AssignmentParameters::orthogonalitySigmas, Unit::None,
                  Range{0.0, 20.0}, "epsilon_o",
                  "The angle allowed is never less than this many standard deviations of the segment's direction."},
        Parameter{"assignment.refit-every", &AssignmentParameters::refitEvery, Unit::Count, Range{1.0, 10000.0}, "",
                  "A plane is fitted anew after this many added segments."},
    };
}
static_assert(defaultsAreInRange<AssignmentParameters>());

template <>
struct ChoiceNames<MovingAverage> {
    static constexpr std::array<std::string_view, 3> names{"sma", "lwma", "ewma"};
};

constexpr auto rowsOf(const ClusterParameters& /*part*/)
{
    return std::tuple{
        Parameter{
            "clusters.average", &ClusterParameters::average, Unit::Choice, Range{0.0, 2.0}, "",
            "Moving average of a cluster's direction: simple (10), linearly (11) or exponentially weighted (12)."},
        Parameter{"clusters.direction-limit", &ClusterParameters::directionLimit, Unit::Angle,
                  Range{degrees(0.1), degrees(90.0)}, "delta_c",
                  "Largest angle between a segment and the cluster that it joins, Eq. (9)."},
        Parameter{"clusters.decay", &ClusterParameters::decay, Unit::None, Range{0.0, 1.0}, "tau",
                  "Weight of the newest segment in the exponentially weighted average, Eq. (12)."},
    };
}
static_assert(defaultsAreInRange<ClusterParameters>());

template <>
struct ChoiceNames<PlaneCost> {
    static constexpr std::array<std::string_view, 2> names{"ml", "foot"};
};

constexpr auto rowsOf(const PlaneParameters& /*part*/)
{
    return std::tuple{
        Parameter{"planes.cost", &PlaneParameters::cost, Unit::Choice, Range{0.0, 1.0}, "E",
                  "Squared distance of an end point: ml is (n.p - d)^2/(n'Cn), foot is the printed Eq. (16)."},
        Parameter{"planes.flatness", &PlaneParameters::flatness, Unit::Metre, Range{0.0, 0.5}, "",
                  "How far real walls stray from a plane, as a standard deviation added to the noise."},
        Parameter{"planes.min-cluster-segments", &PlaneParameters::minClusterSegments, Unit::Count, Range{3.0, 10000.0},
                  "N_c", "A cluster is searched for planes from this many segments on."},
        Parameter{"planes.min-cluster-slices", &PlaneParameters::minClusterSlices, Unit::Count, Range{2.0, 10000.0},
                  "N_c", "A cluster is searched for planes when its segments come from this many slices."},
        Parameter{"planes.baseline-sigmas", &PlaneParameters::baselineSigmas, Unit::None, Range{0.0, 100.0}, "",
                  "The two nearest segments of a hypothesis are at least this many standard deviations of an end "
                  "point away."},
        Parameter{"planes.inlier-distance", &PlaneParameters::inlierDistance, Unit::Metre, Range{0.0001, 1.0}, "T",
                  "End points farther than this from a hypothesis do not support it, Eq. (14)."},
        Parameter{"planes.inlier-sigmas", &PlaneParameters::inlierSigmas, Unit::None, Range{0.0, 20.0}, "T",
                  "The inlier distance is never less than this many standard deviations of the end point."},
        Parameter{"planes.error-limit", &PlaneParameters::errorLimit, Unit::None, Range{0.1, 1000.0}, "e_f",
                  "With end points, a plane with a larger fitting error is not made, and is split if it grew to it; by "
                  "likelihood E has no limit."},
        Parameter{"planes.refine-tolerance", &PlaneParameters::refineTolerance, Unit::None, Range{1e-15, 0.1},
                  "epsilon_min", "Refinement ends when the error falls by less than this fraction, Table VI."},
        Parameter{"planes.refine-iterations", &PlaneParameters::refineIterations, Unit::Count, Range{1.0, 1000.0},
                  "i_max", "Most iterations of a refinement, Table VI."},
        Parameter{"planes.min-segments", &PlaneParameters::minSegments, Unit::Count, Range{2.0, 10000.0}, "",
                  "Fewest line segments that make a plane."},
        Parameter{"planes.min-slices", &PlaneParameters::minSlices, Unit::Count, Range{2.0, 10000.0}, "",
                  "Fewest slices that these segments come from."},
        Parameter{"planes.min-points", &PlaneParameters::minPoints, Unit::Count, Range{4.0, 1000000.0}, "",
                  "Fewest scan points of these segments."},
        Parameter{"planes.min-extent", &PlaneParameters::minExtent, Unit::Metre, Range{0.0, 100.0}, "",
                  "Shorter extent that a plane must have at least."},
        Parameter{"planes.min-extent-angle", &PlaneParameters::minExtentAngle, Unit::Angle, Range{0.0, degrees(45.0)},
                  "",
                  "The shorter extent must span this angle at the plane's mean range at least, half of it where rays "
                  "meet the plane head-on."},
        Parameter{
            "planes.max-normal-sigma", &PlaneParameters::maxNormalSigma, Unit::Angle,
            Range{degrees(0.01), degrees(45.0)}, "",
            "A plane's normal must be known to this standard deviation; by likelihood, where noise.systematic is 0."},
        Parameter{"planes.min-incidence", &PlaneParameters::minIncidence, Unit::Angle, Range{0.0, degrees(45.0)}, "",
                  "Rays must meet a new plane at this angle on average; a slice's own plane is none."},
        Parameter{"planes.run-step", &PlaneParameters::runStep, Unit::Metre, Range{0.0, 1.0}, "",
                  "Segments of neighbouring slices that are no farther apart than this make a run, a piece of one "
                  "surface."},
        Parameter{"planes.run-lean", &PlaneParameters::runLean, Unit::Angle, Range{0.0, degrees(90.0)}, "",
                  "A run contests a plane only if it leans out of it by more than this."},
        Parameter{"planes.max-contested", &PlaneParameters::maxContested, Unit::None, Range{0.0, 1.0}, "",
                  "A plane is not made, and is split, when a larger share of it is on runs that lean out of it."},
        Parameter{"planes.merge-angle", &PlaneParameters::mergeAngle, Unit::Angle, Range{0.0, degrees(45.0)}, "nu_o",
                  "Largest angle between two planes to be merged, Eq. (21)."},
        Parameter{"planes.merge-distance", &PlaneParameters::mergeDistance, Unit::Metre, Range{0.0, 1.0}, "delta_Pi",
                  "Largest distance between two planes to be merged, Eq. (22)."},
        Parameter{"planes.merge-sigmas", &PlaneParameters::mergeSigmas, Unit::None, Range{0.0, 20.0}, "delta_Pi",
                  "The merge distance is never less than this many standard deviations of both planes there."},
        Parameter{"planes.merge-gap", &PlaneParameters::mergeGap, Unit::Metre, Range{0.0, 1000.0}, "",
                  "Largest gap, measured in the planes, between two planes to be merged."},
        Parameter{"planes.merge-share", &PlaneParameters::mergeShare, Unit::None, Range{0.0, 1.0}, "",
                  "A plane of whose segments this share belongs to a larger plane as well is merged into it."},
    };
}
static_assert(defaultsAreInRange<PlaneParameters>());

constexpr auto rowsOf(const LikelihoodParameters& /*part*/)
{
    return std::tuple{
        Parameter{"likelihood.join-gate", &LikelihoodParameters::joinGate, Unit::None, Range{1.0, 1000.0}, "",
                  "A segment joins a plane that it faces below this chi-square of 2 degrees of freedom."},
        Parameter{"likelihood.apart-gate", &LikelihoodParameters::apartGate, Unit::None, Range{0.1, 1000.0}, "",
                  "The same for a plane that it does not face."},
        Parameter{"likelihood.known-angle", &LikelihoodParameters::knownAngle, Unit::Angle, Range{0.0, degrees(45.0)},
                  "", "A plane is joined without facing it when its normal is known to this standard deviation."},
        Parameter{"likelihood.seed-gate", &LikelihoodParameters::seedGate, Unit::None, Range{0.1, 1000.0}, "",
                  "Three segments make a plane below this chi-square of 3 degrees of freedom."},
        Parameter{"likelihood.seed-angle", &LikelihoodParameters::seedAngle, Unit::Angle, Range{0.0, degrees(45.0)}, "",
                  "Their plane's normal must be known to this standard deviation."},
        Parameter{"likelihood.merge-gate", &LikelihoodParameters::mergeGate, Unit::None, Range{0.1, 1000.0}, "",
                  "Two planes are one below this chi-square of 3 degrees of freedom."},
        Parameter{"likelihood.merge-angle", &LikelihoodParameters::mergeAngle, Unit::Angle, Range{0.0, degrees(45.0)},
                  "", "Planes that are not side by side merge when both normals are known to this standard deviation."},
        Parameter{
            "likelihood.chance-planes", &LikelihoodParameters::chancePlanes, Unit::None, Range{0.0, 1e6}, "",
            "Planes that lie there by chance, for each square degree of their normal and metre of their distance: "
            "parts of a plane that lie apart stay one while that is likelier. 0: the merge gate alone decides."},
        Parameter{"likelihood.final-gate", &LikelihoodParameters::finalGate, Unit::None, Range{1.0, 1000.0}, "",
                  "Segments beyond this chi-square take no part in the last fit."},
        Parameter{
            "likelihood.split-sigmas", &LikelihoodParameters::splitSigmas, Unit::None, Range{0.5, 1000.0}, "",
            "In the last pass a plane of at most 60 segments gives up its worst ones while its reduced chi-square "
            "is above 1 by so many standard deviations."},
        Parameter{"likelihood.min-solid-angle", &LikelihoodParameters::minSolidAngle, Unit::None, Range{0.0, 10.0}, "",
                  "A plane must fill this solid angle as seen from the laser, in steradians, or have enough points."},
        Parameter{"likelihood.enough-points", &LikelihoodParameters::enoughPoints, Unit::Count, Range{4.0, 1000000.0},
                  "", "A plane of so many scan points is large enough."},
        Parameter{"likelihood.strip-width", &LikelihoodParameters::stripWidth, Unit::Metre, Range{0.0, 10.0}, "",
                  "Narrower planes that stand free on both sides are poles, not planes."},
        Parameter{"likelihood.strip-share", &LikelihoodParameters::stripShare, Unit::None, Range{0.0, 1.0}, "",
                  "Share of its slices in which a narrow plane stands free to be a pole."},
        Parameter{"likelihood.bent-share", &LikelihoodParameters::bentShare, Unit::None, Range{0.0, 1.0}, "",
                  "A plane has at most this share of its points in segments that are no straight lines."},
    };
}
static_assert(defaultsAreInRange<LikelihoodParameters>());

constexpr auto rowsOf(const ScheduleParameters& /*part*/)
{
    return std::tuple{
        Parameter{"schedule.fit-every", &ScheduleParameters::fitEvery, Unit::Count, Range{1.0, 65536.0}, "",
                  "Planes are fitted to the clusters every this many steps, Table I line 8."},
        Parameter{"schedule.split-merge-every", &ScheduleParameters::splitAndMergeEvery, Unit::Count,
                  Range{1.0, 65536.0}, "", "Planes are split and merged every this many steps, Table I line 9."},
        Parameter{"schedule.remaining-every", &ScheduleParameters::remainingEvery, Unit::Count, Range{1.0, 65536.0}, "",
                  "Remaining segments are tried again every this many steps, Table I line 10."},
    };
}
static_assert(defaultsAreInRange<ScheduleParameters>());

/// The parts in the order in which people see them.
constexpr auto partsOfParameters()
{
    return std::tuple{&Parameters::method,   &Parameters::noise,      &Parameters::sensor,
                      &Parameters::segments, &Parameters::assignment, &Parameters::clusters,
                      &Parameters::planes,   &Parameters::likelihood, &Parameters::schedule};
}

}  // namespace planewright
