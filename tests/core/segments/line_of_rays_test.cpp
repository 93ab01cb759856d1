// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/segments/line_of_rays.h"

#include <cmath>
#include <random>
#include <vector>

#include <QtTest>

#include "core/segments/line_moments.h"
#include "core/types/angle.h"
#include "core/types/square.h"
#include "tests/core/segments/drawn_slice.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

SlicePoint pointAt(double bearing, double range)
{
    return {range * std::cos(bearing), range * std::sin(bearing)};
}

/// A door's jamb, 0.9 m from the laser at its foot, seen by six beams a quarter of a degree apart from 60° off its
/// normal on. The normal looks along v; the jamb is to the left, at −u.
struct Jamb {
    static constexpr double kAway = 0.9;
    static constexpr int kBeams = 6;

    static double angle(int beam) { return degrees(60.0 + 0.25 * beam); }
    static double range(int beam) { return kAway / std::cos(angle(beam)); }
    /// Bearings rise to the left.
    static SlicePoint point(int beam, double error = 0.0)
    {
        return pointAt(degrees(90.0) + angle(beam), range(beam) + error);
    }
};

std::vector<SlicePoint> jamb()
{
    std::vector<SlicePoint> points;
    for (int beam = 0; beam < Jamb::kBeams; ++beam)
        points.push_back(Jamb::point(beam));
    return points;
}

}  // namespace

class LineOfRaysTest : public QObject {
    Q_OBJECT

private slots:
    void exactPointsGiveTheirLine();
    void noiseTurnsTheLineToNeitherSide();
    void whatIsNoLineBeforeTheLaserIsNone();
};

void LineOfRaysTest::exactPointsGiveTheirLine()
{
    const auto line = lineOfRays(jamb());

    QVERIFY(line.has_value());
    QVERIFY(std::abs(line->normalU) < 1e-12 && std::abs(line->normalV - 1.0) < 1e-12);
    QVERIFY(std::abs(line->distance - 0.9) < 1e-12);
    // Along the line is −u: places are 0.9 m times the tangents of 60° to 61.25°.
    QVERIFY(std::abs(line->from - 0.9 * std::tan(degrees(60.0))) < 1e-12);
    QVERIFY(std::abs(line->to - 0.9 * std::tan(degrees(61.25))) < 1e-12);
    double mean = 0.0;
    for (int beam = 0; beam < Jamb::kBeams; ++beam)
        mean += 0.9 * std::tan(Jamb::angle(beam)) / Jamb::kBeams;
    double spread = 0.0;
    for (int beam = 0; beam < Jamb::kBeams; ++beam)
        spread += square(0.9 * std::tan(Jamb::angle(beam)) - mean);
    QVERIFY(std::abs(line->place - mean) < 1e-12);
    QVERIFY(std::abs(line->u + mean) < 1e-12 && std::abs(line->v - 0.9) < 1e-12);
    QVERIFY(std::abs(line->along - spread) < 1e-12);
    QVERIFY(line->across < 1e-24);
}

void LineOfRaysTest::noiseTurnsTheLineToNeitherSide()
{
    // 5 mm along rays that meet the jamb at 30°: its six points span 7 cm.
    std::mt19937_64 random(7);
    constexpr int kDraws = 20000;
    double ofRays = 0.0;
    double squares = 0.0;
    double ofLeastSquares = 0.0;
    for (int draw = 0; draw < kDraws; ++draw) {
        std::vector<SlicePoint> points;
        LineMoments moments;
        for (int beam = 0; beam < Jamb::kBeams; ++beam) {
            points.push_back(Jamb::point(beam, 0.005 * normal(random)));
            moments.add(points.back().u, points.back().v);
        }
        const auto line = lineOfRays(points);
        QVERIFY(line.has_value());
        const double turn = std::atan2(line->normalU, line->normalV);
        ofRays += turn / kDraws;
        squares += turn * turn / kDraws;
        const MomentLine fitted = lineOf(moments);
        ofLeastSquares +=
            std::atan2(fitted.normalU(), std::abs(fitted.normalV())) * std::copysign(1.0, fitted.normalV()) / kDraws;
    }

    const double sigma = std::sqrt(squares);
    // What is left is of second order: the angle is no linear function of the slope.
    QVERIFY2(std::abs(ofRays) < 0.1 * sigma, qPrintable(QString("%1 of %2").arg(ofRays).arg(sigma)));
    // Total least squares turns all of them alike, by n σ² sin ψ cos ψ over their spread along the line.
    QVERIFY2(std::abs(ofLeastSquares) > 2.0 * std::abs(ofRays),
             qPrintable(QString("%1 of %2").arg(ofLeastSquares).arg(ofRays)));
}

void LineOfRaysTest::whatIsNoLineBeforeTheLaserIsNone()
{
    const SlicePoint ahead = pointAt(degrees(90.0), 1.0);
    QVERIFY(!lineOfRays(std::vector{ahead, ahead, ahead}));
    QVERIFY(!lineOfRays(std::vector{ahead, SlicePoint{}, pointAt(degrees(91.0), 1.0)}));
    QVERIFY(!lineOfRays(std::vector{ahead, pointAt(degrees(90.0), -1.0), pointAt(degrees(91.0), 1.0)}));
    // A fold that no ray of the last point meets.
    QVERIFY(!lineOfRays(
        std::vector{pointAt(degrees(90.0), 0.1), pointAt(degrees(91.0), 10.0), pointAt(degrees(92.0), 10.0)}));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::LineOfRaysTest)
#include "line_of_rays_test.moc"
