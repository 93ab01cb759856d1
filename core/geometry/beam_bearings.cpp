// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/geometry/beam_bearings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "core/types/recording.h"
#include "core/types/square.h"

namespace planewright {

namespace {

constexpr double kBearingTurn = 2.0 * std::numbers::pi;
constexpr double kEven = 1e-5;     ///< bearings that are off even spacing by less [rad] are evenly spaced
constexpr double kOutlier = 3e-3;  ///< bearings farther from the mean of their beam [rad] do not count for it
constexpr double kFrontal =
    1.48;  ///< an image sees bearings within this of straight ahead, and pitches of its middle [rad]
constexpr double kMostBeamsOfPoint = 16.0;  ///< beams for each return, in scans of more beams than:
constexpr double kSmallScan = 1e6;
constexpr double kLeastStep = 1e-7;  ///< [rad]

/// Calls `visit(slice, beam, bearing)` for all points.
template <class Visit>
void forEachPoint(const std::vector<SeenBearings>& slices, Visit visit)
{
    for (const SeenBearings& seen : slices) {
        for (std::size_t k = 0; k < seen.bearings.size(); ++k)
            visit(seen, static_cast<std::size_t>((*seen.slice)[k].beam), seen.bearings[k]);
    }
}

/// The turn of `bearing` that is nearest to `near`.
double nearTo(double near, double bearing)
{
    return bearing - kBearingTurn * std::round((bearing - near) / kBearingTurn);
}

/// Sums of one beam's bearings.
struct BeamSum {
    double count = 0.0;
    double sum = 0.0;
    double mean() const { return sum / count; }
};

/// The mean bearing of each beam. All turns are those of the beam's first point.
std::vector<BeamSum> meanBearings(const std::vector<SeenBearings>& slices, int beams)
{
    std::vector<BeamSum> all(static_cast<std::size_t>(beams));
    forEachPoint(slices, [&](const SeenBearings&, std::size_t beam, double bearing) {
        BeamSum& one = all[beam];
        one.sum += one.count == 0.0 ? bearing : nearTo(one.mean(), bearing);
        one.count += 1.0;
    });
    std::vector<BeamSum> near(all.size());
    forEachPoint(slices, [&](const SeenBearings&, std::size_t beam, double bearing) {
        const double here = nearTo(all[beam].mean(), bearing);
        if (std::abs(here - all[beam].mean()) > kOutlier)
            return;
        near[beam].sum += here;
        near[beam].count += 1.0;
    });
    for (std::size_t beam = 0; beam < all.size(); ++beam) {
        if (near[beam].count > 0.0)
            all[beam] = near[beam];
    }
    return all;
}

/// Mean square of what the points' bearings are off.
template <class BearingOf>
double meanSquareOff(const std::vector<SeenBearings>& slices, BearingOf bearingOf)
{
    double sum = 0.0;
    double count = 0.0;
    forEachPoint(slices, [&](const SeenBearings& seen, std::size_t beam, double bearing) {
        const double expected = bearingOf(seen.tilt, beam);
        sum += std::min(square(nearTo(expected, bearing) - expected), square(kOutlier));
        count += 1.0;
    });
    return sum / std::max(1.0, count);
}

/// Fills the beams without points in: evenly between neighbours, and outside at the mean step.
void fillIn(std::vector<double>& bearings, const std::vector<BeamSum>& told)
{
    std::size_t first = 0;
    while (told[first].count == 0.0)
        ++first;
    std::size_t last = told.size() - 1;
    while (told[last].count == 0.0)
        --last;
    const double step =
        last > first ? (bearings[last] - bearings[first]) / static_cast<double>(last - first) : kLeastStep;
    for (std::size_t beam = 0; beam < first; ++beam)
        bearings[beam] = bearings[first] - step * static_cast<double>(first - beam);
    for (std::size_t beam = last + 1; beam < told.size(); ++beam)
        bearings[beam] = bearings[last] + step * static_cast<double>(beam - last);
    for (std::size_t before = first, beam = first + 1; beam <= last; ++beam) {
        if (told[beam].count == 0.0)
            continue;
        for (std::size_t between = before + 1; between < beam; ++between)
            bearings[between] = bearings[before] + (bearings[beam] - bearings[before]) *
                                                       static_cast<double>(between - before) /
                                                       static_cast<double>(beam - before);
        before = beam;
    }
}

/// A line through the bearings over their beams.
struct EvenSpacing {
    double first = 0.0;
    double step = 0.0;
    double largestOff = 0.0;
};

EvenSpacing evenSpacing(const std::vector<double>& bearings, const std::vector<BeamSum>& told)
{
    double n = 0.0;
    double beams = 0.0;
    double sum = 0.0;
    for (std::size_t beam = 0; beam < bearings.size(); ++beam) {
        if (told[beam].count == 0.0)
            continue;
        n += 1.0;
        beams += static_cast<double>(beam);
        sum += bearings[beam];
    }
    double squares = 0.0;
    double products = 0.0;
    for (std::size_t beam = 0; beam < bearings.size(); ++beam) {
        if (told[beam].count == 0.0)
            continue;
        const double from = static_cast<double>(beam) - beams / n;
        squares += from * from;
        products += from * bearings[beam];
    }
    EvenSpacing even;
    even.step = products / squares;
    even.first = (sum - even.step * beams) / n;
    for (std::size_t beam = 0; beam < bearings.size(); ++beam) {
        if (told[beam].count > 0.0)
            even.largestOff = std::max(even.largestOff,
                                       std::abs(bearings[beam] - even.first - even.step * static_cast<double>(beam)));
    }
    return even;
}

/// The beams of a flat image, cot θ = A cos(φ − φ₀): each beam's (A cos φ₀, A sin φ₀) by least squares over its points,
/// φ₀ from where these pairs lie, then A. Nothing where the scan is none that an image can be.
std::shared_ptr<BeamTable> imageTable(const std::vector<SeenBearings>& slices, int beams)
{
    struct Sums {
        double cc = 0.0, cs = 0.0, ss = 0.0, yc = 0.0, ys = 0.0;
    };
    std::vector<Sums> sums(static_cast<std::size_t>(beams));
    bool isFrontal = true;
    forEachPoint(slices, [&](const SeenBearings& seen, std::size_t beam, double bearing) {
        isFrontal = isFrontal && std::abs(bearing - 0.5 * std::numbers::pi) < kFrontal;
        const double weight = square(square(std::sin(bearing)));
        const double y = weight / std::tan(bearing);
        const double c = std::cos(seen.tilt);
        const double s = std::sin(seen.tilt);
        Sums& one = sums[beam];
        one.cc += weight * c * c;
        one.cs += weight * c * s;
        one.ss += weight * s * s;
        one.yc += y * c;
        one.ys += y * s;
    });
    if (!isFrontal)
        return nullptr;
    Eigen::Matrix2d pairs = Eigen::Matrix2d::Zero();
    for (const Sums& one : sums) {
        const double determinant = one.cc * one.ss - one.cs * one.cs;
        if (!(determinant > 1e-9 * square(one.cc + one.ss)))
            continue;
        const Eigen::Vector2d pair{(one.ss * one.yc - one.cs * one.ys) / determinant,
                                   (one.cc * one.ys - one.cs * one.yc) / determinant};
        pairs += pair * pair.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(pairs);
    Eigen::Vector2d middle = axes.eigenvectors().col(1);
    double towards = 0.0;
    for (const SeenBearings& seen : slices)
        towards += middle.x() * std::cos(seen.tilt) + middle.y() * std::sin(seen.tilt);
    if (towards < 0.0)
        middle = -middle;
    auto table = std::make_shared<BeamTable>();
    table->imageTilt = std::atan2(middle.y(), middle.x());
    const auto looksAway = [&](const SeenBearings& seen) {
        return std::cos(seen.tilt - *table->imageTilt) < std::cos(kFrontal);
    };
    if (std::any_of(slices.begin(), slices.end(), looksAway))
        return nullptr;
    table->bearings.resize(sums.size());
    for (std::size_t beam = 0; beam < sums.size(); ++beam) {
        const Sums& one = sums[beam];
        const double square2 = middle.x() * middle.x() * one.cc + 2.0 * middle.x() * middle.y() * one.cs +
                               middle.y() * middle.y() * one.ss;
        if (square2 > 0.0)
            table->bearings[beam] = std::atan2(1.0, (middle.x() * one.yc + middle.y() * one.ys) / square2);
    }
    return table;
}

/// What neighbouring points of a slice are mostly apart; 0 where none are.
double stepOf(const std::vector<SeenBearings>& slices)
{
    std::vector<double> steps;
    for (const SeenBearings& seen : slices) {
        for (std::size_t k = 1; k < seen.bearings.size(); ++k) {
            if (seen.bearings[k] - seen.bearings[k - 1] > kLeastStep)
                steps.push_back(seen.bearings[k] - seen.bearings[k - 1]);
        }
    }
    if (steps.empty())
        return 0.0;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// Numbers along each slice, from its first point on, by whole steps; and the step that fits them best.
double countSteps(const std::vector<SeenBearings>& slices, double step, std::vector<std::vector<double>>& numbers)
{
    double squares = 0.0;
    double products = 0.0;
    for (const SeenBearings& seen : slices) {
        std::vector<double>& along = numbers.emplace_back();
        double n = 0.0;
        double sum = 0.0;
        double sumBearing = 0.0;
        for (std::size_t k = 0; k < seen.bearings.size(); ++k) {
            if (k > 0)
                n += std::round((seen.bearings[k] - seen.bearings[k - 1]) / step);
            along.push_back(n);
            sum += n;
            sumBearing += seen.bearings[k];
        }
        const auto count = static_cast<double>(along.size());
        for (std::size_t k = 0; k < along.size(); ++k) {
            const double from = along[k] - sum / count;
            squares += from * from;
            products += from * (seen.bearings[k] - sumBearing / count);
        }
    }
    return squares > 0.0 ? products / squares : step;
}

}  // namespace

Result<int> numberBeams(std::vector<SeenBearings>& slices)
{
    const double rough = stepOf(slices);
    if (!(rough > 0.0))
        return fail(ErrorCode::Unreadable, "no two points of a slice are beside each other; it is no scan");
    std::vector<std::vector<double>> numbers;
    const double step = countSteps(slices, rough, numbers);
    if (!(step > kLeastStep))
        return fail(ErrorCode::Unreadable, "bearings do not rise; give the points in the order of measurement");
    const auto offsetOf = [&](std::size_t i) {
        double sum = 0.0;
        for (std::size_t k = 0; k < numbers[i].size(); ++k)
            sum += slices[i].bearings[k] - step * numbers[i][k];
        return sum / static_cast<double>(numbers[i].size());
    };
    // Slices begin where their first return is: the first slice tells where beams are for all.
    const double origin = offsetOf(0);
    double lowest = 0.0;
    double highest = 0.0;
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const double shift = std::round((offsetOf(i) - origin) / step);
        for (double& number : numbers[i]) {
            number += shift;
            lowest = std::min(lowest, number);
            highest = std::max(highest, number);
        }
    }
    const double beams = highest - lowest + 1.0;
    double points = 0.0;
    for (const SeenBearings& seen : slices)
        points += static_cast<double>(seen.bearings.size());
    // A few points far apart must not ask for the memory of a whole scan.
    const double most = std::min(static_cast<double>(kMaxRanges), kMostBeamsOfPoint * points + kSmallScan);
    if (!(beams <= kMaxBeams) || !(beams * static_cast<double>(slices.size()) <= most))
        return fail(ErrorCode::Unreadable, "the points are no slices of at most " + std::to_string(kMaxBeams) +
                                               " evenly spaced beams; give points in the order of measurement");
    for (std::size_t i = 0; i < slices.size(); ++i) {
        for (std::size_t k = 0; k < numbers[i].size(); ++k)
            (*slices[i].slice)[k].beam = static_cast<int>(numbers[i][k] - lowest);
    }
    return static_cast<int>(beams);
}

Result<BeamBearings> layBearings(const std::vector<SeenBearings>& slices, int beams)
{
    const std::vector<BeamSum> told = meanBearings(slices, beams);
    if (std::count_if(told.begin(), told.end(), [](const BeamSum& one) { return one.count > 0.0; }) < 2)
        return fail(ErrorCode::Unreadable, "fewer than two beams have returns; a scan has more");
    std::vector<double> bearings(told.size());
    for (std::size_t beam = 0; beam < told.size(); ++beam)
        bearings[beam] = told[beam].count > 0.0 ? told[beam].mean() : 0.0;
    const EvenSpacing even = evenSpacing(bearings, told);
    BeamBearings laid{even.first, even.step, nullptr};
    if (!(even.largestOff < kEven)) {
        auto table = std::make_shared<BeamTable>();
        table->bearings = std::move(bearings);
        const auto image = imageTable(slices, beams);
        const auto ofTable = [&](double, std::size_t beam) { return table->bearings[beam]; };
        const auto ofImage = [&](double tilt, std::size_t beam) {
            const double bearing = image->bearings[beam];
            return std::atan2(std::sin(bearing), std::cos(bearing) * std::cos(tilt - *image->imageTilt));
        };
        if (image && meanSquareOff(slices, ofImage) < meanSquareOff(slices, ofTable))
            table = image;
        fillIn(table->bearings, told);
        laid.first = table->bearings.front();
        laid.step = (table->bearings.back() - laid.first) / (beams - 1);
        laid.table = table;
    }
    const bool rises = laid.table ? std::adjacent_find(laid.table->bearings.begin(), laid.table->bearings.end(),
                                                       [](double a, double b) { return !(b - a > kLeastStep); }) ==
                                        laid.table->bearings.end()
                                  : laid.step > kLeastStep;
    // Beams beyond those with points may be where no image has any.
    const bool isAhead = !laid.table || !laid.table->imageTilt ||
                         (laid.table->bearings.front() > 0.0 && laid.table->bearings.back() < 0.5 * kBearingTurn);
    const double last = laid.first + laid.step * (beams - 1);
    if (!rises || !isAhead || laid.first < -kBearingTurn || last > kBearingTurn)
        return fail(ErrorCode::Unreadable,
                    "bearings do not rise from beam to beam; give the points of each slice in the order of its sweep");
    return laid;
}

}  // namespace planewright
