// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>

#include "core/params/sensor_parameters.h"
#include "core/types/angle.h"

namespace planewright {

/// Noise of the scanner and of its pitch angle, Eq. (15).
struct NoiseParameters {
    double rangeConstant = 0.008;
    double rangeProportional = 0.001;
    double bearing = degrees(0.02);
    double pitch = degrees(0.084);
    bool pitchCommon = true;
    double systematic = 0.0;
    bool estimated = false;

    /// Variance σ_ρ² of a range [m²]: the squares of the constant and of the proportional part.
    double rangeVariance(double range) const
    {
        const double proportional = rangeProportional * range;
        return rangeConstant * rangeConstant + proportional * proportional;
    }
};

/// Tolerances of line-segment extraction (section 4.1).
struct SegmentParameters {
    double incidenceLimit = degrees(10.0);
    double breakpointSigmas = 3.0;
    double splitDistance = 0.03;
    double splitSigmas = 5.0;
    double mergeAngle = degrees(2.0);
    double mergeAngleSigmas = 3.0;
    double mergeGap = 0.25;
    double mergeGapSteps = 5.0;
    double minLength = 0.2;
    int minPoints = 7;
};

/// When a segment joins a plane (section 4.1.4).
struct AssignmentParameters {
    double planeDistance = 0.03;
    double planeDistanceSigmas = 3.5;
    double orthogonality = degrees(5.0);
    double orthogonalitySigmas = 3.0;
    int refitEvery = 10;
};

/// How a cluster's direction follows its segments (section 4.2).
enum class MovingAverage { Simple, LinearlyWeighted, ExponentiallyWeighted };

/// Grouping of unassigned segments by direction (section 4.2).
struct ClusterParameters {
    MovingAverage average = MovingAverage::ExponentiallyWeighted;
    double directionLimit = degrees(10.0);
    double decay = 0.5;
};

/// The distance that plane fitting minimises and the split test reads.
enum class PlaneCost { MaximumLikelihood, Foot };

/// Fitting, splitting and merging of planes (sections 4.3 and 4.4).
struct PlaneParameters {
    PlaneCost cost = PlaneCost::MaximumLikelihood;
    double flatness = 0.005;
    int minClusterSegments = 5;
    int minClusterSlices = 4;
    double baselineSigmas = 4.0;
    double inlierDistance = 0.03;
    double inlierSigmas = 2.5;
    double errorLimit = 4.0;
    double refineTolerance = 1e-6;
    int refineIterations = 10;
    int minSegments = 4;
    int minSlices = 3;
    int minPoints = 60;
    double minExtent = 0.08;
    double minExtentAngle = degrees(1.5);
    double maxNormalSigma = degrees(8.0);
    double minIncidence = degrees(3.0);
    double runStep = 0.09;
    double runLean = degrees(15.0);
    double maxContested = 0.25;
    double mergeAngle = degrees(5.0);
    double mergeDistance = 0.025;
    double mergeSigmas = 5.0;
    double mergeGap = 0.5;
    double mergeShare = 0.6;
};

/// How planes are estimated.
enum class Estimator { EndPoints, Likelihood };

/// The method as a whole.
struct MethodParameters {
    Estimator estimator = Estimator::EndPoints;
};

/// Tests of the estimator by likelihood: chi-squares that carry the covariances of segment and plane.
struct LikelihoodParameters {
    double joinGate = 25.0;
    double apartGate = 6.0;
    double knownAngle = 0.03;
    double seedGate = 11.3;
    double seedAngle = 0.2;
    double mergeGate = 25.0;
    double mergeAngle = 0.01;
    double chancePlanes = 0.0;
    double finalGate = 12.0;
    double splitSigmas = 3.0;
    double minSolidAngle = 0.0106;
    int enoughPoints = 120;
    double stripWidth = 0.12;
    double stripShare = 0.6;
    double bentShare = 0.5;

    /// Largest χ² over its degrees of freedom that a plane plausibly has.
    double largestReducedChi(double freedom) const { return 1.0 + splitSigmas * std::sqrt(2.0 / freedom); }
};

/// When the phases of Table I run; step counts from 0.
struct ScheduleParameters {
    int fitEvery = 5;
    int splitAndMergeEvery = 7;
    int remainingEvery = 5;

    bool fitsPlanesAt(int step) const { return (step + 1) % fitEvery == 0; }
    bool splitsAndMergesAt(int step) const { return (step + 1) % splitAndMergeEvery == 0; }
    bool fitsRemainingAt(int step) const { return (step + 1) % remainingEvery == 0; }
};

/// All parameters of an extraction, as one value.
struct Parameters {
    MethodParameters method;
    NoiseParameters noise;
    SensorParameters sensor;
    SegmentParameters segments;
    AssignmentParameters assignment;
    ClusterParameters clusters;
    PlaneParameters planes;
    LikelihoodParameters likelihood;
    ScheduleParameters schedule;

    /// How far ranges of a segment may be off together [m]: real walls are not flat, and scanners err together.
    double flatnessFloor() const
    {
        constexpr double kSystematicSigmas = 3.0;
        return std::max(planes.flatness, kSystematicSigmas * noise.systematic);
    }

    /// Makes the lengths smaller by which a scan's scale would decide: what is a bend, how uneven a wall is and how
    /// wide a pole. A cupboard is measured by a finer scanner than a hall.
    void makeFiner(double fineness)
    {
        segments.splitDistance *= fineness;
        planes.flatness *= fineness;
        likelihood.stripWidth *= fineness;
    }
};

}  // namespace planewright
