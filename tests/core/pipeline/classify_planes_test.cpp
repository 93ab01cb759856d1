// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/pipeline/classify_planes.h"

#include <QTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

using namespace planewright;

class ClassifyPlanesTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void aRoomHasFloorCeilingAndWalls();
    void aTableIsNeitherFloorNorCeiling();
    void stepsAreOtherAndTheFloorIsTheLowest();
    void aFewPointsBelowTheFloorAreNoFloor();
    void slopesAreOther();
    void nearlyPlumbIsAWallAndNearlyLevelIsLevel();
    void aFloorInTwoPartsIsAllFloor();
    void noPlanesHaveNoClasses();

private:
    /// A plane of this elevation of its normal whose points are at one height.
    void add(double elevation, double height, int points);
    std::vector<std::string_view> classes() const { return classesOf(planes_, log_); }

    std::vector<std::shared_ptr<const Plane>> planes_;
    SegmentLog log_;
};

void ClassifyPlanesTest::init()
{
    planes_.clear();
    log_ = {};
}

void ClassifyPlanesTest::add(double elevation, double height, int points)
{
    const int step = static_cast<int>(log_.slices());
    LineSegment segment;
    segment.id = {step, 0};
    segment.points = points;
    segment.start = {1.0, 2.0, height};
    segment.end = {-1.0, 2.0, height};
    log_.append(step, std::make_shared<const Segments>(Segments{segment}));
    auto plane = std::make_shared<Plane>();
    plane->id = step;
    plane->normal = {0.0, std::cos(elevation), std::sin(elevation)};
    plane->points = points;
    plane->segments = {segment.id};
    planes_.push_back(plane);
}

void ClassifyPlanesTest::aRoomHasFloorCeilingAndWalls()
{
    add(degrees(-90.0), -0.9, 10'000);
    add(0.0, 0.5, 3'000);
    add(degrees(90.0), 2.0, 8'000);

    QCOMPARE(classes(), (std::vector<std::string_view>{"floor", "wall", "ceiling"}));
}

void ClassifyPlanesTest::aTableIsNeitherFloorNorCeiling()
{
    add(degrees(90.0), -0.9, 10'000);
    add(degrees(90.0), -0.2, 2'500);
    add(degrees(90.0), 2.5, 8'000);
    add(degrees(90.0), 2.1, 2'000);  // a lamp

    QCOMPARE(classes(), (std::vector<std::string_view>{"floor", "other", "ceiling", "other"}));
}

void ClassifyPlanesTest::stepsAreOtherAndTheFloorIsTheLowest()
{
    for (const double height : {-1.0, -0.7, -0.4, -0.1})
        add(degrees(90.0), height, 1'000);

    QCOMPARE(classes(), (std::vector<std::string_view>{"floor", "other", "other", "other"}));
}

void ClassifyPlanesTest::aFewPointsBelowTheFloorAreNoFloor()
{
    add(degrees(90.0), -0.9, 10'000);
    add(degrees(90.0), -2.4, 100);  // a mirror's floor

    QCOMPARE(classes(), (std::vector<std::string_view>{"floor", "other"}));
}

void ClassifyPlanesTest::slopesAreOther()
{
    add(degrees(30.0), -0.9, 1'000);
    add(degrees(60.0), 1.0, 1'000);

    QCOMPARE(classes(), (std::vector<std::string_view>{"other", "other"}));
}

void ClassifyPlanesTest::nearlyPlumbIsAWallAndNearlyLevelIsLevel()
{
    add(degrees(14.9), 0.0, 1'000);
    add(degrees(15.1), 0.0, 1'000);
    add(degrees(75.1), -1.0, 1'000);
    add(degrees(-75.1), -1.0, 1'000);
    add(degrees(74.9), -1.0, 1'000);

    QCOMPARE(classes(), (std::vector<std::string_view>{"wall", "other", "floor", "floor", "other"}));
}

void ClassifyPlanesTest::aFloorInTwoPartsIsAllFloor()
{
    add(degrees(90.0), -0.90, 10'000);
    add(degrees(90.0), -0.91, 50);

    QCOMPARE(classes(), (std::vector<std::string_view>{"floor", "floor"}));
}

void ClassifyPlanesTest::noPlanesHaveNoClasses()
{
    QVERIFY(classes().empty());
}

PLANEWRIGHT_TEST(ClassifyPlanesTest)
#include "classify_planes_test.moc"
