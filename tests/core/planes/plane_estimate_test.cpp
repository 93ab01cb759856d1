// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_estimate.h"

#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <QtTest>

#include "core/planes/end_point_cost.h"
#include "core/simulation/random.h"
#include "core/types/angle.h"
#include "tests/core/planes/seen_statistics.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

/// Two segments of one slice on a plane, exact, with information of their own.
struct SeenSlice {
    SliceFrame frame;
    std::vector<SegmentStatistics> segments;

    std::vector<const SegmentStatistics*> pointers() const
    {
        std::vector<const SegmentStatistics*> all;
        for (const SegmentStatistics& segment : segments)
            all.push_back(&segment);
        return all;
    }
};

/// What a slice at this tilt sees of the plane n·p = d: a segment from u to u + 1 and one from u + 2 to u + 2.5.
SeenSlice seenAt(double tilt, const Eigen::Vector3d& normal, double distance, double u)
{
    SeenSlice slice{frameOf(tilt, kSensor), {}};
    const Trace trace = traceOf(normal, distance, slice.frame);
    const Eigen::Vector2d direction = trace.direction();
    for (const auto& [from, to] : {std::pair{u, u + 1.0}, std::pair{u + 2.0, u + 2.5}}) {
        SegmentStatistics segment;
        segment.points = 100;
        segment.directionU = direction.x();
        segment.directionV = direction.y();
        segment.u = 0.5 * (from + to);
        segment.v = (trace.c - trace.a * segment.u) / trace.b;
        segment.end = 0.5 * (to - from) / std::abs(direction.x());
        segment.start = -segment.end;
        segment.offsetInformation = 100.0 / 64e-6;
        segment.slopeInformation = segment.offsetInformation * segment.end * segment.end / 3.0;
        slice.segments.push_back(segment);
    }
    return slice;
}

/// Turns a slice by a pitch error: it is seen in another plane than it says.
void pitch(SeenSlice& slice, double tilt)
{
    slice.frame = frameOf(tilt, kSensor);
}

const Eigen::Vector3d kNormal = Eigen::Vector3d{0.3, 0.2, -0.93}.normalized();
constexpr double kDistance = 1.4;

NoiseParameters noiseOf(double pitchSigma)
{
    NoiseParameters noise;
    noise.pitch = pitchSigma;
    return noise;
}

std::vector<SeenSlice> manySlices()
{
    std::vector<SeenSlice> slices;
    for (int k = 0; k < 12; ++k)
        slices.push_back(seenAt(degrees(35.0 + 2.0 * k), kNormal, kDistance, -1.0 + 0.1 * k));
    return slices;
}

PlaneEstimate estimateOf(const std::vector<SeenSlice>& slices, const NoiseParameters& noise,
                         PlaneEstimate estimate = PlaneEstimate(kNormal, kDistance))
{
    for (const SeenSlice& slice : slices)
        estimate.accumulate(estimate.inSlice(slice.frame), slice.pointers(), noise, 0.0, 1.0);
    return estimate;
}

}  // namespace

class PlaneEstimateTest : public QObject {
    Q_OBJECT

private slots:
    void frameIsThatOfEq6();
    void frameDerivativesMatchNumericOnes();
    void functionsOfASliceMatchThePlane();
    void exactSegmentsGiveTheirPlane();
    void informationIsThatOfTheDenseModel();
    void whatIsTakenAwayLeavesNoTrace();
    void oneSegmentDeterminesNoPlane();
    void covarianceIsHonestWithCommonPitchErrors();
    void ownPitchErrorsOfPointsWeighLess();
    void fewPointsThatNoiseDirectsWeighAsOnThePlane();
    void anErrorThatAllShareWidensTheCovariance();
    void afreshTheCovarianceIsInTheTangentsOfNow();
    void joinChiHasItsExpectation();
    void aLimitOnlyEndsTheWorkEarly();
    void aSegmentOffThePlaneDoesNotJoin();
    void samePlanesMergeAndOthersDoNot();
    void mergingDoesNotAskForTheSideOfTheNormal();
};

void PlaneEstimateTest::frameIsThatOfEq6()
{
    const SliceFrame frame = frameOf(1.1, kSensor);
    const double range = 3.0;
    const double bearing = 0.7;

    const Eigen::Vector3d point = frame.pointAt(range * std::cos(bearing), range * std::sin(bearing));

    QVERIFY(point.isApprox(toCartesian(range, bearing, 1.1, kSensor), 1e-12));
}

void PlaneEstimateTest::frameDerivativesMatchNumericOnes()
{
    constexpr double kStep = 1e-6;
    const SliceFrame frame = frameOf(1.1, kSensor);
    const SliceFrame before = frameOf(1.1 - kStep, kSensor);
    const SliceFrame after = frameOf(1.1 + kStep, kSensor);

    QVERIFY(((after.ahead - before.ahead) / (2.0 * kStep)).isApprox(frame.aheadTurned, 1e-8));
    QVERIFY(((after.origin - before.origin) / (2.0 * kStep)).isApprox(frame.originTurned, 1e-8));
}

void PlaneEstimateTest::functionsOfASliceMatchThePlane()
{
    const SliceFrame frame = frameOf(1.3, kSensor);
    const PlaneEstimate estimate(kNormal, kDistance);
    const Eigen::Matrix<double, 3, 2> tangents = tangentsOf(kNormal);
    const Eigen::Vector3d point = frame.pointAt(0.4, 2.2);

    const PlaneInSlice seen = estimate.inSlice(frame);

    QVERIFY(std::abs(seen.distance.at(0.4, 2.2) - (kNormal.dot(point) - kDistance)) < 1e-12);
    QVERIFY(std::abs(seen.first.at(0.4, 2.2) - tangents.col(0).dot(point)) < 1e-12);
    QVERIFY(std::abs(seen.second.at(0.4, 2.2) - tangents.col(1).dot(point)) < 1e-12);
    constexpr double kStep = 1e-6;
    const double turned =
        kNormal.dot(frameOf(1.3 + kStep, kSensor).pointAt(0.4, 2.2) - frameOf(1.3 - kStep, kSensor).pointAt(0.4, 2.2)) /
        (2.0 * kStep);
    QVERIFY(std::abs(seen.pitch.at(0.4, 2.2) - turned) < 1e-8);
}

void PlaneEstimateTest::exactSegmentsGiveTheirPlane()
{
    // From a start that is 2° and 3 cm off; a second linearisation takes away what the first leaves.
    PlaneEstimate estimate((kNormal + 0.035 * tangentsOf(kNormal).col(0)).normalized(), kDistance + 0.03);
    for (int round = 0; round < 4; ++round) {
        estimate = estimateOf(manySlices(), noiseOf(0.001), PlaneEstimate(estimate.normal(), estimate.distance()));
        QVERIFY(estimate.solve());
    }

    QVERIFY((estimate.normal() - kNormal).norm() < 1e-10);
    QVERIFY(std::abs(estimate.distance() - kDistance) < 1e-10);
    QVERIFY(estimate.chi() < 1e-8);
}

void PlaneEstimateTest::informationIsThatOfTheDenseModel()
{
    // F = Σ A' (D + σ² g g')⁻¹ A with the rows of a slice's segments written out.
    const NoiseParameters noise = noiseOf(0.002);
    const Eigen::Matrix<double, 3, 2> tangents = tangentsOf(kNormal);
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (const SeenSlice& slice : manySlices()) {
        const double steepness = std::pow(kNormal.x(), 2) + std::pow(kNormal.dot(slice.frame.ahead), 2);
        Eigen::Matrix<double, 4, 3> rows;
        Eigen::Matrix4d variance = Eigen::Matrix4d::Zero();
        Eigen::Vector4d g;
        for (int i = 0; i < 2; ++i) {
            const SegmentStatistics& s = slice.segments[static_cast<std::size_t>(i)];
            const Eigen::Vector3d place = slice.frame.pointAt(s.u, s.v);
            const Eigen::Vector3d along = Eigen::Vector3d{s.directionU, 0.0, 0.0} + s.directionV * slice.frame.ahead;
            rows.row(2 * i) << (tangents.transpose() * place).transpose(), -1.0;
            rows.row(2 * i + 1) << (tangents.transpose() * along).transpose(), 0.0;
            variance(2 * i, 2 * i) = steepness / s.offsetInformation;
            variance(2 * i + 1, 2 * i + 1) = steepness / s.slopeInformation;
            g[2 * i] = kNormal.dot(s.v * slice.frame.aheadTurned + slice.frame.originTurned);
            g[2 * i + 1] = kNormal.dot(s.directionV * slice.frame.aheadTurned);
        }
        variance += noise.pitch * noise.pitch * g * g.transpose();
        information += rows.transpose() * variance.inverse() * rows;
    }

    PlaneEstimate estimate = estimateOf(manySlices(), noise);
    QVERIFY(estimate.solve());

    QVERIFY((estimate.covariance() * information).isApprox(Eigen::Matrix3d::Identity(), 1e-6));
}

void PlaneEstimateTest::whatIsTakenAwayLeavesNoTrace()
{
    const NoiseParameters noise = noiseOf(0.001);
    auto slices = manySlices();
    disturb(slices[3].segments[0], 0.004, 0.002);
    PlaneEstimate without = estimateOf({slices.begin(), slices.begin() + 8}, noise);
    PlaneEstimate estimate = estimateOf(slices, noise);

    for (std::size_t i = 8; i < slices.size(); ++i)
        estimate.accumulate(estimate.inSlice(slices[i].frame), slices[i].pointers(), noise, 0.0, -1.0);

    QVERIFY(without.solve() && estimate.solve());
    QVERIFY(estimate.normal().isApprox(without.normal(), 1e-9));
    QVERIFY(estimate.covariance().isApprox(without.covariance(), 1e-6));
}

void PlaneEstimateTest::oneSegmentDeterminesNoPlane()
{
    SeenSlice slice = seenAt(degrees(40.0), kNormal, kDistance, 0.0);
    slice.segments.pop_back();
    PlaneEstimate estimate(kNormal, kDistance);
    estimate.accumulate(estimate.inSlice(slice.frame), slice.pointers(), noiseOf(0.001), 0.0, 1.0);

    QVERIFY(!estimate.solve() || estimate.normalVariance() > 1.0);
}

void PlaneEstimateTest::covarianceIsHonestWithCommonPitchErrors()
{
    const NoiseParameters noise = noiseOf(degrees(0.084));
    Random random(11);
    double squares = 0.0;
    constexpr int kTrials = 400;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<SeenSlice> slices;
        for (int k = 0; k < 12; ++k) {
            const double tilt = degrees(35.0 + 2.0 * k);
            SeenSlice slice =
                seenAt(tilt + noise.pitch * random.normalPair().first, kNormal, kDistance, -1.0 + 0.1 * k);
            for (SegmentStatistics& s : slice.segments)
                disturb(s, random);
            pitch(slice, tilt);
            slices.push_back(slice);
        }
        PlaneEstimate estimate = estimateOf(slices, noise);
        QVERIFY(estimate.solve());
        Eigen::Vector3d error;
        error.head<2>() = estimate.tangents().transpose() * (estimate.normal() - kNormal);
        error[2] = estimate.distance() - kDistance;
        squares += error.dot(estimate.covariance().inverse() * error) / kTrials;
    }

    // A χ² of 3 degrees of freedom has variance 6: the mean of 400 has a standard deviation of 0.12.
    QVERIFY2(std::abs(squares - 3.0) < 0.4, qPrintable(QString::number(squares)));
}

void PlaneEstimateTest::ownPitchErrorsOfPointsWeighLess()
{
    NoiseParameters common = noiseOf(0.002);
    NoiseParameters own = common;
    own.pitchCommon = false;
    PlaneEstimate a = estimateOf(manySlices(), common);
    PlaneEstimate b = estimateOf(manySlices(), own);
    PlaneEstimate exact = estimateOf(manySlices(), noiseOf(0.0));

    QVERIFY(a.solve() && b.solve() && exact.solve());
    // Errors of a hundred points average out; that of a slice does not.
    QVERIFY(b.covariance()(2, 2) < a.covariance()(2, 2));
    QVERIFY(b.covariance()(2, 2) > exact.covariance()(2, 2));
}

void PlaneEstimateTest::fewPointsThatNoiseDirectsWeighAsOnThePlane()
{
    // Four points 1 m away on a wall ahead, 4 mm from one to the next, with 30 mm of noise along the ray: their line
    // may run anywhere, and here it runs along the ray but for 2°. The noise across it is next to none, across the wall
    // all.
    NoiseParameters noise{0.03, 0.0, 0.0, 0.0};
    const SliceFrame frame = frameOf(degrees(90.0), kSensor);
    const double wall = frame.origin.y() + 1.0;
    SegmentStatistics segment;
    segment.points = 4;
    segment.u = 0.0;
    segment.v = 1.0;
    segment.directionU = std::sin(degrees(2.0));
    segment.directionV = std::cos(degrees(2.0));
    segment.start = -0.04;
    segment.end = 0.04;
    segment.offsetInformation = 4.0 / std::pow(0.03 * std::sin(degrees(2.0)), 2);
    segment.slopeInformation = segment.offsetInformation * 1e-3;
    PlaneEstimate estimate(Eigen::Vector3d::UnitY(), wall);
    const PlaneInSlice seen = estimate.inSlice(frame);

    const double chi = estimate.residualChi(seen, segment, noise, 0.0);

    // On the wall, but for the slope: inclination cos 2°, variance that of the wall, 1 / (4/0.03² · 1e-3).
    const double expected = std::pow(std::cos(degrees(2.0)), 2) * 4.0 / (0.03 * 0.03) * 1e-3;
    QVERIFY2(std::abs(chi - expected) < 1e-9, qPrintable(QString::number(chi)));
}

void PlaneEstimateTest::anErrorThatAllShareWidensTheCovariance()
{
    NoddingScan scan;
    scan.nod(8, {kWall});
    PlaneEstimate estimate = solvedFrom(PlaneEstimate(kWall.normal, kWall.distance), scan.column(0, 0, 7), scan.map,
                                        scan.parameters.noise, 0.0);
    const Eigen::Matrix3d before = estimate.covariance();
    const Eigen::Vector3d change{0.01, -0.02, 0.005};
    const Eigen::Vector3d other{0.02, 0.01, -0.01};

    estimate.addCommonErrors(std::array<Eigen::Vector3d, 2>{before.inverse() * change, before.inverse() * other});

    const Eigen::Matrix3d grown = before + change * change.transpose() + other * other.transpose();
    QVERIFY(estimate.covariance().isApprox(grown, 1e-9));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> angles(grown.topLeftCorner<2, 2>());
    QVERIFY(std::abs(estimate.normalVariance() / angles.eigenvalues()[1] - 1.0) < 1e-9);
}

/// Which axis a normal is least along decides which way its tangents point.
void PlaneEstimateTest::afreshTheCovarianceIsInTheTangentsOfNow()
{
    const Surface wall{Eigen::Vector3d(2e-3, 1.0, 1e-3).normalized(), 4.0, 200, 280};
    NoddingScan scan;
    scan.nod(8, {wall});
    const PlaneEstimate estimate = solvedFrom(PlaneEstimate(Eigen::Vector3d(1e-3, 1.0, 2e-3).normalized(), 4.0),
                                              scan.column(0, 0, 7), scan.map, scan.parameters.noise, 0.0);

    const PlaneEstimate afresh = estimate.afresh();

    QVERIFY(std::abs(estimate.tangents().col(0).dot(afresh.tangents().col(0))) < 0.1);
    const auto ofNormal = [](const PlaneEstimate& plane) {
        return Eigen::Matrix3d(plane.tangents() * plane.covariance().topLeftCorner<2, 2>() *
                               plane.tangents().transpose());
    };
    QVERIFY((ofNormal(afresh) - ofNormal(estimate)).norm() < 0.01 * ofNormal(estimate).norm());
    // How well it is known where it was seen does not depend on the tangents.
    const Eigen::Vector3d place{-2.0, 4.0, 0.5};
    QVERIFY(std::abs(afresh.varianceAt(place) / estimate.varianceAt(place) - 1.0) < 0.02);
}

void PlaneEstimateTest::joinChiHasItsExpectation()
{
    const NoiseParameters noise = noiseOf(degrees(0.05));
    PlaneEstimate plane = estimateOf(manySlices(), noise);
    QVERIFY(plane.solve());
    const double tilt = degrees(61.0);
    const SliceFrame frame = frameOf(tilt, kSensor);
    Random random(5);
    double sum = 0.0;
    constexpr int kTrials = 2000;
    const Eigen::Matrix<double, 3, 2> tangents = plane.tangents();
    const Eigen::Matrix3d root = plane.covariance().llt().matrixL();
    for (int trial = 0; trial < kTrials; ++trial) {
        // The true plane strays from the estimate as the covariance says.
        const Eigen::Vector3d off =
            root * Eigen::Vector3d{random.normalPair().first, random.normalPair().first, random.normalPair().first};
        const Eigen::Vector3d normal = kNormal + tangents * off.head<2>();
        SeenSlice slice = seenAt(tilt + noise.pitch * random.normalPair().first, normal.normalized(),
                                 (kDistance + off[2]) / normal.norm(), 0.3);
        SegmentStatistics& s = slice.segments[0];
        disturb(s, random);
        sum += plane.joinChi(plane.inSlice(frame), s, noise, 0.0) / kTrials;
    }

    // Mean of 2000 χ² of 2 degrees of freedom: standard deviation 0.045.
    QVERIFY2(std::abs(sum - 2.0) < 0.15, qPrintable(QString::number(sum)));
}

void PlaneEstimateTest::aLimitOnlyEndsTheWorkEarly()
{
    constexpr double kLimit = 9.21;
    constexpr double kFloor = 0.002;
    for (const bool pitchCommon : {true, false}) {
        NoiseParameters noise = noiseOf(degrees(0.05));
        noise.pitchCommon = pitchCommon;
        PlaneEstimate plane = estimateOf(manySlices(), noise);
        QVERIFY(plane.solve());
        Random random(8);
        int met = 0;
        int surelyNot = 0;
        for (int trial = 0; trial < 2000; ++trial) {
            const double tilt = degrees(55.0 + 10.0 * random.uniform());
            const double off = 0.05 * random.normalPair().first;
            SegmentStatistics s = seenAt(tilt, kNormal, kDistance + off, random.uniform()).segments[0];
            disturb(s, random);
            const SliceFrame frame = frameOf(tilt, kSensor);
            const PlaneInSlice seen = plane.inSlice(frame);
            const double chi = plane.joinChi(seen, s, noise, kFloor);
            const double limited = plane.joinChi(seen, s, noise, kFloor, kLimit);

            if (chi < kLimit)
                QCOMPARE(limited, chi);
            else
                QVERIFY(limited >= kLimit);
            const Eigen::Vector3d centroid = frame.pointAt(s.u, s.v);
            if (!plane.mayMeet(centroid, mostVariance(s, centroid, noise, kFloor), kLimit)) {
                QVERIFY(chi >= kLimit);
                ++surelyNot;
            }
            met += chi < kLimit ? 1 : 0;
        }
        // Many are told at once; those that join are among the others.
        QVERIFY(met > 100);
        QVERIFY(surelyNot > 1000);
    }
}

void PlaneEstimateTest::aSegmentOffThePlaneDoesNotJoin()
{
    const NoiseParameters noise = noiseOf(degrees(0.05));
    PlaneEstimate plane = estimateOf(manySlices(), noise);
    QVERIFY(plane.solve());
    SeenSlice slice = seenAt(degrees(61.0), kNormal, kDistance, 0.3);
    disturb(slice.segments[0], 0.05, 0.0);
    disturb(slice.segments[1], 0.0, 0.3);

    for (const SegmentStatistics& segment : slice.segments) {
        const double chi = plane.joinChi(plane.inSlice(slice.frame), segment, noise, 0.002);
        QVERIFY2(chi > 25.0, qPrintable(QString::number(chi)));
    }
}

void PlaneEstimateTest::samePlanesMergeAndOthersDoNot()
{
    const NoiseParameters noise = noiseOf(degrees(0.05));
    const auto slices = manySlices();
    PlaneEstimate lower = estimateOf({slices.begin(), slices.begin() + 6}, noise);
    PlaneEstimate upper = estimateOf({slices.begin() + 6, slices.end()}, noise);
    std::vector<SeenSlice> behind;
    for (int k = 6; k < 12; ++k)
        behind.push_back(seenAt(degrees(35.0 + 2.0 * k), kNormal, kDistance + 0.1, -1.0));
    PlaneEstimate other = estimateOf(behind, noise, PlaneEstimate(kNormal, kDistance + 0.1));
    QVERIFY(lower.solve() && upper.solve() && other.solve());

    QVERIFY(lower.mergeChi(upper, 0.001, 1.0) < 1e-6);
    QVERIFY(lower.mergeChi(other, 0.001, 1.0) > 25.0);
}

void PlaneEstimateTest::mergingDoesNotAskForTheSideOfTheNormal()
{
    const NoiseParameters noise = noiseOf(degrees(0.05));
    auto slices = manySlices();
    for (std::size_t i = 0; i < slices.size(); ++i)
        disturb(slices[i].segments[0], i % 2 == 0 ? 0.001 : -0.002, 0.0);
    PlaneEstimate lower = estimateOf({slices.begin(), slices.begin() + 6}, noise);
    PlaneEstimate upper = estimateOf({slices.begin() + 6, slices.end()}, noise);
    PlaneEstimate turned = estimateOf({slices.begin() + 6, slices.end()}, noise, PlaneEstimate(-kNormal, -kDistance));
    QVERIFY(lower.solve() && upper.solve() && turned.solve());

    const double chi = lower.mergeChi(upper, 0.0, 1.0);

    QVERIFY(chi > 0.0);
    QVERIFY(std::abs(lower.mergeChi(turned, 0.0, 1.0) - chi) < 1e-6 * chi + 1e-9);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaneEstimateTest)
#include "plane_estimate_test.moc"
