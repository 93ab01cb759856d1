// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/seen_line.h"

#include <cmath>
#include <random>
#include <vector>

#include <QtTest>

#include "core/segments/line_piece.h"
#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// A beam of a wall that runs along u at some distance ahead of the laser, measured with noise.
struct Measured {
    double u = 0.0;
    double v = 0.0;
};

/// The wall v = `ahead` [m] seen by beams from `from` on, 0.25° apart; angles from the wall's normal to its −u side.
struct Wall {
    double ahead = 1.5;
    double from = degrees(20.0);
    int beams = 160;

    double angle(int beam) const { return from + beam * degrees(0.25); }
    double place(int beam) const { return ahead * std::tan(angle(beam)); }
    /// The line in the direction of falling u, in which places rise with the angle.
    SeenLine seen() const { return {-ahead, place(0), place(beams - 1)}; }
};

/// One draw of the wall's beams: each ray goes astray by bearing noise and its range by range noise.
std::vector<Measured> drawOf(const Wall& wall, const NoiseParameters& noise, std::mt19937_64& random)
{
    std::vector<Measured> points;
    for (int beam = 0; beam < wall.beams; ++beam) {
        const double angle = wall.angle(beam);
        const double exact = wall.ahead / std::cos(angle + noise.bearing * normal(random));
        const double range = exact + std::sqrt(noise.rangeVariance(exact)) * normal(random);
        points.push_back({-range * std::sin(angle), range * std::cos(angle)});
    }
    return points;
}

/// Mean of numbers that come one by one, and its standard deviation.
struct Mean {
    double sum = 0.0;
    double squares = 0.0;
    int count = 0;

    void add(double x)
    {
        sum += x;
        squares += x * x;
        ++count;
    }
    double value() const { return sum / count; }
    double sigma() const { return std::sqrt((squares / count - value() * value()) / count); }
};

constexpr int kDraws = 20000;
constexpr NoiseParameters kCoarse{0.03, 0.0, degrees(0.072), 0.0};

}  // namespace

class SeenLineTest : public QObject {
    Q_OBJECT

private slots:
    void varianceIsThatOfItsRay();
    void aLineWithoutNoiseIsNotTurned();
    void theLikeliestSlopeIsFreeOfBias();
    void theLikeliestSlopeTurnsWithTheNoiseAlone();
    void weightsFromMeasuredPlacesShiftTheLineAsTold();
    void weightsThatDependOnNoRangeShiftNothing();
};

void SeenLineTest::varianceIsThatOfItsRay()
{
    NoiseParameters noise{0.01, 0.002, 0.001, 0.0};
    const SeenLine line{-3.0, -4.0, 4.0};

    // At place 4 the ray is 5 m long: cosine 0.6, sine 0.8. 0.36·(1e-4 + 1e-4) + 0.64·25·1e-6.
    QVERIFY(std::abs(varianceAt(4.0, line, noise) - (0.36 * 2e-4 + 16e-6)) < 1e-15);
    QVERIFY(std::abs(varianceAt(-2.0, line, noise) - varianceAcross(0.0, 1.0, 2.0, 3.0, noise)) < 1e-15);
    // Simpson: at the ends 88e-6, in the middle 1e-4 + 9·4e-6.
    QVERIFY(std::abs(meanVariance(line, noise) - (2.0 * 88e-6 + 4.0 * 136e-6) / 6.0) < 1e-15);
}

void SeenLineTest::aLineWithoutNoiseIsNotTurned()
{
    QCOMPARE(likeliestSlope({1.0, 0.0, 2.0, 0.0}, {1.5, 0.5, 2.5}, kCoarse), 0.0);
    QCOMPARE(likeliestSlope({1.0, 0.0, 2.0, 0.1}, {1.5, -1.0, 1.0}, kCoarse), 0.0);
    QCOMPARE(likeliestSlope({1.0, 0.0, 0.0, 0.0}, {1.5, 0.5, 2.5}, kCoarse), 0.0);
}

void SeenLineTest::theLikeliestSlopeIsFreeOfBias()
{
    // From 20° to 34.75°: places from 0.55 m to 1.04 m; 30 mm along the ray.
    const Wall wall{1.5, degrees(20.0), 60};
    std::mt19937_64 random(5);
    Mean leastSquares;
    Mean likeliest;
    for (int draw = 0; draw < kDraws; ++draw) {
        LineMoments moments;
        for (const Measured& point : drawOf(wall, kCoarse, random))
            moments.add(point.u, point.v);
        const MomentLine line = lineOf(moments);
        const double turn = line.directionV / line.directionU;
        leastSquares.add(turn);
        // In the direction of falling u slopes count the other way: normal (−dv, du) looks to the laser.
        likeliest.add(turn + likeliestSlope(line, wall.seen(), kCoarse));
    }

    // Of the wall along u: Σ of displacements along times across it, −σ² sin ψ cos ψ, over Σ (u − mean)².
    double coupling = 0.0;
    double spread = 0.0;
    double middle = 0.0;
    for (int beam = 0; beam < wall.beams; ++beam)
        middle += wall.place(beam) / wall.beams;
    for (int beam = 0; beam < wall.beams; ++beam) {
        coupling -= 9e-4 * std::sin(wall.angle(beam)) * std::cos(wall.angle(beam));
        spread += square(wall.place(beam) - middle);
    }
    QVERIFY(std::abs(leastSquares.value() - coupling / spread) < 0.2 * std::abs(coupling / spread));
    QVERIFY(std::abs(leastSquares.value()) > 20.0 * leastSquares.sigma());
    QVERIFY2(std::abs(likeliest.value()) < 4.0 * likeliest.sigma() + 0.02 * std::abs(coupling / spread),
             qPrintable(QString::number(likeliest.value() / likeliest.sigma())));
}

void SeenLineTest::theLikeliestSlopeTurnsWithTheNoiseAlone()
{
    // Twice the noise told gives the same line: only proportions count.
    const MomentLine line{1.0, 0.0, 2.0, 0.03};
    const SeenLine seen{1.5, 0.5, 2.5};

    const double slope = likeliestSlope(line, seen, {0.01, 0.002, 0.001, 0.0});

    QVERIFY(slope < 0.0);
    QVERIFY(std::abs(likeliestSlope(line, seen, {0.02, 0.004, 0.002, 0.0}) - slope) < 1e-12);
    // Seen from the other side of the foot it turns the other way.
    QVERIFY(std::abs(likeliestSlope(line, {1.5, -2.5, -0.5}, {0.01, 0.002, 0.001, 0.0}) + slope) < 1e-12);
}

void SeenLineTest::weightsFromMeasuredPlacesShiftTheLineAsTold()
{
    const Wall wall{1.5, degrees(-10.0), 320};  // to 69.75°
    const SeenLine seen = wall.seen();
    std::mt19937_64 random(6);
    Mean offset;
    Mean moment;
    for (int draw = 0; draw < kDraws; ++draw) {
        double weights = 0.0;
        double offsets = 0.0;
        double moments = 0.0;
        for (const Measured& point : drawOf(wall, kCoarse, random)) {
            const double place = -point.u;
            const double across = wall.ahead - point.v;  // along the normal, which looks to the laser
            const double weight = 1.0 / varianceAt(place, seen, kCoarse);
            weights += weight;
            offsets += weight * across;
            moments += weight * place * across - place / seen.offset;
        }
        offset.add(offsets / weights);
        moment.add(moments / weights);
    }
    const WeightBias told = weightBias(seen, kCoarse);

    QVERIFY(std::abs(told.offset) > 20.0 * offset.sigma());
    QVERIFY2(std::abs(offset.value() - told.offset) < 4.0 * offset.sigma() + 0.05 * std::abs(told.offset),
             qPrintable(QString("%1 %2 %3").arg(offset.value()).arg(told.offset).arg(offset.sigma())));
    QVERIFY2(std::abs(moment.value() - told.moment) < 4.0 * moment.sigma() + 0.05 * std::abs(told.moment),
             qPrintable(QString("%1 %2 %3").arg(moment.value()).arg(told.moment).arg(moment.sigma())));
}

void SeenLineTest::weightsThatDependOnNoRangeShiftNothing()
{
    // Noise that grows with range makes the same variance across a line wherever a ray meets it.
    const WeightBias bias = weightBias({1.5, -1.0, 9.0}, {0.0, 0.003, 0.0, 0.0});

    QCOMPARE(bias.offset, 0.0);
    QCOMPARE(bias.moment, 0.0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SeenLineTest)
#include "seen_line_test.moc"
