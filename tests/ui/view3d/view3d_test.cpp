// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/view3d.h"

#include <QPainter>
#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/scene/shown_room.h"

namespace planewright {

/// Whoever sits before the 3D view: pointer and keys.
class View3dTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void theRoomIsSeenInItsColours();
    void aDragRotates();
    void theMiddleButtonShifts();
    void theWheelComesNearer();
    void aClickSelectsThePlaneUnderThePointer();
    void aDragIsNoClick();
    void controlClickAdds();
    void aHandleIsDraggedAndTheCameraStays();
    void aDoubleClickCentres();
    void measuringGivesThePointUnderThePointer();
    void walkModeTakesItsKeys();
    void aNewScanIsFittedUntilSomeoneMovesTheCamera();
    void hoveringNamesThePlane();
    void namedViewsLookWhereTheySay();
    void atRestAllPointsAreSeen();
    void nothingIsWrittenUnderTheCorner_data();
    void nothingIsWrittenUnderTheCorner();
    void picturesOfTheViewHaveNoCorner();

private:
    std::shared_ptr<const ShownMap> corridor_;
    std::unique_ptr<View3d> view_;
};

namespace {

const QPoint kMiddle{400, 300};

}  // namespace

void View3dTest::initTestCase()
{
    corridor_ = shownRoom("corridor");
}

void View3dTest::init()
{
    view_ = std::make_unique<View3d>();
    PresenterSettings settings;
    settings.image = qEnvironmentVariable("QT_QPA_PLATFORM") == QLatin1String("offscreen");
    const auto presented = view_->present(settings);
    QVERIFY2(presented, presented ? "" : presented.error().message.c_str());
    view_->resize(800, 600);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    view_->setMap(corridor_);
}

void View3dTest::cleanup()
{
    view_.reset();
}

void View3dTest::theRoomIsSeenInItsColours()
{
    view_->showNamed(NamedView::Top);
    const QImage picture = view_->grab().toImage();
    const PlaneId ceiling = pick(view_->scene(), rayThrough(view_->camera(), 0.0, 0.0), 1e-3)->plane;
    const QColor colour = toQColor(planeColour(ceiling, PlanePalette::Normal, Theme::Light));

    int seen = 0;
    const QRect middle(kMiddle - QPoint(50, 150), QSize(100, 300));
    for (int y = middle.top(); y < middle.bottom(); ++y) {
        for (int x = middle.left(); x < middle.right(); ++x)
            seen += picture.pixelColor(x, y) == colour ? 1 : 0;
    }

    // From above the ceiling covers the middle of the picture with points and segments of its own colour.
    QVERIFY2(seen > 300, qPrintable(QString::number(seen)));
}

void View3dTest::aDragRotates()
{
    const ViewCamera before = view_->camera();

    QTest::mousePress(view_.get(), Qt::LeftButton, {}, kMiddle);
    QTest::mouseMove(view_.get(), kMiddle + QPoint(60, 0));
    QTest::mouseMove(view_.get(), kMiddle + QPoint(120, 30));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, kMiddle + QPoint(120, 30));

    // 120 of 600 pixels are a fifth of half a turn.
    QVERIFY(std::abs(std::remainder(before.heading - view_->camera().heading - degrees(36.0), 6.283185307)) < 1e-6);
    QVERIFY(std::abs(view_->camera().elevation - before.elevation - degrees(9.0)) < 1e-6);
}

void View3dTest::theMiddleButtonShifts()
{
    const ViewCamera before = view_->camera();

    QTest::mousePress(view_.get(), Qt::MiddleButton, {}, kMiddle);
    QTest::mouseMove(view_.get(), kMiddle + QPoint(60, 0));
    QTest::mouseRelease(view_.get(), Qt::MiddleButton, {}, kMiddle + QPoint(60, 0));

    const Eigen::Vector3d seen = projected(view_->camera(), before.target);
    QVERIFY(std::abs(seen.x() - 0.1) < 1e-6 && std::abs(seen.y()) < 1e-6);
    QCOMPARE(view_->camera().heading, before.heading);
}

void View3dTest::theWheelComesNearer()
{
    const double before = view_->camera().distance;
    QWheelEvent notch(kMiddle, view_->mapToGlobal(kMiddle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);

    QCoreApplication::sendEvent(view_.get(), &notch);

    QVERIFY(std::abs(view_->camera().distance - before / 1.2) < 1e-9);
}

void View3dTest::aClickSelectsThePlaneUnderThePointer()
{
    view_->showNamed(NamedView::Top);
    QSignalSpy clicked(view_.get(), &View3d::clicked);

    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, kMiddle);

    QCOMPARE(clicked.count(), 1);
    const auto picked = clicked.front().front().value<std::optional<Picked>>();
    QVERIFY(picked && picked->plane != kNoPlane);
    // From above the ceiling comes first: a level plane over the scanner.
    const auto& planes = view_->scene().map().planes;
    const auto plane =
        std::find_if(planes.begin(), planes.end(), [&](const ShownPlane& p) { return p.plane->id == picked->plane; });
    QVERIFY(plane != planes.end());
    QVERIFY(std::abs(plane->plane->normal.z()) > 0.99 && picked->place.z() > 0.0);
}

void View3dTest::aDragIsNoClick()
{
    QSignalSpy clicked(view_.get(), &View3d::clicked);

    QTest::mousePress(view_.get(), Qt::LeftButton, {}, kMiddle);
    QTest::mouseMove(view_.get(), kMiddle + QPoint(40, 0));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, kMiddle + QPoint(40, 0));

    QCOMPARE(clicked.count(), 0);
}

void View3dTest::aHandleIsDraggedAndTheCameraStays()
{
    view_->showNamed(NamedView::Top);
    const ViewCamera before = view_->camera();
    PlacedShape shape;
    shape.middle = before.target;
    view_->setPlaced(shape);
    QSignalSpy taken(view_.get(), &View3d::handleTaken);
    QSignalSpy moves(view_.get(), &View3d::handleMoved);
    QSignalSpy clicks(view_.get(), &View3d::clicked);

    QTest::mousePress(view_.get(), Qt::LeftButton, {}, kMiddle);
    QTest::mouseMove(view_.get(), kMiddle + QPoint(30, 0));
    QTest::mouseMove(view_.get(), kMiddle + QPoint(60, 0));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, kMiddle + QPoint(60, 0));

    QCOMPARE(taken.size(), 1);
    QVERIFY(!moves.isEmpty());
    const Pose motion = moves.last().at(0).value<Pose>();
    // 60 of 600 pixels to the right.
    QVERIFY((motion.translation - 0.1 * before.heightAtTarget() * before.right()).norm() < 1e-6);
    QVERIFY(view_->camera() == before);
    QVERIFY(clicks.isEmpty());
    QVERIFY(!view_->handles().held());
}

void View3dTest::controlClickAdds()
{
    QSignalSpy clicked(view_.get(), &View3d::clicked);

    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ControlModifier, kMiddle);

    QCOMPARE(clicked.count(), 1);
    QVERIFY(clicked.front().at(1).toBool());
}

void View3dTest::aDoubleClickCentres()
{
    view_->showNamed(NamedView::Top);
    const auto there = rayThrough(view_->camera(), 0.0, 0.05);
    const auto picked = pick(view_->scene(), there, 1e-3);
    QVERIFY(picked);

    QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, kMiddle + QPoint(0, -30));

    QVERIFY((view_->camera().target - picked->place).norm() < 0.05);
}

void View3dTest::measuringGivesThePointUnderThePointer()
{
    view_->showNamed(NamedView::Top);
    view_->setMeasuring(true);
    QSignalSpy points(view_.get(), &View3d::pointPicked);
    QSignalSpy clicked(view_.get(), &View3d::clicked);

    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, kMiddle);

    QCOMPARE(points.count(), 1);
    QCOMPARE(clicked.count(), 0);
}

void View3dTest::walkModeTakesItsKeys()
{
    const ViewCamera before = view_->camera();
    QTest::keyPress(view_.get(), Qt::Key_W);
    QTest::qWait(100);
    QTest::keyRelease(view_.get(), Qt::Key_W);
    QVERIFY(view_->camera() == before);

    view_->setWalkMode(true);
    QTest::keyPress(view_.get(), Qt::Key_W);
    QTRY_VERIFY(!(view_->camera() == before));
    QTest::keyRelease(view_.get(), Qt::Key_W);

    QCOMPARE(view_->camera().target.z(), before.target.z());
}

void View3dTest::aNewScanIsFittedUntilSomeoneMovesTheCamera()
{
    const ViewCamera fittedToCorridor = view_->camera();
    view_->setMap(shownRoom("office"));
    QVERIFY(!(view_->camera() == fittedToCorridor));

    QTest::mousePress(view_.get(), Qt::LeftButton, {}, kMiddle);
    QTest::mouseMove(view_.get(), kMiddle + QPoint(50, 0));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, kMiddle + QPoint(50, 0));
    const ViewCamera moved = view_->camera();
    view_->setMap(corridor_);

    QVERIFY(view_->camera() == moved);
}

void View3dTest::hoveringNamesThePlane()
{
    view_->showNamed(NamedView::Top);
    QSignalSpy hovered(view_.get(), &View3d::hovered);

    QTest::mouseMove(view_.get(), kMiddle + QPoint(1, 1));

    QTRY_COMPARE(hovered.count(), 1);
    QVERIFY(hovered.front().front().value<PlaneId>() != kNoPlane);
}

void View3dTest::namedViewsLookWhereTheySay()
{
    view_->showNamed(NamedView::Side);
    QVERIFY(view_->camera().forward().isApprox(-Eigen::Vector3d::UnitX(), 1e-9));

    view_->showNamed(NamedView::Front);
    QVERIFY(view_->camera().forward().isApprox(Eigen::Vector3d::UnitY(), 1e-9));

    view_->showNamed(NamedView::Sensor);
    QVERIFY(view_->camera().eye().norm() < 0.5);
}

/// Whether they are drawn at once, or part by part because they are many for what is drawn while the view moves.
void View3dTest::atRestAllPointsAreSeen()
{
    view_->setPointBudget(10'000);
    LayerSettings layers;
    for (LayerStyle& style : layers.styles)
        style.visible = false;
    layers[Layer::Points].visible = true;
    layers.labels = false;
    view_->setLayers(layers);
    view_->showNamed(NamedView::Iso);
    const auto inked = [](const QImage& picture) {
        const QRgb paper = picture.pixel(2, picture.height() / 2);
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QRgb pixel = picture.pixel(x, y);
                count += std::abs(qRed(pixel) - qRed(paper)) + std::abs(qBlue(pixel) - qBlue(paper)) > 60 ? 1 : 0;
            }
        }
        return count;
    };
    const QImage whole = view_->presenter()->picture(view_->size(), 1.0);

    // What is written over the view is not in it.
    QTRY_VERIFY(std::abs(inked(view_->presenter()->widget().grab().toImage()) - inked(whole)) < inked(whole) / 100);
}

/// Buttons of 230 × 28 pixels stand 10 from the corner of the view; its smallest is 310 × 270.
void View3dTest::nothingIsWrittenUnderTheCorner_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<int>("chipTop");
    QTest::newRow("room for all") << QSize(800, 600) << 12;
    QTest::newRow("as small as it gets") << QSize(310, 270) << 38 + 6;
    QTest::newRow("hardly any height") << QSize(310, 90) << 38 + 6;
}

void View3dTest::nothingIsWrittenUnderTheCorner()
{
    QFETCH(QSize, size);
    QFETCH(int, chipTop);
    LayerSettings layers;
    layers.labels = false;
    view_->setLayers(layers);
    QVERIFY(view_->scene().legend(16).size() > 5);
    OverlayContent content;
    content.stateText = QStringLiteral("✔ Complete 137/137, 20 planes");
    content.stateColour = Qt::darkGreen;
    content.corner = QSize(240, 38);
    QImage picture(size, QImage::Format_RGB32);
    picture.fill(Qt::magenta);

    QPainter painter(&picture);
    paintOverlay(painter, size, view_->scene(), content);
    painter.end();

    const auto written = [&](const QRect& rect) {
        int pixels = 0;
        for (int y = rect.top(); y <= rect.bottom(); ++y) {
            for (int x = rect.left(); x <= rect.right(); ++x)
                pixels += picture.pixelColor(x, y) == QColor(Qt::magenta) ? 0 : 1;
        }
        return pixels;
    };
    QCOMPARE(written({size.width() - 240, 0, 240, 38}), 0);
    // The chip begins where it is told to, and a legend that fits stands at the bottom right.
    QCOMPARE(written({20, 0, 40, chipTop}), 0);
    QVERIFY(written({20, chipTop, 40, 2}) > 70);
    // Nothing but the chip's own words stands on it, which end before its right end.
    const int right = 11 + QFontMetrics(QFont()).horizontalAdvance(content.stateText) + 24;
    for (int y = chipTop + 4; y < chipTop + 16; ++y)
        QCOMPARE(picture.pixelColor(right - 6, y), content.stateColour);
    QCOMPARE(written({size.width() - 40, size.height() - 30, 20, 10}) > 0, size.height() > 100);
}

void View3dTest::picturesOfTheViewHaveNoCorner()
{
    OverlayContent content;
    content.stateText = QStringLiteral("a chip that is much too wide to stand beside the buttons of this small view");
    content.stateColour = Qt::darkGreen;
    view_->setOverlay(content);
    view_->keepCornerFree({240, 38});
    QCOMPARE(view_->overlay().corner, QSize(240, 38));
    view_->setOverlay(content);
    QCOMPARE(view_->overlay().corner, QSize(240, 38));

    const QImage picture = view_->picture({400, 300}, 1.0);

    QCOMPARE(picture.pixelColor(20, 16), QColor(Qt::darkGreen));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::View3dTest)
#include "view3d_test.moc"
