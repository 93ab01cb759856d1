// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/place_handles.h"

#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

/// What is placed moves so that the handle stays under the pointer.
class PlaceHandlesTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void aHandleIsTakenWhereItIsSeen();
    void fromAboveTheMiddleIsTakenAndNotTheArrowOverIt();
    void theMiddleShiftsInTheLevel();
    void theKnobTurnsAboutTheMiddle();
    void theArrowRaises();
    void aShapeGoesWithItsMotion();
    void whatTheRayLooksAlongMovesNothing();

private:
    bool take(PlaceHandle handle);
    Ray through(const Eigen::Vector3d& place) const { return through(place, camera_); }
    static Ray through(const Eigen::Vector3d& place, const ViewCamera& camera)
    {
        const Eigen::Vector3d seen = projected(camera, place);
        return rayThrough(camera, seen.x(), seen.y());
    }

    ViewCamera camera_;
    PlacedShape shape_;
    PlaceHandles handles_;
};

void PlaceHandlesTest::init()
{
    camera_ = {{1.0, 2.0, 3.0}, 30.0, degrees(20.0), degrees(35.0)};
    shape_ = {{1.0, 2.0, 3.0}, 4.0, degrees(30.0), {{{0.0, 0.0, 3.0}, {5.0, 0.0, 3.0}, {5.0, 6.0, 3.0}}}};
    handles_ = {};
    handles_.setShape(shape_);
}

bool PlaceHandlesTest::take(PlaceHandle handle)
{
    return handles_.take(camera_, projected(camera_, placeOf(handle, shape_)).head<2>(), 0.01) &&
           handles_.held() == handle;
}

void PlaceHandlesTest::aHandleIsTakenWhereItIsSeen()
{
    for (const PlaceHandle handle : kPlaceHandles)
        QVERIFY(take(handle));
    const Eigen::Vector2d beside =
        projected(camera_, placeOf(PlaceHandle::Turn, shape_)).head<2>() + Eigen::Vector2d{0.02, 0.0};
    QVERIFY(!handles_.take(camera_, beside, 0.01));
    QVERIFY(!handles_.held());
    handles_.setShape(std::nullopt);
    QVERIFY(!take(PlaceHandle::Shift));
}

void PlaceHandlesTest::fromAboveTheMiddleIsTakenAndNotTheArrowOverIt()
{
    camera_.elevation = degrees(90.0);
    const Eigen::Vector2d arrow = projected(camera_, placeOf(PlaceHandle::Height, shape_)).head<2>();
    QVERIFY((arrow - projected(camera_, shape_.middle).head<2>()).norm() < 0.01);

    QVERIFY(handles_.take(camera_, arrow, 0.01));

    QCOMPARE(handles_.held().value(), PlaceHandle::Shift);
}

void PlaceHandlesTest::theMiddleShiftsInTheLevel()
{
    QVERIFY(take(PlaceHandle::Shift));
    const auto motion = handles_.motionTo(through({3.5, -1.0, 3.0}));
    QVERIFY(motion.has_value());
    QVERIFY((motion->translation - Eigen::Vector3d{2.5, -3.0, 0.0}).norm() < 1e-9);
    QVERIFY(motion->rotation.isApprox(Eigen::Quaterniond::Identity()));
}

void PlaceHandlesTest::theKnobTurnsAboutTheMiddle()
{
    QVERIFY(take(PlaceHandle::Turn));
    // Nearer than the ring, at a heading of 75°: 45° on.
    const auto motion =
        handles_.motionTo(through({1.0 + 2.0 * std::cos(degrees(75.0)), 2.0 + 2.0 * std::sin(degrees(75.0)), 3.0}));
    QVERIFY(motion.has_value());
    QVERIFY((*motion * shape_.middle - shape_.middle).norm() < 1e-9);
    const Eigen::AngleAxisd turn(motion->rotation);
    QVERIFY(std::abs(turn.angle() * turn.axis().z() - degrees(45.0)) < 1e-9);
}

void PlaceHandlesTest::theArrowRaises()
{
    QVERIFY(take(PlaceHandle::Height));
    const auto motion =
        handles_.motionTo(through(placeOf(PlaceHandle::Height, shape_) + Eigen::Vector3d{0.0, 0.0, 1.75}));
    QVERIFY(motion.has_value());
    QVERIFY((motion->translation - Eigen::Vector3d{0.0, 0.0, 1.75}).norm() < 1e-9);
}

void PlaceHandlesTest::aShapeGoesWithItsMotion()
{
    const Pose motion{Eigen::Quaterniond(Eigen::AngleAxisd(degrees(90.0), Eigen::Vector3d::UnitZ())), {10.0, 0.0, 1.0}};
    const PlacedShape there = moved(shape_, motion);
    QVERIFY((there.middle - Eigen::Vector3d{8.0, 1.0, 4.0}).norm() < 1e-9);
    QVERIFY(std::abs(there.heading - degrees(120.0)) < 1e-9);
    QVERIFY((there.rings[0][1] - Eigen::Vector3d{10.0, 5.0, 4.0}).norm() < 1e-9);
    QCOMPARE(there.radius, 4.0);
}

void PlaceHandlesTest::whatTheRayLooksAlongMovesNothing()
{
    ViewCamera above = camera_;
    above.elevation = degrees(90.0);
    above.parallel = true;
    QVERIFY(handles_.take(above, projected(above, placeOf(PlaceHandle::Turn, shape_)).head<2>(), 0.01));
    QVERIFY(handles_.motionTo(through({2.0, 2.0, 3.0}, above)).has_value());
    QVERIFY(take(PlaceHandle::Height));
    QVERIFY(!handles_.motionTo(through({2.0, 2.0, 3.0}, above)).has_value());
    QVERIFY(take(PlaceHandle::Shift));
    QVERIFY(!handles_.motionTo({{-20.0, 2.0, 3.5}, Eigen::Vector3d::UnitX()}).has_value());
    handles_.letGo();
    QVERIFY(!handles_.motionTo(through({3.5, -1.0, 3.0})).has_value());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlaceHandlesTest)
#include "place_handles_test.moc"
