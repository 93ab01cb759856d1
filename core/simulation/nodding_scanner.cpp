// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/simulation/nodding_scanner.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/geometry/sensor_model.h"
#include "core/simulation/random.h"
#include "core/simulation/ray_caster.h"

namespace planewright {

namespace {

/// The draws of one beam. Every beam makes all of them, so that its errors do not depend on what the others hit.
struct BeamDraws {
    double bearing;  ///< standard normal
    double range;    ///< standard normal
    double dropout;  ///< uniform in [0, 1)
    double edge;     ///< uniform in [0, 1)
};

BeamDraws drawBeam(Random& random)
{
    const Random::Pair normal = random.normalPair();
    const double dropout = random.uniform();
    return {normal.first, normal.second, dropout, random.uniform()};
}

/// Share of a round footprint beyond an edge at x half-widths from its middle.
double shareBeyond(double x)
{
    return (std::acos(x) - x * std::sqrt(1.0 - x * x)) / std::numbers::pi;
}

bool liesOnAnotherSurface(const RayHit& hit, const RayHit& centre)
{
    return hit.label != centre.label || (hit.label == kNotPlanar && hit.surface != centre.surface);
}

/// The range that a beam of some width measures whose centre hits a surface: at a depth edge between both depths.
///
/// The sub-rays at half the footprint's width in bearing and in pitch tell whether there is an edge and how far it is
/// to what lies beyond; where in the footprint the edge lies is drawn.
double footprintRange(const RayCaster& caster, double bearing, const RayHit& centre, const SimulationNoise& noise,
                      double edgeDraw)
{
    const double half = 0.5 * noise.footprint;
    const double s = std::sin(bearing);
    const double c = std::cos(bearing);
    const double along = std::cos(half);
    const double off = std::sin(half);
    const Eigen::Vector3d subRays[]{{c * along - s * off, s * along + c * off, 0.0},
                                    {c * along + s * off, s * along - c * off, 0.0},
                                    {c * along, s * along, off},
                                    {c * along, s * along, -off}};

    double sum = 0.0;
    int count = 0;
    for (const Eigen::Vector3d& subRay : subRays) {
        const std::optional<RayHit> hit = caster.cast(subRay);
        if (!hit || !liesOnAnotherSurface(*hit, centre))
            continue;
        if (std::abs(hit->range - centre.range) <= 3.0 * noise.rangeSigma(centre.range))
            continue;
        sum += hit->range;
        ++count;
    }
    if (count == 0)
        return centre.range;
    return centre.range + shareBeyond(edgeDraw) * (sum / count - centre.range);
}

struct Measurement {
    double range = 0.0;
    int label = kNoTruePlane;
};

Measurement measure(const RayCaster& caster, double bearing, const SensorModel& sensor, const SimulationNoise& noise,
                    const BeamDraws& draws)
{
    const double trueBearing = bearing + noise.bearing * draws.bearing;
    const std::optional<RayHit> hit = caster.cast({std::cos(trueBearing), std::sin(trueBearing), 0.0});
    if (!hit || draws.dropout < 1.0 - (1.0 - noise.dropout) * (1.0 - hit->dropout))
        return {};

    const double seen = noise.mixedPixels ? footprintRange(caster, trueBearing, *hit, noise, draws.edge) : hit->range;
    const double sigma = noise.rangeSigma(hit->range);
    const double range = seen + sigma * draws.range;
    if (!sensor.hasEcho(range))
        return {};
    return {range, std::abs(seen - hit->range) > 3.0 * sigma ? kNoTruePlane : hit->label};
}

}  // namespace

ScanDescription describeScan(const AcquisitionSettings& settings)
{
    ScanDescription description;
    description.scanner = "UTM-30LX";
    description.firstBearing = settings.firstBearing;
    description.bearingStep = settings.bearingStep;
    description.beams = settings.beams;
    description.rangeMin = settings.rangeMin;
    description.rangeMax = settings.rangeMax;
    description.pitchAxisOffset = settings.pitchAxisOffset;
    return description;
}

SimulatedSlice simulateSlice(const Scene& scene, const AcquisitionSettings& settings, const SimulationNoise& noise,
                             std::uint64_t seed, int step)
{
    Random random(seed, static_cast<std::uint64_t>(step));
    const double pitchError = noise.pitch * random.normalPair().first;
    const SensorModel sensor = sensorOf(describeScan(settings));
    const double offset = settings.pitchAxisOffset;
    const auto beams = static_cast<std::size_t>(settings.beams);

    SimulatedSlice result;
    ScanSlice& slice = result.slice;
    slice.step = step;
    slice.time = step * settings.sliceTime;
    slice.tilt = settings.firstTilt + step * settings.tiltStep;
    slice.firstBearing = settings.firstBearing;
    slice.bearingStep = settings.bearingStep;
    slice.ranges.resize(beams);
    result.labels.resize(beams);
    if (settings.continuous)
        slice.tiltEnd = slice.tilt + settings.tiltStep;

    const double turn = settings.continuous ? settings.tiltStep : 0.0;
    const double spread = 0.5 * (noise.footprint + std::abs(turn));
    const SurfaceSelection near = surfacesNear(scene, slice.tilt + 0.5 * turn + pitchError, offset, spread);
    std::optional<RayCaster> caster;
    for (std::size_t beam = 0; beam < beams; ++beam) {
        if (!caster || settings.continuous)
            caster.emplace(scene, near, slice.tiltAt(beam) + pitchError, offset);
        const Measurement m = measure(*caster, slice.bearing(beam), sensor, noise, drawBeam(random));
        slice.ranges[beam] = m.range;
        result.labels[beam] = m.label;
    }
    return result;
}

SimulatedScan simulate(const Scene& scene, const AcquisitionSettings& settings, const SimulationNoise& noise,
                       std::uint64_t seed)
{
    SimulatedScan scan;
    scan.recording.description = describeScan(settings);
    for (int step = 0; step < settings.slices; ++step) {
        SimulatedSlice simulated = simulateSlice(scene, settings, noise, seed, step);
        scan.recording.slices.push_back(std::move(simulated.slice));
        scan.labels.push_back(std::move(simulated.labels));
    }
    return scan;
}

}  // namespace planewright
