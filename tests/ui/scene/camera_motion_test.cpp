// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/scene/camera_motion.h"

#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/test_program.h"

namespace planewright {

class CameraMotionTest : public QObject {
    Q_OBJECT

private slots:
    void headingZeroLooksForward();
    void fromAboveForwardIsUpInThePicture();
    void aRayThroughAPlaceMeetsWhatIsProjectedThere_data();
    void aRayThroughAPlaceMeetsWhatIsProjectedThere();
    void fittingPutsEveryCornerIntoThePicture_data();
    void fittingPutsEveryCornerIntoThePicture();
    void turningAboutAPointKeepsItInPlace();
    void zoomingKeepsWhatIsUnderThePointer_data();
    void zoomingKeepsWhatIsUnderThePointer();
    void panningMovesTheSceneWithThePointer();
    void theCameraNeverTurnsOverTheTop();
    void walkingStaysLevel();
};

namespace {

constexpr double kClose = 1e-9;

ViewCamera lookingDown()
{
    ViewCamera camera;
    camera.target = {1.0, 2.0, 0.5};
    camera.distance = 7.0;
    camera.heading = degrees(30.0);
    camera.elevation = degrees(25.0);
    return camera;
}

void addProjections()
{
    QTest::addColumn<bool>("parallel");
    QTest::newRow("perspective") << false;
    QTest::newRow("parallel") << true;
}

}  // namespace

void CameraMotionTest::headingZeroLooksForward()
{
    ViewCamera camera;
    camera.elevation = 0.0;

    QVERIFY(camera.forward().isApprox(Eigen::Vector3d::UnitY(), kClose));
    QVERIFY(camera.right().isApprox(Eigen::Vector3d::UnitX(), kClose));
    QVERIFY(camera.up().isApprox(Eigen::Vector3d::UnitZ(), kClose));
}

void CameraMotionTest::fromAboveForwardIsUpInThePicture()
{
    const ViewCamera camera = namedView(NamedView::Top, {}, 1.5, {});

    QVERIFY(camera.forward().isApprox(-Eigen::Vector3d::UnitZ(), kClose));
    QVERIFY(camera.up().isApprox(Eigen::Vector3d::UnitY(), kClose));
}

void CameraMotionTest::aRayThroughAPlaceMeetsWhatIsProjectedThere_data()
{
    addProjections();
}

void CameraMotionTest::aRayThroughAPlaceMeetsWhatIsProjectedThere()
{
    QFETCH(bool, parallel);
    ViewCamera camera = lookingDown();
    camera.parallel = parallel;
    const Eigen::Vector3d point{0.3, 3.1, -0.4};

    const Eigen::Vector3d seen = projected(camera, point);
    const Ray ray = rayThrough(camera, seen.x(), seen.y());

    const auto passing = pass(ray, point);
    QVERIFY(passing);
    QVERIFY(passing->aside < kClose);
}

void CameraMotionTest::fittingPutsEveryCornerIntoThePicture_data()
{
    addProjections();
}

void CameraMotionTest::fittingPutsEveryCornerIntoThePicture()
{
    QFETCH(bool, parallel);
    ViewCamera camera = lookingDown();
    camera.parallel = parallel;
    const Eigen::AlignedBox3d box{Eigen::Vector3d{-3.0, 0.0, -1.0}, Eigen::Vector3d{2.0, 25.0, 2.0}};
    constexpr double kAspect = 1.6;

    camera = fitted(camera, box, kAspect);

    double most = 0.0;
    for (int i = 0; i < 8; ++i) {
        const auto seen = projected(camera, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
        QVERIFY(seen.z() > 0.0 || parallel);
        most = std::max({most, 2.0 * std::abs(seen.x()) / kAspect, 2.0 * std::abs(seen.y())});
    }
    QVERIFY2(most <= 1.0 && most > 0.6, qPrintable(QString::number(most)));
}

void CameraMotionTest::turningAboutAPointKeepsItInPlace()
{
    const ViewCamera camera = lookingDown();
    const Eigen::Vector3d pivot{2.0, 1.0, 0.0};

    const ViewCamera turned = rotatedAbout(camera, pivot, 0.2, -0.1);

    QVERIFY(projected(turned, pivot).isApprox(projected(camera, pivot), 1e-6));
    QVERIFY(!turned.forward().isApprox(camera.forward(), 1e-3));
}

void CameraMotionTest::zoomingKeepsWhatIsUnderThePointer_data()
{
    addProjections();
}

void CameraMotionTest::zoomingKeepsWhatIsUnderThePointer()
{
    QFETCH(bool, parallel);
    ViewCamera camera = lookingDown();
    camera.parallel = parallel;
    const Eigen::Vector3d under = camera.target + camera.heightAtTarget() * (0.3 * camera.right() + 0.2 * camera.up());

    const ViewCamera nearer = zoomed(camera, 0.5, 0.3, 0.2);

    QCOMPARE(nearer.distance, 3.5);
    const Eigen::Vector3d seen = projected(nearer, under);
    QVERIFY(std::abs(seen.x() - 0.3) < kClose && std::abs(seen.y() - 0.2) < kClose);
}

void CameraMotionTest::panningMovesTheSceneWithThePointer()
{
    const ViewCamera camera = lookingDown();

    const ViewCamera moved = panned(camera, 0.1, 0.25);

    const Eigen::Vector3d seen = projected(moved, camera.target);
    QVERIFY(std::abs(seen.x() - 0.1) < kClose && std::abs(seen.y() + 0.25) < kClose);
}

void CameraMotionTest::theCameraNeverTurnsOverTheTop()
{
    const ViewCamera turned = rotated(lookingDown(), 0.0, 10.0);

    QCOMPARE(turned.elevation, std::numbers::pi / 2.0);
}

void CameraMotionTest::walkingStaysLevel()
{
    const ViewCamera camera = lookingDown();

    const ViewCamera ahead = walked(camera, 0.0, 2.0, 0.0);

    // 30° to the left of forward, 2 m: 1 m to the left and √3 m forward.
    QVERIFY((ahead.target - camera.target).isApprox(Eigen::Vector3d{-1.0, std::sqrt(3.0), 0.0}, kClose));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::CameraMotionTest)
#include "camera_motion_test.moc"
