// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/calibrate.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/calibration/level.h"
#include "core/calibration/plane_system.h"
#include "core/calibration/seen_planes.h"
#include "core/geometry/correct_recording.h"
#include "core/types/square.h"

namespace planewright {

namespace {

using Asked = std::array<bool, kScannerErrors>;

constexpr int kMostRounds = 8;
constexpr int kLeastSteps = 3;
constexpr int kMostSteps = 12;
constexpr int kTrustPasses = 3;
/// No plane's χ² counts for more, for each degree of freedom.
constexpr double kMostChi = 6.0;
/// No plane is more uneven [m].
constexpr double kMostUneven = 0.1;
/// Corrections that move by less than this share of their standard deviation stay.
constexpr double kStays = 0.1;
constexpr double kConverged = 0.01;
/// A scanner whose pitch axis is off by more than this, and by so many standard deviations, did not stand level.
constexpr double kLevel = degrees(1.0);
constexpr double kLeans = 3.0;
/// Delays that are tried at first where the head nods both ways [steps].
constexpr std::array kTriedDelays{0.0, -0.5, 0.5, -1.0, 1.0, -1.5, 1.5};

double SensorParameters::*memberOf(int error)
{
    constexpr std::array<double SensorParameters::*, kScannerErrors> kMembers{
        &SensorParameters::rangeOffset, &SensorParameters::leverArmCorrection, &SensorParameters::sweepTurn,
        &SensorParameters::pitchDelay};
    return kMembers[static_cast<std::size_t>(error)];
}

ErrorVector errorsOf(const SensorParameters& sensor)
{
    ErrorVector errors;
    for (int i = 0; i < kScannerErrors; ++i)
        errors[i] = sensor.*memberOf(i);
    return errors;
}

std::vector<PlaneSystem> systemsOf(std::span<const Recording> recordings, const Parameters& parameters)
{
    std::vector<PlaneSystem> systems;
    for (const Recording& recording : recordings) {
        Recording corrected = recording;
        correctRecording(corrected, parameters.sensor);
        systems.emplace_back(planesSeen(corrected, parameters));
    }
    return systems;
}

/// What the planes of all scans tell, with them at their best.
struct Round {
    std::vector<PlaneSystem> systems;
    ErrorEvidence evidence;
    ObservedErrors observed;
    ErrorVector moved = ErrorVector::Zero();  ///< in this round
    int steps = 0;
    double unevenness = 0.0;    ///< of the planes [m]
    double disagreement = 1.0;  ///< variance factor, which the evidence and what is observed have in them in the end
};

std::vector<int> placesOf(const ObservedErrors& observed)
{
    std::vector<int> places;
    for (int i = 0; i < kScannerErrors; ++i) {
        if (observed.errors[static_cast<std::size_t>(i)].observed)
            places.push_back(i);
    }
    return places;
}

std::vector<PlaneSystem::Opinion> opinionsOf(const Round& round)
{
    const std::vector<int> places = placesOf(round.observed);
    std::vector<PlaneSystem::Opinion> all;
    if (places.empty())
        return all;
    for (const PlaneSystem& system : round.systems) {
        const auto some = system.opinions(places);
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

/// How much a plane counts that is uneven by so much [m] in just the way in which an error of the scanner shows.
double trustOf(const PlaneSystem::Opinion& opinion, double unevenness)
{
    return 1.0 / (1.0 + square(unevenness) * opinion.weight);
}

/// The χ² of a plane for each degree of freedom, as much of it as counts.
double countedChi(const PlaneSystem::Opinion& opinion, double unevenness)
{
    return std::min(kMostChi, trustOf(opinion, unevenness) * opinion.chi / std::max(1, opinion.freedom));
}

/// The unevenness of planes that makes them agree about the scanner [m]; found by halving.
double unevennessOf(const std::vector<PlaneSystem::Opinion>& opinions)
{
    double low = 0.0;
    double high = kMostUneven;
    for (int halving = 0; halving < 24; ++halving) {
        const double middle = 0.5 * (low + high);
        double sum = 0.0;
        for (const PlaneSystem::Opinion& opinion : opinions)
            sum += countedChi(opinion, middle);
        (sum > static_cast<double>(opinions.size()) ? low : high) = middle;
    }
    return low;
}

/// Lets planes count less for how uneven they are, and those that still disagree for that.
void trustPlanes(Round& round)
{
    const std::vector<PlaneSystem::Opinion> opinions = opinionsOf(round);
    if (opinions.empty())
        return;
    round.unevenness = unevennessOf(opinions);
    std::size_t next = 0;
    for (PlaneSystem& system : round.systems) {
        for (std::size_t plane = 0; plane < system.seen().planes.size(); ++plane, ++next) {
            const double trust = trustOf(opinions[next], round.unevenness);
            const double chi = trust * opinions[next].chi / std::max(1, opinions[next].freedom);
            system.setTrust(plane, trust * std::min(1.0, kMostChi / std::max(chi, 1e-9)));
        }
    }
}

/// What is left of the planes' disagreement: a factor on all variances, 1 at least.
double disagreementOf(const Round& round)
{
    double chi = 0.0;
    int freedom = -static_cast<int>(placesOf(round.observed).size());
    for (const PlaneSystem::Opinion& opinion : opinionsOf(round)) {
        chi += opinion.trust * opinion.chi;
        freedom += opinion.freedom;
    }
    return freedom > 0 ? std::max(1.0, chi / freedom) : 1.0;
}

/// One step of Gauss-Newton over errors and planes of all scans; true where nothing moves any more.
bool step(Round& round, const Asked& asked)
{
    round.evidence = {};
    for (PlaneSystem& system : round.systems)
        round.evidence += system.linearise();
    round.observed = observeErrors(round.evidence, asked);
    ErrorVector move;
    bool converged = true;
    for (int i = 0; i < kScannerErrors; ++i) {
        const ObservedErrors::One& one = round.observed.errors[static_cast<std::size_t>(i)];
        move[i] = one.observed ? one.move : 0.0;
        converged = converged && std::abs(move[i]) <= kConverged * one.sigma;
    }
    if (converged && round.steps > kLeastSteps)
        return true;
    for (PlaneSystem& system : round.systems)
        system.move(move);
    round.moved += move;
    ++round.steps;
    return false;
}

/// Gauss-Newton until it converges, with trust in planes by how they agree.
Round estimate(std::vector<PlaneSystem> systems, const Asked& asked)
{
    Round round;
    round.systems = std::move(systems);
    for (int pass = 0; pass < kTrustPasses; ++pass) {
        for (round.steps = 0; round.steps < kMostSteps && !step(round, asked);) {
        }
        if (pass + 1 < kTrustPasses)
            trustPlanes(round);
    }
    round.disagreement = disagreementOf(round);
    // Errors must be known well with what the planes' disagreement adds.
    round.evidence.information /= round.disagreement;
    round.evidence.gradient /= round.disagreement;
    round.observed = observeErrors(round.evidence, asked);
    return round;
}

bool stays(const Round& round)
{
    for (int i = 0; i < kScannerErrors; ++i) {
        const ObservedErrors::One& one = round.observed.errors[static_cast<std::size_t>(i)];
        if (one.observed && std::abs(round.moved[i]) > kStays * one.sigma)
            return false;
    }
    return true;
}

void apply(const ErrorVector& moved, SensorParameters& sensor)
{
    constexpr double kFarthestLength = 1.0;
    constexpr double kFarthestSteps = 4.0;
    for (int i = 0; i < kScannerErrors; ++i) {
        const double farthest = i < 2 ? kFarthestLength : kFarthestSteps;
        double& value = sensor.*memberOf(i);
        value = std::clamp(value + moved[i], -farthest, farthest);
    }
}

/// Extracts and estimates in turns until the corrections stay.
Round repeatUntilItStays(std::span<const Recording> recordings, Parameters& parameters, const Asked& asked)
{
    Round round;
    for (int i = 0; i < kMostRounds; ++i) {
        round = estimate(systemsOf(recordings, parameters), asked);
        apply(round.moved, parameters.sensor);
        if (stays(round))
            break;
    }
    return round;
}

/// The least known of the errors that were moved and are not observed after all.
std::optional<int> lostError(const Round& round, const SensorParameters& sensor, const ErrorVector& before)
{
    std::optional<int> lost;
    double most = 0.0;
    for (int i = 0; i < kScannerErrors; ++i) {
        const auto place = static_cast<std::size_t>(i);
        const ObservedErrors::One& one = round.observed.errors[place];
        if (one.observed || errorsOf(sensor)[i] == before[i])
            continue;
        const double sigma = std::min(one.sigma, 1e9) / kUsefulSigma[place];
        if (!lost || sigma > most) {
            most = sigma;
            lost = i;
        }
    }
    return lost;
}

bool nodsBothWays(const Recording& recording)
{
    int up = 0;
    int down = 0;
    for (const double rate : noddingRates(recording.slices)) {
        up += rate > 0.0 ? 1 : 0;
        down += rate < 0.0 ? 1 : 0;
    }
    constexpr int kShare = 10;
    return kShare * std::min(up, down) > up + down;
}

/// How much the returns are gathered in few planes.
double gathering(std::span<const Recording> recordings, const Parameters& parameters)
{
    double sum = 0.0;
    for (const PlaneSystem& system : systemsOf(recordings, parameters)) {
        for (const SeenPlane& plane : system.seen().planes)
            sum += static_cast<double>(plane.points) * plane.points;
    }
    return sum;
}

/// A wrong delay shows every wall twice where the head nods both ways: too far apart for one plane.
double startingDelay(std::span<const Recording> recordings, Parameters parameters)
{
    const double told = parameters.sensor.pitchDelay;
    if (std::none_of(recordings.begin(), recordings.end(), nodsBothWays))
        return told;
    double best = told;
    double most = 0.0;
    for (const double delay : kTriedDelays) {
        parameters.sensor.pitchDelay = told + delay;
        const double gathered = gathering(recordings, parameters);
        if (gathered > most) {
            most = gathered;
            best = parameters.sensor.pitchDelay;
        }
    }
    return best;
}

/// The zero of the pitch by each scan, then by all: scans may disagree by how level the scanner stood.
void levelScans(const Round& round, const CalibrationSettings& settings, double inForce, Calibration& calibration)
{
    ErrorMatrix covariance = round.observed.covariance;
    // The zero is that for the timing as it is in force: a delay of the pitch is a part of it.
    for (int i = 0; i < kScannerErrors; ++i) {
        const auto error = static_cast<ScannerError>(i);
        const bool ofTiming = error == ScannerError::SweepTurn || error == ScannerError::PitchDelay;
        if (ofTiming && !round.observed.errors[static_cast<std::size_t>(i)].observed) {
            covariance.row(i).setZero();
            covariance.col(i).setZero();
        }
    }
    double weights = 0.0;
    double weighted = 0.0;
    std::vector<std::pair<double, double>> zeros;
    for (const PlaneSystem& system : round.systems) {
        CalibratedScan scan;
        scan.planes = system.seen().planes.size();
        scan.points = system.seen().points.size();
        if (const auto level = findLevel(system.seen(), system.planes(covariance), settings.buildingTolerance)) {
            scan.levelFound = true;
            scan.pitchZero = inForce + level->pitch;
            scan.pitchZeroSigma = std::sqrt(level->covariance(0, 0));
            scan.roll = level->roll;
            scan.rollSigma = std::sqrt(level->covariance(1, 1));
            scan.levelPlanes = level->levelPlanes;
            scan.plumbPlanes = level->plumbPlanes;
            const bool leans = std::abs(scan.roll) > kLevel && std::abs(scan.roll) > kLeans * scan.rollSigma;
            scan.usedAsLevel = settings.level == LevelUse::Always || (settings.level == LevelUse::Auto && !leans);
        }
        if (scan.usedAsLevel) {
            const double weight = 1.0 / square(scan.pitchZeroSigma);
            weights += weight;
            weighted += weight * scan.pitchZero;
            zeros.emplace_back(scan.pitchZero, weight);
        }
        calibration.scans.push_back(scan);
    }
    if (zeros.empty())
        return;
    calibration.pitchZeroObserved = true;
    calibration.pitchZero = weighted / weights;
    double chi = 0.0;
    for (const auto& [zero, weight] : zeros)
        chi += weight * square(zero - calibration.pitchZero);
    const double ratio = zeros.size() > 1 ? chi / static_cast<double>(zeros.size() - 1) : 1.0;
    calibration.pitchZeroSigma = std::sqrt(std::max(1.0, ratio) / weights);
}

}  // namespace

Result<Calibration> calibrate(std::span<const Recording> recordings, const Parameters& parameters,
                              const CalibrationSettings& settings)
{
    const ErrorVector before = errorsOf(parameters.sensor);
    Parameters current = parameters;
    current.sensor.pitchDelay = startingDelay(recordings, parameters);
    Asked asked;
    asked.fill(true);
    std::array<ObservedErrors::One, kScannerErrors> dropped;
    Round round = repeatUntilItStays(recordings, current, asked);
    while (const std::optional<int> lost = lostError(round, current.sensor, before)) {
        // It seemed to be observed at first and is not: it goes back to where it was, and the rest is found anew.
        const auto place = static_cast<std::size_t>(*lost);
        current.sensor.*memberOf(*lost) = before[*lost];
        asked[place] = false;
        dropped[place] = round.observed.errors[place];
        round = repeatUntilItStays(recordings, current, asked);
    }

    if (std::all_of(round.systems.begin(), round.systems.end(),
                    [](const PlaneSystem& system) { return system.seen().planes.empty(); }))
        return fail(ErrorCode::GateFailed,
                    "no plane is seen well enough to calibrate by; scan a room with its floor and walls, over as much "
                    "pitch as the scanner can");
    Calibration calibration;
    calibration.disagreement = std::sqrt(round.disagreement);
    calibration.unevenness = round.unevenness;
    for (int i = 0; i < kScannerErrors; ++i) {
        const auto place = static_cast<std::size_t>(i);
        const ObservedErrors::One& one = asked[place] ? round.observed.errors[place] : dropped[place];
        calibration.errors[static_cast<std::size_t>(i)] = {one.observed, errorsOf(current.sensor)[i], one.sigma,
                                                           one.tangled};
    }
    levelScans(round, settings, parameters.sensor.pitchZero, calibration);
    for (const PlaneSystem& system : round.systems)
        calibration.pitchNoise = std::max(calibration.pitchNoise, system.pitchNoise());
    calibration.nodsBothWays = std::any_of(recordings.begin(), recordings.end(), nodsBothWays);
    calibration.sensor = current.sensor;
    if (calibration.pitchZeroObserved)
        calibration.sensor.pitchZero = std::clamp(calibration.pitchZero, degrees(-45.0), degrees(45.0));
    return calibration;
}

}  // namespace planewright
