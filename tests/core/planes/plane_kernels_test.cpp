// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/planes/plane_kernels.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <QtTest>

#include "core/simulation/random.h"
#include "core/types/angle.h"
#include "tests/core/planes/seen_statistics.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kLimit = 9.21;

bool sameBits(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Segments on a plane of which each slice has one, two or three; each takes noise as it says.
struct Wall {
    std::vector<SliceFrame> frames;
    std::vector<std::vector<SegmentStatistics>> slices;
    SegmentBatch batch;

    explicit Wall(const NoiseParameters& noise)
    {
        Random random(3);
        for (int k = 0; k < 50; ++k) {
            const double tilt = degrees(40.0 + 2.0 * k);
            std::vector<SegmentStatistics> segments;
            for (int i = 0; i <= k % 3; ++i) {
                // The shortest have two points 5 mm apart: it is noise that directs their lines.
                const int last = 300 + 40 * i + (k % 7 == 0 ? 1 : 30);
                segments.push_back(
                    seen({Eigen::Vector3d{0.2, 0.9, 0.3}.normalized(), 1.2, 300 + 40 * i, last}, tilt, noise));
                disturb(segments.back(), random);
            }
            frames.push_back(frameOf(tilt, kSensor));
            slices.push_back(std::move(segments));
        }
        std::vector<SegmentBatch::Placed> all;
        visit([&](const SegmentStatistics& s, const SliceFrame& frame) { all.push_back({&s, &frame}); });
        batch.fill(all.size(), [&](std::size_t i) { return all[i]; });
    }

    template <class Visit>
    void visit(Visit visitSegment) const
    {
        for (std::size_t k = 0; k < slices.size(); ++k) {
            for (const SegmentStatistics& segment : slices[k])
                visitSegment(segment, frames[k]);
        }
    }

    /// The plane of its slices, one after another, with a floor [m].
    PlaneEstimate estimate(const NoiseParameters& noise, double floor) const
    {
        PlaneEstimate estimate(Eigen::Vector3d{0.21, 0.9, 0.29}.normalized(), 1.21);
        for (std::size_t k = 0; k < slices.size(); ++k) {
            std::vector<const SegmentStatistics*> segments;
            for (const SegmentStatistics& segment : slices[k])
                segments.push_back(&segment);
            estimate.accumulate(estimate.inSlice(frames[k]), segments, noise, floor, 1.0);
        }
        return estimate;
    }
};

NoiseParameters noiseOf(bool pitchCommon)
{
    NoiseParameters noise;
    noise.pitchCommon = pitchCommon;
    return noise;
}

}  // namespace

class PlaneKernelsTest : public QObject {
    Q_OBJECT

private slots:
    void everyKindTellsTheBitsOfOneByOne_data();
    void everyKindTellsTheBitsOfOneByOne();
    void everyKindAddsUpTheBitsOfSliceBySlice_data() { everyKindTellsTheBitsOfOneByOne_data(); }
    void everyKindAddsUpTheBitsOfSliceBySlice();
    void aSliceInThePlaneIsInfinitelyFarOff();
};

void PlaneKernelsTest::everyKindTellsTheBitsOfOneByOne_data()
{
    QTest::addColumn<bool>("pitchCommon");
    QTest::addColumn<double>("floor");
    for (const bool common : {true, false}) {
        for (const double floor : {0.0, 0.002})
            QTest::addRow("pitch of each %s, floor %g", common ? "slice" : "point", floor) << common << floor;
    }
}

void PlaneKernelsTest::everyKindTellsTheBitsOfOneByOne()
{
    QFETCH(bool, pitchCommon);
    QFETCH(double, floor);
    const NoiseParameters noise = noiseOf(pitchCommon);
    const Wall wall(noise);
    PlaneEstimate plane = wall.estimate(noise, floor);
    QVERIFY(plane.solve());
    const auto count = static_cast<std::size_t>(wall.batch.size());
    QVERIFY(count > 2 * kBatch && count % kBatch != 0);

    for (const PlaneKernels& kernels : availablePlaneKernels()) {
        std::vector<double> joined(count);
        std::vector<double> limited(count);
        std::vector<double> residual(count);
        std::vector<PitchEvidence> evidences(count);
        plane.joinChis(wall.batch, noise, floor, kInfinite, joined, kernels);
        plane.joinChis(wall.batch, noise, floor, kLimit, limited, kernels);
        plane.residualChis(wall.batch, noise, floor, residual, kernels);
        plane.pitchEvidences(wall.batch, noise, floor, evidences, kernels);

        std::size_t i = 0;
        wall.visit([&](const SegmentStatistics& s, const SliceFrame& frame) {
            const PlaneInSlice seen = plane.inSlice(frame);
            const PitchEvidence evidence = plane.pitchEvidence(seen, s, noise, floor);
            QVERIFY2(sameBits(joined[i], plane.joinChi(seen, s, noise, floor)), kernels.name);
            QVERIFY2(sameBits(limited[i], plane.joinChi(seen, s, noise, floor, kLimit)), kernels.name);
            QVERIFY2(sameBits(residual[i], plane.residualChi(seen, s, noise, floor)), kernels.name);
            QVERIFY2(sameBits(evidences[i].information, evidence.information), kernels.name);
            QVERIFY2(sameBits(evidences[i].gradient, evidence.gradient), kernels.name);
            ++i;
        });
        QCOMPARE(i, count);
    }
}

void PlaneKernelsTest::everyKindAddsUpTheBitsOfSliceBySlice()
{
    QFETCH(bool, pitchCommon);
    QFETCH(double, floor);
    const NoiseParameters noise = noiseOf(pitchCommon);
    const Wall wall(noise);
    PlaneEstimate expected = wall.estimate(noise, floor);
    QVERIFY(expected.solve());

    for (const PlaneKernels& kernels : availablePlaneKernels()) {
        PlaneEstimate plane(Eigen::Vector3d{0.21, 0.9, 0.29}.normalized(), 1.21);
        plane.accumulate(wall.batch, noise, floor, kernels);
        QVERIFY(plane.solve());

        QVERIFY2(plane.normal() == expected.normal(), kernels.name);
        QVERIFY2(sameBits(plane.distance(), expected.distance()), kernels.name);
        QVERIFY2(plane.covariance() == expected.covariance(), kernels.name);
        QVERIFY2(sameBits(plane.chi(), expected.chi()), kernels.name);
    }
}

void PlaneKernelsTest::aSliceInThePlaneIsInfinitelyFarOff()
{
    const NoiseParameters noise = noiseOf(true);
    const SliceFrame frame = frameOf(degrees(60.0), kSensor);
    const SegmentStatistics segment = seen({Eigen::Vector3d::UnitY(), 3.0, 300, 340}, degrees(60.0), noise);
    // It holds the pitch axis' direction and the slice's own way ahead.
    const Eigen::Vector3d normal = Eigen::Vector3d::UnitX().cross(frame.ahead);
    const PlaneEstimate plane(normal, normal.dot(frame.origin));
    SegmentBatch batch;
    batch.fill(1, [&](std::size_t) { return SegmentBatch::Placed{&segment, &frame}; });

    for (const PlaneKernels& kernels : availablePlaneKernels()) {
        double chi = 0.0;
        plane.joinChis(batch, noise, 0.0, kInfinite, std::span{&chi, 1}, kernels);

        QVERIFY2(chi == kInfinite, kernels.name);
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaneKernelsTest)
#include "plane_kernels_test.moc"
