// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/map_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/made_building.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/panels/filtered_table.h"
#include "ui/panels/floor_plan_view.h"
#include "ui/theme/theme.h"

namespace planewright {

class MapPanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void cleanupTestCase();
    void withoutAMapThereIsNothingToDo();
    void aStopCanBeTakenOutMovedAndTaughtItsOdometry();
    void whatIsTakenOutCanOnlyComeBack();
    void aMatchIsAcceptedRejectedOrForced();
    void aPlaneOfOneStopAloneHasNothingToAcceptOrReject();
    void theSliderAsksForTheMapAsItWas();
    void whileAMapIsMadeItCanBeCancelled();
    void thePlanIsOfAFloorAndAHeight();
    void itLooksAsItDid_data();
    void itLooksAsItDid();

private:
    template <class Widget>
    Widget* find(const char* name)
    {
        return panel_->findChild<Widget*>(QLatin1String(name));
    }
    void click(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
    void show();

    StopsModel stops_;
    MatchesModel matches_;
    std::unique_ptr<MapPanel> panel_;
    QFont before_;
};

void MapPanelTest::initTestCase()
{
    before_ = QApplication::font();
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    QApplication::setFont(font);
}

void MapPanelTest::init()
{
    stops_.setBuilding(nullptr);
    matches_.setBuilding(nullptr);
    panel_ = std::make_unique<MapPanel>(stops_, matches_);
}

void MapPanelTest::cleanup()
{
    panel_.reset();
}

void MapPanelTest::cleanupTestCase()
{
    applyTheme(Theme::Light);
    QApplication::setFont(before_);
}

void MapPanelTest::show()
{
    const auto building = madeBuilding()->building;
    stops_.setBuilding(building);
    matches_.setBuilding(building);
    panel_->setBuilding(building);
}

void MapPanelTest::withoutAMapThereIsNothingToDo()
{
    QCOMPARE(find<QLabel>("mapSummary")->text(), QStringLiteral("No map yet."));
    for (const char* name :
         {"stopOmit", "stopUp", "stopDown", "stopOdometry", "matchAccept", "matchReject", "matchForce"})
        QVERIFY2(!find<QPushButton>(name)->isEnabled(), name);
    QVERIFY(!find<QSlider>("mapUntil")->isEnabled());

    show();

    QCOMPARE(find<QLabel>("mapSummary")->text(), QStringLiteral("3 stops placed, 4 planes of the map; ⚠ 1 to look at"));
}

void MapPanelTest::aStopCanBeTakenOutMovedAndTaughtItsOdometry()
{
    show();
    QSignalSpy omits(panel_.get(), &MapPanel::omitRequested);
    QSignalSpy moves(panel_.get(), &MapPanel::moveRequested);
    QSignalSpy odometry(panel_.get(), &MapPanel::odometryRequested);

    panel_->stopsTable()->choose({1});
    click("stopOmit");
    click("stopUp");
    click("stopDown");
    click("stopOdometry");

    QCOMPARE(omits, (QList<QList<QVariant>>{{2, true}}));
    QCOMPARE(moves, (QList<QList<QVariant>>{{2, -1}, {2, 1}}));
    QCOMPARE(odometry, (QList<QList<QVariant>>{{2}}));
    QVERIFY(find<QLabel>("stopWarning")->text().contains(QStringLiteral("odometry alone tells which")));
    panel_->stopsTable()->choose({0});
    QVERIFY(!find<QPushButton>("stopUp")->isEnabled());
    panel_->stopsTable()->choose({2});
    QVERIFY(!find<QPushButton>("stopDown")->isEnabled());
}

void MapPanelTest::whatIsTakenOutCanOnlyComeBack()
{
    show();
    QSignalSpy omits(panel_.get(), &MapPanel::omitRequested);

    panel_->stopsTable()->choose({3});
    QCOMPARE(find<QPushButton>("stopOmit")->text(), QStringLiteral("Take in again"));
    QVERIFY(!find<QPushButton>("stopOdometry")->isEnabled());
    click("stopOmit");

    QCOMPARE(omits, (QList<QList<QVariant>>{{3, false}}));
}

void MapPanelTest::aMatchIsAcceptedRejectedOrForced()
{
    show();
    QSignalSpy accepts(panel_.get(), &MapPanel::acceptRequested);
    QSignalSpy rejects(panel_.get(), &MapPanel::rejectRequested);
    QSignalSpy forces(panel_.get(), &MapPanel::forceRequested);
    find<QTabWidget>("mapTabs")->setCurrentIndex(1);

    panel_->matchesTable()->choose({4});
    // The first that an open one may be is proposed.
    QCOMPARE(find<QComboBox>("matchTarget")->currentText(), QStringLiteral("P01"));
    click("matchAccept");
    click("matchReject");
    find<QComboBox>("matchTarget")->setCurrentText(QStringLiteral("P02"));
    click("matchForce");

    QCOMPARE(accepts, (QList<QList<QVariant>>{{4}}));
    QCOMPARE(rejects, (QList<QList<QVariant>>{{4}}));
    QCOMPARE(forces.size(), 1);
    QCOMPARE(forces[0][1].toInt(), 2);
}

void MapPanelTest::aPlaneOfOneStopAloneHasNothingToAcceptOrReject()
{
    show();

    panel_->matchesTable()->choose({3});
    QVERIFY(!find<QPushButton>("matchAccept")->isEnabled());
    QVERIFY(!find<QPushButton>("matchReject")->isEnabled());
    QVERIFY(find<QPushButton>("matchForce")->isEnabled());
    panel_->matchesTable()->choose({0});
    QVERIFY(find<QPushButton>("matchReject")->isEnabled());
}

void MapPanelTest::theSliderAsksForTheMapAsItWas()
{
    show();
    QSignalSpy asked(panel_.get(), &MapPanel::untilChosen);
    auto* slider = find<QSlider>("mapUntil");
    QCOMPARE(slider->maximum(), 3);
    QCOMPARE(slider->value(), 3);
    QCOMPARE(find<QLabel>("mapUntilText")->text(), QStringLiteral("After stop 2 of 2"));

    slider->setValue(2);

    QCOMPARE(asked, (QList<QList<QVariant>>{{2}}));
}

void MapPanelTest::whileAMapIsMadeItCanBeCancelled()
{
    QSignalSpy cancels(panel_.get(), &MapPanel::cancelRequested);
    QSignalSpy closes(panel_.get(), &MapPanel::closeRequested);

    panel_->setProgress(QStringLiteral("extracting stop"), 3, 12);
    QVERIFY(!find<QProgressBar>("mapProgress")->isHidden());
    QCOMPARE(find<QProgressBar>("mapProgress")->value(), 3);
    click("mapClose");
    panel_->setIdle();
    QVERIFY(find<QProgressBar>("mapProgress")->isHidden());
    click("mapClose");

    QCOMPARE(cancels.size(), 1);
    QCOMPARE(closes.size(), 1);
}

void MapPanelTest::thePlanIsOfAFloorAndAHeight()
{
    show();
    QSignalSpy plans(panel_.get(), &MapPanel::planRequested);

    find<QComboBox>("planFloor")->setCurrentText(QStringLiteral("1"));
    find<QDoubleSpinBox>("planHeight")->setValue(1.5);

    QCOMPARE(plans.size(), 2);
    QCOMPARE(panel_->planFloor(), 1);
    QCOMPARE(panel_->planHeight(), 1.5);
    FloorPlanSketch sketch;
    sketch.lines.push_back({true, {0.0, 0.0}, {4.0, 0.0}});
    sketch.stops.push_back({{1.0, 1.0}, 3});
    panel_->setPlan(sketch);
    QSignalSpy floors(panel_.get(), &MapPanel::floorRequested);
    QTest::mouseClick(find<QPushButton>("placeFloor"), Qt::LeftButton);
    QCOMPARE(floors.size(), 1);
    QCOMPARE(floors[0][0].toInt(), 1);
    QCOMPARE(find<FloorPlanView>("floorPlanView")->accessibleDescription(),
             QStringLiteral("1 line, 1 stop from above"));
}

void MapPanelTest::itLooksAsItDid_data()
{
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("tab");
    for (const bool dark : {false, true}) {
        const char* theme = dark ? "dark" : "light";
        QTest::addRow("map-stops-%s", theme) << dark << 0;
        QTest::addRow("map-matches-%s", theme) << dark << 1;
        QTest::addRow("map-plan-%s", theme) << dark << 2;
    }
}

void MapPanelTest::itLooksAsItDid()
{
    QFETCH(bool, dark);
    QFETCH(int, tab);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    show();
    panel_->stopsTable()->choose({1});
    panel_->matchesTable()->choose({4});
    FloorPlanSketch sketch;
    sketch.lines = {{true, {-2.0, -3.0}, {-2.0, 3.0}},
                    {true, {-2.0, 3.0}, {4.0, 3.0}},
                    {true, {4.0, 3.0}, {4.0, -3.0}},
                    {false, {1.0, 1.0}, {1.8, 1.0}}};
    sketch.stops = {{{0.0, 0.0}, 0}, {{0.5, 1.5}, 1}};
    sketch.lowest = {-2.0, -3.0};
    sketch.highest = {4.0, 3.0};
    panel_->setPlan(sketch);
    find<QTabWidget>("mapTabs")->setCurrentIndex(tab);
    panel_->resize(520, 560);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));

    const QString difference =
        differenceFromReference(panel_->grab().toImage(), QString::fromLatin1(QTest::currentDataTag()));

    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::MapPanelTest)
#include "map_panel_test.moc"
