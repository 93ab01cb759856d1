// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/complete_labels.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <QtTest>

#include "core/geometry/sensor_model.h"
#include "core/planes/end_point_cost.h"
#include "core/types/angle.h"
#include "tests/core/params/preset_parameters.h"
#include "tests/test_program.h"

namespace planewright {
namespace {

using Line = std::vector<PlaneId>;

constexpr int kBeams = 60;
constexpr PlaneId kWall = 0;
constexpr PlaneId kBehind = 1;
constexpr PlaneId kSide = 3;  // numbers of planes have gaps

/// Three walls: 4 m ahead, 4.3 m ahead, and one at the left that meets the first at 45°.
struct Walls {
    std::vector<std::shared_ptr<const Plane>> planes;

    Walls()
    {
        add(kWall, Eigen::Vector3d::UnitY(), 4.0);
        add(kBehind, Eigen::Vector3d::UnitY(), 4.3);
        const Eigen::Vector3d side = Eigen::Vector3d{-1.0, 1.0, 0.0}.normalized();
        add(kSide, side, side.dot(Eigen::Vector3d{-0.02, 4.0, 0.0}));
    }

private:
    void add(PlaneId id, const Eigen::Vector3d& normal, double distance)
    {
        auto plane = std::make_shared<Plane>();
        plane->id = id;
        plane->normal = normal;
        plane->distance = distance;
        plane->tangents = tangentsOf(normal);
        plane->covariance = Eigen::Vector3d{1e-8, 1e-8, 1e-8}.asDiagonal();
        planes.push_back(plane);
    }
};

/// A level scan of beams a quarter of a degree apart, the middle one straight ahead, and the labels it has so far.
struct Labelled {
    Parameters parameters = precise();
    Recording recording;
    Snapshot snapshot;
    std::vector<Line> labels;

    explicit Labelled(int slices = 1)
    {
        snapshot.planes = Walls().planes;
        recording.description = {"", degrees(82.5), degrees(0.25), kBeams + 1, 0.1, 30.0, 0.05, {}};
        for (int k = 0; k < slices; ++k) {
            ScanSlice slice;
            slice.step = k;
            slice.tilt = degrees(90.0 + k);
            slice.firstBearing = recording.description.firstBearing;
            slice.bearingStep = recording.description.bearingStep;
            slice.ranges.assign(kBeams + 1, 0.0);
            recording.slices.push_back(slice);
            labels.emplace_back(kBeams + 1, kNoPlane);
        }
    }

    /// Lets beams of a slice see a plane, or what is so far behind it [m], and gives them a label.
    void see(int slice, int first, int last, PlaneId plane, PlaneId label, double behind = 0.0)
    {
        for (int beam = first; beam <= last; ++beam) {
            range(slice, beam) = rangeTo(slice, beam, plane, behind);
            at(slice, beam) = label;
        }
    }
    double rangeTo(int slice, int beam, PlaneId id, double behind = 0.0) const
    {
        const Plane& plane =
            **std::find_if(snapshot.planes.begin(), snapshot.planes.end(), [id](const auto& p) { return p->id == id; });
        const ScanSlice& scan = recording.slices[static_cast<std::size_t>(slice)];
        const SensorModel sensor = sensorOf(recording.description);
        const double bearing = scan.bearing(static_cast<std::size_t>(beam));
        const Eigen::Vector3d laser = toCartesian(0.0, bearing, scan.tilt, sensor);
        const Eigen::Vector3d ray = toCartesian(1.0, bearing, scan.tilt, sensor) - laser;
        return (plane.distance + behind - plane.normal.dot(laser)) / plane.normal.dot(ray);
    }
    double& range(int slice, int beam)
    {
        return recording.slices[static_cast<std::size_t>(slice)].ranges[static_cast<std::size_t>(beam)];
    }
    PlaneId& at(int slice, int beam) { return labels[static_cast<std::size_t>(slice)][static_cast<std::size_t>(beam)]; }
    Line beams(int slice, int first, int last)
    {
        const auto begin = labels[static_cast<std::size_t>(slice)].begin();
        return {begin + first, begin + last + 1};
    }
    void complete()
    {
        snapshot.noise = {parameters.noise.rangeConstant, parameters.noise.rangeProportional, parameters.noise.pitch,
                          false};
        completeLabels(labels, snapshot, recording, parameters);
    }
};

Line repeated(int count, PlaneId id)
{
    return Line(static_cast<std::size_t>(count), id);
}

}  // namespace

class CompleteLabelsTest : public QObject {
    Q_OBJECT

private slots:
    void echoesInAGapOfAPlaneAreIts();
    void echoesOffThePlaneAreNot_data();
    void echoesOffThePlaneAreNot();
    void threeStandardDeviationsAreTheLimit_data();
    void threeStandardDeviationsAreTheLimit();
    void whatThePlaneIsNotKnownToCounts();
    void beamsWithoutEchoStayWithoutPlane_data();
    void beamsWithoutEchoStayWithoutPlane();
    void echoesBesideThePlaneAreIts_data();
    void echoesBesideThePlaneAreIts();
    void echoesFarFromThePlaneAreNot();
    void theNearerOfTwoPlanesGetsTheEcho();
    void sameBeamOneSliceBeforeOrAfterCounts_data();
    void sameBeamOneSliceBeforeOrAfterCounts();
    void bordersMoveToWhereTheEchoesSay_data();
    void bordersMoveToWhereTheEchoesSay();
    void bordersMoveSixEchoesAtMost();
    void bordersAreBetweenNeighboursOnly();
    void aMirroredSliceIsLabelledAlike();
    void labelsOfTheEstimatorByEndPointsStay();
};

void CompleteLabelsTest::echoesInAGapOfAPlaneAreIts()
{
    Labelled scan;
    scan.see(0, 10, 20, kWall, kWall);
    scan.see(0, 21, 25, kWall, kNoPlane);
    scan.see(0, 26, 40, kWall, kWall);

    scan.complete();

    QVERIFY(scan.beams(0, 10, 40) == repeated(31, kWall));
    QVERIFY(scan.beams(0, 0, 9) == repeated(10, kNoPlane));
}

void CompleteLabelsTest::echoesOffThePlaneAreNot_data()
{
    QTest::addColumn<double>("behind");

    QTest::newRow("10 cm behind") << 0.1;
    QTest::newRow("10 cm before") << -0.1;
    QTest::newRow("4 cm behind") << 0.04;
}

void CompleteLabelsTest::echoesOffThePlaneAreNot()
{
    QFETCH(const double, behind);
    Labelled scan;
    scan.see(0, 10, 20, kWall, kWall);
    scan.see(0, 21, 25, kWall, kNoPlane, behind);
    scan.see(0, 26, 40, kWall, kWall);

    scan.complete();

    QVERIFY(scan.beams(0, 21, 25) == repeated(5, kNoPlane));
}

void CompleteLabelsTest::threeStandardDeviationsAreTheLimit_data()
{
    QTest::addColumn<double>("sigmas");
    QTest::addColumn<bool>("labelled");

    QTest::newRow("2.9 behind") << 2.9 << true;
    QTest::newRow("3.1 behind") << 3.1 << false;
    QTest::newRow("2.9 before") << -2.9 << true;
    QTest::newRow("3.1 before") << -3.1 << false;
}

void CompleteLabelsTest::threeStandardDeviationsAreTheLimit()
{
    QFETCH(const double, sigmas);
    QFETCH(const bool, labelled);
    Labelled scan;
    scan.parameters.noise.rangeConstant = 0.03;
    scan.parameters.noise.rangeProportional = 0.01;
    scan.parameters.planes.flatness = 0.02;
    // Straight ahead only the range counts: 3 cm and 4 cm of it and 2 cm of the wall.
    scan.see(0, 22, 38, kWall, kWall);
    scan.see(0, 30, 30, kWall, kNoPlane, sigmas * std::sqrt(0.03 * 0.03 + 0.04 * 0.04 + 0.02 * 0.02));

    scan.complete();

    QCOMPARE(scan.at(0, 30), labelled ? kWall : kNoPlane);
}

void CompleteLabelsTest::whatThePlaneIsNotKnownToCounts()
{
    Labelled scan;
    scan.see(0, 22, 38, kWall, kWall);
    scan.see(0, 30, 30, kWall, kNoPlane, 0.05);
    auto plane = std::make_shared<Plane>(*scan.snapshot.planes[0]);
    plane->covariance(2, 2) = 0.02 * 0.02;
    scan.snapshot.planes[0] = plane;

    scan.complete();

    QCOMPARE(scan.at(0, 30), kWall);
}

void CompleteLabelsTest::beamsWithoutEchoStayWithoutPlane_data()
{
    QTest::addColumn<double>("rangeMax");
    QTest::addColumn<double>("range");

    QTest::newRow("no return") << 30.0 << 0.0;
    QTest::newRow("farther than ranges count") << 3.999 << 4.0;
}

void CompleteLabelsTest::beamsWithoutEchoStayWithoutPlane()
{
    QFETCH(const double, rangeMax);
    QFETCH(const double, range);
    Labelled scan;
    scan.see(0, 22, 38, kWall, kWall);
    scan.recording.description.rangeMax = rangeMax;
    scan.at(0, 30) = kNoPlane;
    scan.range(0, 30) = range;

    scan.complete();

    QCOMPARE(scan.at(0, 30), kNoPlane);
}

void CompleteLabelsTest::echoesBesideThePlaneAreIts_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("last");

    QTest::newRow("eight to the left") << 31 << 38;
    QTest::newRow("eight to the right") << 12 << 19;
    QTest::newRow("one after the other to the left") << 31 << 45;
    QTest::newRow("one after the other to the right") << 5 << 19;
}

void CompleteLabelsTest::echoesBesideThePlaneAreIts()
{
    QFETCH(const int, first);
    QFETCH(const int, last);
    Labelled scan;
    scan.see(0, 20, 30, kWall, kWall);
    scan.see(0, first, last, kWall, kNoPlane);

    scan.complete();

    QVERIFY(scan.beams(0, first, last) == repeated(last - first + 1, kWall));
    QCOMPARE(std::count(scan.labels[0].begin(), scan.labels[0].end(), kWall), 11 + last - first + 1);
}

void CompleteLabelsTest::echoesFarFromThePlaneAreNot()
{
    // Nine beams on the left, and nine on the right: without echoes in between nobody passes the label on.
    Labelled scan;
    scan.see(0, 20, 30, kWall, kWall);
    for (const int beam : {11, 12, 38, 39})
        scan.see(0, beam, beam, kWall, kNoPlane);

    scan.complete();

    QCOMPARE(scan.at(0, 12), kWall);
    QCOMPARE(scan.at(0, 38), kWall);
    // They are next to the ones that have it now.
    QCOMPARE(scan.at(0, 11), kWall);
    QCOMPARE(scan.at(0, 39), kWall);

    Labelled far;
    far.see(0, 20, 30, kWall, kWall);
    for (const int beam : {11, 39})
        far.see(0, beam, beam, kWall, kNoPlane);

    far.complete();

    QCOMPARE(far.at(0, 11), kNoPlane);
    QCOMPARE(far.at(0, 39), kNoPlane);
}

void CompleteLabelsTest::theNearerOfTwoPlanesGetsTheEcho()
{
    // With two centimetres of range noise both walls are within three sigmas of what lies between them.
    for (const double behind : {0.14, 0.16}) {
        Labelled scan;
        scan.parameters.noise.rangeConstant = 0.08;
        scan.see(0, 22, 29, kWall, kWall);
        scan.see(0, 30, 30, kWall, kNoPlane, behind);
        scan.see(0, 31, 38, kBehind, kBehind);

        scan.complete();

        QCOMPARE(scan.at(0, 30), behind < 0.15 ? kWall : kBehind);
    }
}

void CompleteLabelsTest::sameBeamOneSliceBeforeOrAfterCounts_data()
{
    QTest::addColumn<int>("distance");
    QTest::addColumn<bool>("labelled");

    QTest::newRow("one before") << -1 << true;
    QTest::newRow("one after") << 1 << true;
    QTest::newRow("two before") << -2 << false;
    QTest::newRow("two after") << 2 << false;
}

void CompleteLabelsTest::sameBeamOneSliceBeforeOrAfterCounts()
{
    QFETCH(const int, distance);
    QFETCH(const bool, labelled);
    Labelled scan(5);
    scan.see(2 + distance, 30, 30, kSide, kSide);
    scan.see(2, 29, 31, kSide, kNoPlane);

    scan.complete();

    QVERIFY(scan.beams(2, 29, 31) == repeated(3, labelled ? kSide : kNoPlane));
}

void CompleteLabelsTest::bordersMoveToWhereTheEchoesSay_data()
{
    QTest::addColumn<int>("border");

    // The walls meet 2 cm left of the middle, at y = 4 m: at beam 31.1.
    QTest::newRow("right already") << 32;
    QTest::newRow("four too far right") << 28;
    QTest::newRow("five too far left") << 37;
}

void CompleteLabelsTest::bordersMoveToWhereTheEchoesSay()
{
    QFETCH(const int, border);
    Labelled scan;
    scan.see(0, 10, 31, kWall, kWall);
    scan.see(0, 32, 50, kSide, kSide);
    for (int beam = 10; beam <= 50; ++beam)
        scan.at(0, beam) = beam < border ? kWall : kSide;

    scan.complete();

    QVERIFY(scan.beams(0, 10, 31) == repeated(22, kWall));
    QVERIFY(scan.beams(0, 32, 50) == repeated(19, kSide));
}

void CompleteLabelsTest::bordersMoveSixEchoesAtMost()
{
    for (const int border : {26, 25, 38, 39}) {
        Labelled scan;
        scan.see(0, 10, 31, kWall, kWall);
        scan.see(0, 32, 50, kSide, kSide);
        for (int beam = 10; beam <= 50; ++beam)
            scan.at(0, beam) = beam < border ? kWall : kSide;

        scan.complete();

        const int expected = border < 32 ? border + 6 : border - 6;
        QVERIFY(scan.beams(0, 10, expected - 1) == repeated(expected - 10, kWall));
        QVERIFY(scan.beams(0, expected, 50) == repeated(51 - expected, kSide));
    }
}

void CompleteLabelsTest::bordersAreBetweenNeighboursOnly()
{
    // Three echoes of the wall ahead have the other's label, and a beam without echo beside them.
    Labelled scan;
    scan.see(0, 10, 26, kWall, kWall);
    scan.see(0, 28, 30, kWall, kSide);
    scan.see(0, 32, 50, kSide, kSide);

    scan.complete();

    QVERIFY(scan.beams(0, 10, 26) == repeated(17, kWall));
    QVERIFY(scan.beams(0, 28, 30) == repeated(3, kSide));
}

void CompleteLabelsTest::aMirroredSliceIsLabelledAlike()
{
    // Two walls one behind the other, with echoes of either, of both and of none about them.
    Labelled scan;
    Labelled mirror;
    const auto see = [&](int first, int last, PlaneId plane, PlaneId label, double behind) {
        scan.see(0, first, last, plane, label, behind);
        mirror.see(0, kBeams - last, kBeams - first, plane, label, behind);
    };
    see(0, 15, kWall, kNoPlane, 0.0);
    see(16, 25, kWall, kWall, 0.0);
    see(26, 28, kWall, kNoPlane, 0.15);
    see(29, 30, kBehind, kNoPlane, 0.0);
    see(31, 45, kBehind, kBehind, 0.0);
    see(46, 47, kBehind, kNoPlane, 0.1);
    see(48, 60, kBehind, kNoPlane, 0.002);

    scan.complete();
    mirror.complete();

    Line mirrored = mirror.labels[0];
    std::reverse(mirrored.begin(), mirrored.end());
    QVERIFY(scan.labels[0] == mirrored);
    QVERIFY(scan.beams(0, 0, 25) == repeated(26, kWall));
    QVERIFY(scan.beams(0, 26, 28) == repeated(3, kNoPlane));
    QVERIFY(scan.beams(0, 29, 45) == repeated(17, kBehind));
    QVERIFY(scan.beams(0, 46, 47) == repeated(2, kNoPlane));
    QVERIFY(scan.beams(0, 48, 60) == repeated(13, kBehind));
}

void CompleteLabelsTest::labelsOfTheEstimatorByEndPointsStay()
{
    Labelled scan;
    scan.parameters.method.estimator = Estimator::EndPoints;
    scan.see(0, 10, 20, kWall, kWall);
    scan.see(0, 21, 25, kWall, kNoPlane);
    scan.see(0, 26, 40, kWall, kSide);
    const Line before = scan.labels[0];

    scan.complete();

    QVERIFY(scan.labels[0] == before);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CompleteLabelsTest)
#include "complete_labels_test.moc"
