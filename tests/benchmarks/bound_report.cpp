// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// How far the plane estimate of the likelihood method is from the Cramér-Rao bound on seven single planes, and how
// honest its covariance is. Each plane is alone in sight, so that all its segments are known to be its own.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/params/presets.h"
#include "core/planes/end_point_cost.h"
#include "core/planes/plane_estimate.h"
#include "core/segments/extract_statistics.h"
#include "core/simulation/nodding_scanner.h"
#include "core/simulation/random.h"
#include "core/types/angle.h"
#include "tests/benchmarks/plane_information.h"

using namespace planewright;

namespace {

/// A rectangle corner + a·edgeU + b·edgeV with a and b from 0 to 1 [m].
struct TestPlane {
    std::string_view name;
    Eigen::Vector3d corner;
    Eigen::Vector3d edgeU;
    Eigen::Vector3d edgeV;

    KnownPlane plane() const
    {
        Eigen::Vector3d normal = edgeU.cross(edgeV).normalized();
        if (normal.dot(corner) < 0.0)
            normal = -normal;
        return {normal, normal.dot(corner)};
    }
};

/// A room about a sensor 1 m above its floor.
const std::array kPlanes{
    TestPlane{"frontal wall 5 m", {-3.0, 5.0, -1.0}, {6.0, 0.0, 0.0}, {0.0, 0.0, 3.0}},
    TestPlane{"side wall 1.5 m", {-1.5, 0.3, -1.0}, {0.0, 15.0, 0.0}, {0.0, 0.0, 2.6}},
    TestPlane{"floor 1 m", {-1.5, 0.0, -1.0}, {3.0, 0.0, 0.0}, {0.0, 10.0, 0.0}},
    TestPlane{"ceiling 1.6 m", {-1.5, 0.0, 1.6}, {3.0, 0.0, 0.0}, {0.0, 10.0, 0.0}},
    TestPlane{"far wall 20 m", {-3.0, 20.0, -1.5}, {6.0, 0.0, 0.0}, {0.0, 0.0, 3.0}},
    TestPlane{"door 3 m", {0.15, 3.0, -1.0}, {0.9, 0.0, 0.0}, {0.0, 0.0, 2.0}},
    TestPlane{"oblique wall 6 m", {7.95, 0.535, -1.5}, {-7.0, 7.0, 0.0}, {0.0, 0.0, 3.0}},
};

/// A setting of range noise and pitch noise.
struct Case {
    std::string_view profile;
    PitchNoise pitch;
};
const std::array kCases{Case{"P", PitchNoise::Common},      Case{"S", PitchNoise::Common},
                        Case{"A", PitchNoise::Common},      Case{"P", PitchNoise::Independent},
                        Case{"S", PitchNoise::Independent}, Case{"A", PitchNoise::Independent}};

/// Table VIII with all tilts from 0° to 160°.
AcquisitionSettings settings()
{
    AcquisitionSettings s;
    s.firstTilt = 0.0;
    s.slices = 138;
    return s;
}

/// Range to a rectangle along a beam [m]; 0 where the beam misses it.
double rangeTo(const TestPlane& target, double bearing, double tilt, const SensorModel& sensor)
{
    const Eigen::Vector3d origin = toCartesian(0.0, bearing, tilt, sensor);
    const Eigen::Vector3d direction = toCartesian(1.0, bearing, tilt, sensor) - origin;
    const KnownPlane plane = target.plane();
    const double range = (plane.distance - plane.normal.dot(origin)) / plane.normal.dot(direction);
    if (!(range > 0.0) || !std::isfinite(range))
        return 0.0;
    const Eigen::Vector3d within = origin + range * direction - target.corner;
    const double a = within.dot(target.edgeU) / target.edgeU.squaredNorm();
    const double b = within.dot(target.edgeV) / target.edgeV.squaredNorm();
    return a >= 0.0 && a <= 1.0 && b >= 0.0 && b <= 1.0 && sensor.hasEcho(range) ? range : 0.0;
}

/// One plane under one noise: what is the same in all trials.
struct Experiment {
    const TestPlane& target;
    SimulationNoise noise;
    PitchNoise pitch;
    SensorModel sensor;
    std::vector<ScanSlice> exact;            ///< without noise
    std::vector<std::vector<char>> inReach;  ///< beams that may hit the rectangle with noise
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double meanRange = 0.0;  ///< [m]
    int points = 0;
};

Experiment experimentOf(const TestPlane& target, const Case& setting)
{
    const AcquisitionSettings acquisition = settings();
    Experiment e{target, *simulationNoise(setting.profile), setting.pitch, sensorOf(describeScan(acquisition)), {}, {}};
    PlaneInformation information(target.plane(), e.noise, e.sensor, setting.pitch);
    const double bearingReach = 6.0 * e.noise.bearing;
    const double tiltReach = 6.0 * e.noise.pitch;
    for (int k = 0; k < acquisition.slices; ++k) {
        ScanSlice slice;
        slice.step = k;
        slice.tilt = acquisition.firstTilt + k * acquisition.tiltStep;
        slice.firstBearing = acquisition.firstBearing;
        slice.bearingStep = acquisition.bearingStep;
        slice.ranges.resize(static_cast<std::size_t>(acquisition.beams));
        std::vector<char> inReach(slice.ranges.size(), 0);
        for (std::size_t i = 0; i < slice.ranges.size(); ++i) {
            const double bearing = slice.bearing(i);
            slice.ranges[i] = rangeTo(target, bearing, slice.tilt, e.sensor);
            for (const double b : {-bearingReach, 0.0, bearingReach}) {
                for (const double t : {-tiltReach, 0.0, tiltReach}) {
                    if (rangeTo(target, bearing + b, slice.tilt + t, e.sensor) > 0.0)
                        inReach[i] = 1;
                }
            }
            if (slice.ranges[i] > 0.0) {
                information.add(slice.ranges[i], bearing, slice.tilt);
                e.meanRange += slice.ranges[i];
                ++e.points;
            }
        }
        information.endSlice();
        e.exact.push_back(std::move(slice));
        e.inReach.push_back(std::move(inReach));
    }
    e.information = information.information();
    e.meanRange /= e.points;
    return e;
}

/// Ranges of a slice as the scanner measures them.
ScanSlice measured(const Experiment& e, std::size_t k, Random& random)
{
    ScanSlice slice = e.exact[k];
    const double common = e.noise.pitch * random.normalPair().first;
    for (std::size_t i = 0; i < slice.ranges.size(); ++i) {
        slice.ranges[i] = 0.0;
        if (e.inReach[k][i] == 0)
            continue;
        const Random::Pair own = random.normalPair();
        const double pitch = e.pitch == PitchNoise::Common ? common : e.noise.pitch * random.normalPair().first;
        const double range =
            rangeTo(e.target, slice.bearing(i) + e.noise.bearing * own.first, slice.tilt + pitch, e.sensor);
        const double noisy = range + e.noise.rangeSigma(range) * own.second;
        if (range > 0.0 && e.sensor.hasEcho(noisy))
            slice.ranges[i] = noisy;
    }
    return slice;
}

/// What the estimator is told of the noise: two numbers cannot tell a step at 10 m, so that they are those at the mean
/// range of the plane.
Parameters parametersOf(const Experiment& e)
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), "precise"), parameters);
    const bool far = e.noise.rangeFar && e.meanRange >= e.noise.rangeFarFrom;
    parameters.noise.rangeConstant = far ? *e.noise.rangeFar : e.noise.rangeConstant;
    parameters.noise.rangeProportional = far ? 0.0 : e.noise.rangeProportional;
    parameters.noise.bearing = e.noise.bearing;
    parameters.noise.pitch = e.noise.pitch;
    parameters.noise.pitchCommon = e.pitch == PitchNoise::Common;
    return parameters;
}

using SliceSegments = std::vector<SegmentStatistics>;

/// Total least squares of the projected end points: where the iterations start.
PlaneEstimate startOf(const Experiment& e, const std::vector<SliceSegments>& segments)
{
    std::vector<Eigen::Vector3d> ends;
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const SliceFrame frame = frameOf(e.exact[k].tilt, e.sensor);
        for (const SegmentStatistics& s : segments[k]) {
            for (const double along : {s.start, s.end})
                ends.push_back(frame.pointAt(s.u + along * s.directionU, s.v + along * s.directionV));
        }
    }
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& end : ends)
        mean += end / static_cast<double>(ends.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& end : ends)
        scatter += (end - mean) * (end - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    const Eigen::Vector3d normal = solver.eigenvectors().col(0);
    return {normal, normal.dot(mean)};
}

/// The most likely plane of all segments, linearised anew until it stays where it is.
PlaneEstimate estimateOf(const Experiment& e, const std::vector<SliceSegments>& segments, const Parameters& parameters)
{
    constexpr int kIterations = 5;
    PlaneEstimate estimate = startOf(e, segments);
    std::vector<const SegmentStatistics*> group;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        estimate = PlaneEstimate(estimate.normal(), estimate.distance());
        for (std::size_t k = 0; k < segments.size(); ++k) {
            group.clear();
            for (const SegmentStatistics& s : segments[k])
                group.push_back(&s);
            if (!group.empty())
                estimate.accumulate(estimate.inSlice(frameOf(e.exact[k].tilt, e.sensor)), group, parameters.noise, 0.0,
                                    1.0);
        }
        if (!estimate.solve())
            break;
    }
    return estimate;
}

struct Outcome {
    double ratio = 0.0;     ///< root of mean(e'Fe)/3: error in units of the bound
    double squared = 0.0;   ///< mean e'C⁻¹e; 3 is honest
    double segments = 0.0;  ///< mean count
};

Outcome run(const Experiment& e, int trials, std::uint64_t seed)
{
    const Parameters parameters = parametersOf(e);
    const KnownPlane truth = e.target.plane();
    StatisticsExtractor extractor;
    Outcome outcome;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<SliceSegments> segments(e.exact.size());
        for (std::size_t k = 0; k < e.exact.size(); ++k) {
            Random random(seed + static_cast<std::uint64_t>(trial), k);
            extractor.extract(measured(e, k, random), e.sensor, parameters, segments[k]);
            outcome.segments += static_cast<double>(segments[k].size()) / trials;
        }
        const PlaneEstimate estimate = estimateOf(e, segments, parameters);

        const Eigen::Vector3d error = errorOf({estimate.normal(), estimate.distance()}, truth);
        outcome.ratio += error.dot(e.information * error) / trials;
        // Once more in the tangents that the covariance is told in.
        const double side = estimate.normal().dot(truth.normal) < 0.0 ? -1.0 : 1.0;
        Eigen::Vector3d own;
        own.head<2>() = estimate.tangents().transpose() * (estimate.normal() - side * truth.normal);
        own[2] = estimate.distance() - side * truth.distance;
        outcome.squared += own.dot(estimate.covariance().inverse() * own) / trials;
    }
    outcome.ratio = std::sqrt(outcome.ratio / 3.0);
    return outcome;
}

}  // namespace

int main(int argc, char** argv)
{
    int trials = 400;
    std::uint64_t seed = 1;
    CLI::App program{"Error over the Cramer-Rao bound, and honesty of the covariance, on seven single planes."};
    program.add_option("--trials", trials, "Noise draws of each plane")->check(CLI::Range(1, 1000000));
    program.add_option("--seed", seed, "Seed of the first trial");
    CLI11_PARSE(program, argc, argv);

    constexpr double kDegree = std::numbers::pi / 180.0;
    std::printf("%d trials, seed %llu; sampling scatter of a ratio about %.1f %%\n", trials,
                static_cast<unsigned long long>(seed), 100.0 / std::sqrt(6.0 * trials));
    for (const Case& setting : kCases) {
        std::printf("\nprofile %s, pitch noise %s\n%-18s %7s %9s %11s %9s %8s %9s\n", setting.profile.data(),
                    setting.pitch == PitchNoise::Common ? "common to a slice" : "of each point", "plane", "points",
                    "segments", "bound n deg", "bound mm", "x bound", "e'C^-1e");
        for (const TestPlane& target : kPlanes) {
            const Experiment e = experimentOf(target, setting);
            const Outcome outcome = run(e, trials, seed);
            const Eigen::Matrix3d bound = e.information.inverse();
            std::printf("%-18s %7d %9.1f %11.4f %9.3f %8.3f %9.2f\n", target.name.data(), e.points, outcome.segments,
                        std::sqrt(bound(0, 0) + bound(1, 1)) / kDegree, 1000.0 * std::sqrt(bound(2, 2)), outcome.ratio,
                        outcome.squared);
            std::fflush(stdout);
        }
    }
    return 0;
}
