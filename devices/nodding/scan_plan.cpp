// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/scan_plan.h"

#include <algorithm>
#include <cmath>

#include "core/types/angle_text.h"
#include "core/types/recording.h"

namespace planewright {

namespace {

/// A sweep may be off the wanted one by this share of its step.
constexpr double kMostOff = 0.1;
/// Decimals of a degree that small steps are told with.
constexpr int kFine = 4;
/// Angles are asked for with two decimals of a degree: what is beyond a limit by less is meant to be at it.
constexpr double kSlack = degrees(0.01);

Result<void> checkBearings(const ScanPlan& plan, const LaserLimits& laser)
{
    const double lowest = laser.bearing(laser.firstStep);
    const double highest = laser.bearing(laser.lastStep);
    if (plan.lastBearing <= plan.firstBearing)
        return fail(ErrorCode::Usage,
                    "the scan angle ends at " + degreesText(plan.lastBearing, 2) + ", where or before it begins");
    if (plan.firstBearing < lowest - kSlack || plan.lastBearing > highest + kSlack)
        return fail(ErrorCode::Usage, "the laser sees from " + degreesText(lowest, 2) + " to " +
                                          degreesText(highest, 2) + "; the plan asks for " +
                                          degreesText(plan.firstBearing, 2) + " to " +
                                          degreesText(plan.lastBearing, 2));
    return {};
}

/// As many whole clusters as there are: of a cluster that has fewer steps, nobody would know the bearing.
Result<LaserBeams> fitBeams(const ScanPlan& plan, const LaserLimits& laser)
{
    if (plan.cluster < 1 || plan.cluster > LaserBeams::kMostJoinedSteps)
        return fail(ErrorCode::Usage, "a laser joins 1 to " + std::to_string(LaserBeams::kMostJoinedSteps) +
                                          " steps to one range, not " + std::to_string(plan.cluster));
    LaserBeams beams;
    beams.first = std::max(laser.firstStep, laser.nearestStep(plan.firstBearing));
    beams.cluster = plan.cluster;
    const int steps = std::min(laser.lastStep, laser.nearestStep(plan.lastBearing)) - beams.first + 1;
    beams.last = beams.first + steps / plan.cluster * plan.cluster - 1;
    if (steps < 2 * plan.cluster)
        return fail(ErrorCode::Usage, "the scan angle has " + std::to_string(steps) + " steps of the laser: at " +
                                          std::to_string(plan.cluster) +
                                          " a range that is fewer than two ranges; join fewer, or widen it");
    return beams;
}

bool isWithin(const ScanPlan& plan, double pitchStep, const TiltUnit& unit)
{
    const double first = plan.firstPitch;
    const double last = first + (plan.slices - 1) * pitchStep;
    return std::min(first, last) >= unit.lowest() - kSlack && std::max(first, last) <= unit.highest() + kSlack;
}

Result<void> checkPitches(const ScanPlan& plan, const TiltUnit& unit)
{
    const double first = plan.pitch(0);
    const double last = plan.pitch(plan.slices - 1);
    if (!isWithin(plan, plan.pitchStep, unit))
        return fail(ErrorCode::Usage, "the tilt unit may go from " + degreesText(unit.lowest(), 2) + " to " +
                                          degreesText(unit.highest(), 2) + "; the plan asks for " +
                                          degreesText(first, 2) + " to " + degreesText(last, 2));
    return {};
}

/// The nearest speed that the unit has, and may have; the next lower one where the slices would leave its limits.
/// Errors (Usage): it is too coarse for the plan.
Result<double> sweepSpeed(const ScanPlan& plan, double wanted, double sliceTime, const TiltUnit& unit)
{
    const double unitOfSpeed = unit.speedStep();
    if (unitOfSpeed <= 0.0 || plan.slices == 1)
        return wanted;
    const double most = std::max(1.0, std::floor(unit.fastest() / unitOfSpeed + 1e-9));
    double units = std::clamp(std::round(wanted / unitOfSpeed), 1.0, most);
    const auto stepOf = [&](double count) { return std::copysign(count * unitOfSpeed * sliceTime, plan.pitchStep); };
    if (units > 1.0 && !isWithin(plan, stepOf(units), unit))
        units -= 1.0;
    const double step = std::abs(stepOf(units));
    if (std::abs(step / std::abs(plan.pitchStep) - 1.0) > kMostOff || !isWithin(plan, stepOf(units), unit))
        return fail(ErrorCode::Usage,
                    "the tilt unit has only speeds that are multiples of " + degreesText(unitOfSpeed, kFine) +
                        " a second, so a sweep cannot have steps of " + degreesText(plan.pitchStep, kFine) +
                        "; give a step of " + degreesText(stepOf(units), kFine) + ", or step and stare");
    return units * unitOfSpeed;
}

}  // namespace

Result<FittedPlan> fitPlan(const ScanPlan& plan, const LaserLimits& laser, const TiltUnit& unit)
{
    if (plan.slices < 1 || plan.slices > kMaxSlices)
        return fail(ErrorCode::Usage,
                    "a scan has 1 to " + std::to_string(kMaxSlices) + " slices, not " + std::to_string(plan.slices));
    if (!std::isfinite(plan.pitchStep) ||
        (plan.pitchStep == 0.0 && (plan.slices > 1 || plan.mode == ScanPlan::Mode::Continuous)))
        return fail(ErrorCode::Usage, "the tilt step must not be 0");
    if (!(plan.travelSpeed > 0.0))
        return fail(ErrorCode::Usage, "the travel speed must be above 0");
    if (const auto checked = checkBearings(plan, laser); !checked)
        return tl::unexpected{checked.error()};
    if (const auto checked = checkPitches(plan, unit); !checked)
        return tl::unexpected{checked.error()};

    FittedPlan fitted;
    const Result<LaserBeams> steps = fitBeams(plan, laser);
    if (!steps)
        return tl::unexpected{steps.error()};
    fitted.steps = *steps;
    fitted.beams = steps->count();
    fitted.firstBearing = steps->firstBearing(laser);
    fitted.bearingStep = steps->bearingStep(laser);
    fitted.points = static_cast<double>(fitted.beams) * plan.slices;
    fitted.pitchStep = plan.pitchStep;
    const std::chrono::duration<double> turn = laser.period;
    if (plan.mode == ScanPlan::Mode::Continuous) {
        // A step too wide for one turn takes several, of which one is a slice.
        const double fastest = unit.fastest();
        fitted.turnsPerSlice =
            std::max(1, static_cast<int>(std::ceil(std::abs(plan.pitchStep) / (fastest * turn.count()) - 1e-9)));
        const double sliceTime = fitted.turnsPerSlice * turn.count();
        const auto speed = sweepSpeed(plan, std::abs(plan.pitchStep) / sliceTime, sliceTime, unit);
        if (!speed)
            return tl::unexpected{speed.error()};
        fitted.sweepSpeed = *speed;
        if (plan.slices > 1)
            fitted.pitchStep = std::copysign(*speed * sliceTime, plan.pitchStep);
        fitted.time = turn * fitted.turnsPerSlice * plan.slices;
    } else {
        const double speed = std::min(plan.travelSpeed, unit.fastest());
        const std::chrono::duration<double> move{std::abs(plan.pitchStep) / speed};
        fitted.time = std::ceil((move + plan.settle + turn) / turn - 1e-9) * turn * plan.slices;
    }
    return fitted;
}

}  // namespace planewright
