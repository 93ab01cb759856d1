// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fstream>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QSlider>
#include <QTabWidget>
#include <QtTest>

#include "app/window/place_dialog.h"
#include "app/window/screenshot.h"
#include "app/window/waiting.h"
#include "core/formats/trajectory_tum.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/panels/filtered_table.h"

namespace planewright {

/// The map of a file of several scans in the window.
class MapWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void aFileOfSeveralScansOffersItsMap();
    void aFileOfOneScanHasNoMap();
    void theMapIsThatOfTheCommandLine();
    void aRejectedMatchIsUndoneWithAllOtherEdits();
    void aStopIsTakenOutAndComesBack();
    void stopsAreReordered();
    void odometryIsTypedIn();
    void aFloorSnapsToWallsAndStairsBelow();
    void aFloorIsPlacedByItsHandles();
    void theSliderShowsTheMapAsItWas();
    void aClickChoosesAPlaneAndItsMatch();
    void colouringsHaveLegends();
    void leavingTheMapBringsTheScanBack();
    void cancellingGoesBackToTheScan();
    void itLooksAsItDid_data();
    void itLooksAsItDid();

private:
    bool runCli(const QStringList& arguments);
    QByteArray bytesOf(const QString& name) const;
    bool settle() { return waitForRest(*parts_, kPatience).has_value(); }
    void openBuilding();
    void showMap();
    void openFloors(const QString& name);
    const std::shared_ptr<const BuiltMap>& map() { return shown_->controllers->map.map(); }
    const ShownBuilding& building() { return *map()->shown->building; }
    MapPanel& panel() { return *parts_->window->findChild<MapPanel*>(QStringLiteral("mapPanel")); }
    template <class Widget>
    Widget* find(const char* name)
    {
        return panel().findChild<Widget*>(QLatin1String(name));
    }
    static std::vector<StampedPose> posesIn(const QString& file)
    {
        std::ifstream in(file.toStdString());
        return readTrajectoryTum(in, file.toStdString()).value_or(std::vector<StampedPose>{});
    }
    /// The row of a match with a plane that a stop before had seen, of the last stop.
    int matchedRow();

    QTemporaryDir folder_;
    QString file_;
    std::unique_ptr<ShownWindow> shown_;
    WindowParts* parts_ = nullptr;
};

bool MapWindowTest::runCli(const QStringList& arguments)
{
    QProcess cli;
    cli.setWorkingDirectory(folder_.path());
    cli.start(QStringLiteral(PLANEWRIGHT_CLI), arguments);
    const bool done = cli.waitForFinished(120'000) && cli.exitCode() == 0;
    if (!done)
        qWarning("%s", cli.readAllStandardError().constData());
    return done;
}

QByteArray MapWindowTest::bytesOf(const QString& name) const
{
    QFile file(folder_.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void MapWindowTest::initTestCase()
{
    useFixedLook();
    QVERIFY(runCli({"simulate", "building", "--floors", "1", "--stops", "20", "--seed", "3", "-o", "floor.pwscan"}));
    QVERIFY(runCli({"simulate", "building", "--floors", "2", "--stops", "32", "--seed", "4", "-o", "two.pwscan"}));
    // So finely that steps are seen from both floors.
    QVERIFY(runCli({"simulate", "building", "--floors", "2", "--stops", "4", "--seed", "5", "--tilt", "10:170:0.4",
                    "-o", "stairs.pwscan", "--truth-poses", "truth.txt"}));
    QVERIFY(runCli({"simulate", "corridor", "-o", "one.pwscan", "--slices", "30"}));
}

void MapWindowTest::init()
{
    file_ = folder_.filePath(QStringLiteral("work.pwscan"));
    QFile::remove(file_);
    QVERIFY(QFile::copy(folder_.filePath(QStringLiteral("floor.pwscan")), file_));
    auto shown = ShownWindow::open(folder_.filePath(QStringLiteral("window.ini")));
    QVERIFY2(shown, shown ? "" : shown.error().message.c_str());
    shown_ = std::move(*shown);
    parts_ = &shown_->parts;
}

void MapWindowTest::cleanup()
{
    shown_.reset();
}

void MapWindowTest::openBuilding()
{
    shown_->controllers->scan.open(file_);
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    QVERIFY(settle());
}

void MapWindowTest::showMap()
{
    openBuilding();
    shown_->action("actMapMode")->trigger();
    QVERIFY(settle());
    QVERIFY(map() != nullptr);
}

int MapWindowTest::matchedRow()
{
    for (int row = static_cast<int>(building().matches.size()) - 1; row >= 0; --row) {
        if (building().matches[static_cast<std::size_t>(row)].state == MatchState::Matched)
            return row;
    }
    return -1;
}

/// The map of two floors.
void MapWindowTest::openFloors(const QString& name)
{
    file_ = folder_.filePath(QStringLiteral("floors.pwscan"));
    QFile::remove(file_);
    QVERIFY(QFile::copy(folder_.filePath(name), file_));
    showMap();
    QCOMPARE(building().floors.size(), std::size_t(2));
}

void MapWindowTest::aFileOfSeveralScansOffersItsMap()
{
    QVERIFY(!shown_->action("actMapMode")->isEnabled());

    openBuilding();

    QVERIFY(shown_->action("actMapMode")->isEnabled());
    QVERIFY(parts_->window->banner().text().contains(QStringLiteral("several scans")));
    QVERIFY(!shown_->action("actExportMapPlanes")->isEnabled());
}

void MapWindowTest::aFileOfOneScanHasNoMap()
{
    shown_->controllers->scan.open(folder_.filePath(QStringLiteral("one.pwscan")));
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    QVERIFY(settle());

    QVERIFY(!shown_->action("actMapMode")->isEnabled());
    QVERIFY(!parts_->window->banner().isVisible());
}

void MapWindowTest::theMapIsThatOfTheCommandLine()
{
    showMap();
    const QString planes = folder_.filePath(QStringLiteral("window.json"));
    const QString poses = folder_.filePath(QStringLiteral("window.txt"));
    const QString plan = folder_.filePath(QStringLiteral("window.svg"));

    for (const auto& [kind, file] : {std::pair{MapExport::MapPlanes, planes}, std::pair{MapExport::MapPoses, poses},
                                     std::pair{MapExport::MapPlan, plan}}) {
        const auto write = exportOf(map(), kind, file, 0, 1.0);
        QVERIFY(write);
        QVERIFY((*write)());
    }
    QVERIFY(runCli({"map", "work.pwscan", "--planes", "cli.json", "--poses", "cli.txt", "--floor-plan", "cli.svg",
                    "--overwrite"}));

    QCOMPARE(bytesOf(QStringLiteral("window.json")), bytesOf(QStringLiteral("cli.json")));
    QCOMPARE(bytesOf(QStringLiteral("window.txt")), bytesOf(QStringLiteral("cli.txt")));
    QCOMPARE(bytesOf(QStringLiteral("window.svg")), bytesOf(QStringLiteral("cli.svg")));
    QVERIFY(bytesOf(QStringLiteral("cli.json")).size() > 1000);
}

void MapWindowTest::aRejectedMatchIsUndoneWithAllOtherEdits()
{
    showMap();
    const std::size_t before = building().planes.size();
    const int row = matchedRow();
    QVERIFY(row >= 0);
    const StopPlane own = building().matches[static_cast<std::size_t>(row)].own;
    find<QTabWidget>("mapTabs")->setCurrentIndex(1);
    panel().matchesTable()->choose({row});

    QTest::mouseClick(find<QPushButton>("matchReject"), Qt::LeftButton);
    QVERIFY(settle());

    const ShownMatch& rejected = building().matches[static_cast<std::size_t>(row)];
    QCOMPARE(rejected.own.plane, own.plane);
    QVERIFY(rejected.state == MatchState::New && rejected.isByHand);
    QCOMPARE(building().planes.size(), before + 1);
    QVERIFY(runCli({"map", "work.pwscan", "--planes", "edited.csv", "--overwrite"}));
    QCOMPARE(static_cast<std::size_t>(bytesOf(QStringLiteral("edited.csv")).count('\n')), before + 1 + 2);

    shown_->action("actUndo")->trigger();
    QVERIFY(settle());
    QCOMPARE(building().planes.size(), before);
    shown_->action("actRedo")->trigger();
    QVERIFY(settle());
    QCOMPARE(building().planes.size(), before + 1);
}

void MapWindowTest::aStopIsTakenOutAndComesBack()
{
    showMap();
    panel().stopsTable()->choose({4});

    QTest::mouseClick(find<QPushButton>("stopOmit"), Qt::LeftButton);
    QVERIFY(settle());

    QCOMPARE(building().allStops, 19);
    QCOMPARE(building().stops.size(), std::size_t(20));
    QVERIFY(building().stops.back().isOmitted());
    QCOMPARE(building().stops.back().scan, 5);
    panel().stopsTable()->choose({19});
    QTest::mouseClick(find<QPushButton>("stopOmit"), Qt::LeftButton);
    QVERIFY(settle());
    QCOMPARE(building().allStops, 20);
}

void MapWindowTest::stopsAreReordered()
{
    showMap();
    panel().stopsTable()->choose({2});

    QTest::mouseClick(find<QPushButton>("stopUp"), Qt::LeftButton);
    QVERIFY(settle());

    QCOMPARE(building().stops[1].scan, 3);
    QCOMPARE(building().stops[2].scan, 2);
    panel().stopsTable()->choose({18});
    QTest::mouseClick(find<QPushButton>("stopDown"), Qt::LeftButton);
    QVERIFY(settle());
    QCOMPARE(building().stops[19].scan, 19);
}

void MapWindowTest::odometryIsTypedIn()
{
    showMap();
    panel().stopsTable()->choose({1});

    QTest::mouseClick(find<QPushButton>("stopOdometry"), Qt::LeftButton);
    auto* dialog = parts_->window->findChild<PlaceDialog*>(QStringLiteral("odometryDialog"));
    QVERIFY(dialog != nullptr);
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("odometryX"))->setValue(1.25);
    dialog->accept();
    QVERIFY(settle());

    QCOMPARE(building().stops[1].told->translation.x(), 1.25);
    QCOMPARE(parts_->mapEdits.inForce().size(), std::size_t(1));
}

void MapWindowTest::aFloorSnapsToWallsAndStairsBelow()
{
    openFloors(QStringLiteral("stairs.pwscan"));
    const MappedFloor before = map()->floors[1];
    find<QComboBox>("planFloor")->setCurrentText(QStringLiteral("1"));

    QTest::mouseClick(find<QPushButton>("placeFloor"), Qt::LeftButton);
    auto* dialog = parts_->window->findChild<PlaceDialog*>(QStringLiteral("floorDialog"));
    QVERIFY(dialog != nullptr);
    QVERIFY(!dialog->place().has_value());
    const auto snap = [dialog] {
        QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("floorFit")), Qt::LeftButton);
        return dialog->findChild<QLabel*>(QStringLiteral("floorFitted"))->text();
    };
    QString said = snap();
    QVERIFY2(said.contains(QStringLiteral("over walls of floor 0")), qPrintable(said));
    QVERIFY2(said.contains(QStringLiteral("Its height stays")), qPrintable(said));
    // Wheels tell no height: the floor is raised to about a storey, which is 3.2 m.
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("floorZ"))->setValue(2.5);
    said = snap();
    QVERIFY2(said.contains(QStringLiteral("of stairs")), qPrintable(said));
    const Pose place = dialog->place().value();
    dialog->accept();
    QVERIFY(settle());

    const MappedFloor& after = map()->floors[1];
    const Pose stop = after.frame * after.builder.map().stops.front().pose;
    QVERIFY((stop.translation - place.translation).norm() < 1e-9);
    QVERIFY((after.frame.translation - before.frame.translation).norm() > 1e-3);
    // Both floors have the same core: where wheels put the upper one to some centimetres, walls do to a few
    // millimetres.
    const auto truth = posesIn(folder_.filePath(QStringLiteral("truth.txt")));
    QCOMPARE(truth.size(), std::size_t(4));
    const auto errorOf = [&](const MappedFloor& floor) -> Eigen::Vector3d {
        const MapStop& first = floor.builder.map().stops.front();
        const Pose known = truth[0].pose.inverse() * truth[static_cast<std::size_t>(first.stop->id)].pose;
        return (floor.frame * first.pose).translation - known.translation;
    };
    QVERIFY(errorOf(after).head<2>().norm() < 0.5 * errorOf(before).head<2>().norm());
    // Tops of risers end with a slice; these are some centimetres apart at a distance of 6 m.
    QVERIFY2(std::abs(errorOf(after).z()) < 0.03, qPrintable(QString::number(errorOf(after).z())));
    QCOMPARE(parts_->mapEdits.inForce().size(), std::size_t(1));
    shown_->action("actUndo")->trigger();
    QVERIFY(settle());
    QVERIFY((map()->floors[1].frame.translation - before.frame.translation).norm() < 1e-12);
}

void MapWindowTest::aFloorIsPlacedByItsHandles()
{
    openFloors(QStringLiteral("two.pwscan"));
    View3d& view = parts_->window->mapView();
    find<QComboBox>("planFloor")->setCurrentText(QStringLiteral("1"));
    QTest::mouseClick(find<QPushButton>("placeFloor"), Qt::LeftButton);
    auto* dialog = parts_->window->findChild<PlaceDialog*>(QStringLiteral("floorDialog"));
    QVERIFY(dialog != nullptr);
    const Pose before = dialog->pose();
    QVERIFY(view.handles().shape().has_value());
    const Eigen::Vector3d middle = view.handles().shape()->middle;

    // Another floor that is asked for meanwhile has to wait.
    find<QComboBox>("planFloor")->setCurrentText(QStringLiteral("0"));
    QTest::mouseClick(find<QPushButton>("placeFloor"), Qt::LeftButton);
    QVERIFY((view.handles().shape()->middle - middle).norm() < 1e-9);
    find<QComboBox>("planFloor")->setCurrentText(QStringLiteral("1"));

    // 80 pixels to the right from above.
    view.showNamed(NamedView::Top);
    const Eigen::Vector3d seen = projected(view.camera(), middle);
    const QPoint at(static_cast<int>(std::lround(view.width() / 2.0 + seen.x() * view.height())),
                    static_cast<int>(std::lround(view.height() / 2.0 - seen.y() * view.height())));
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    QTest::mouseMove(&view, at + QPoint(40, 0));
    QTest::mouseMove(&view, at + QPoint(80, 0));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at + QPoint(80, 0));

    QVERIFY(dialog->place().has_value());
    const Eigen::Vector3d shift = dialog->pose().translation - before.translation;
    QVERIFY(shift.dot(view.camera().right()) > 0.5);
    QVERIFY(std::abs(shift.z()) < 1e-9 && std::abs(shift.dot(view.camera().up())) < 0.1);
    QVERIFY((view.handles().shape()->middle - middle - shift).norm() < 2e-3);

    // Numbers move the handles.
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("floorZ"))->setValue(before.translation.z() + 0.25);
    QVERIFY(std::abs(view.handles().shape()->middle.z() - middle.z() - 0.25) < 2e-3);
    const Pose place = dialog->pose();
    dialog->accept();
    QVERIFY(settle());

    QVERIFY(!view.handles().shape().has_value());
    const MappedFloor& after = map()->floors[1];
    const Pose stop = after.frame * after.builder.map().stops.front().pose;
    QVERIFY((stop.translation - place.translation).norm() < 1e-9);

    // Leaving the map ends it.
    QTest::mouseClick(find<QPushButton>("placeFloor"), Qt::LeftButton);
    QVERIFY(view.handles().shape().has_value());
    QTest::mouseClick(find<QPushButton>("mapClose"), Qt::LeftButton);
    QVERIFY(!view.handles().shape().has_value());
}

void MapWindowTest::theSliderShowsTheMapAsItWas()
{
    showMap();
    const std::size_t all = building().planes.size();

    find<QSlider>("mapUntil")->setValue(3);
    QVERIFY(settle());

    QCOMPARE(building().stops.size(), std::size_t(3));
    QVERIFY(building().planes.size() < all);
    QCOMPARE(building().allStops, 20);
    find<QSlider>("mapUntil")->setValue(20);
    QVERIFY(settle());
    QCOMPARE(building().planes.size(), all);
}

void MapWindowTest::aClickChoosesAPlaneAndItsMatch()
{
    showMap();
    View3d& view = parts_->window->mapView();

    emit view.clicked(Picked{Eigen::Vector3d::Zero(), 0, std::nullopt}, false);

    QCOMPARE(view.scene().selection().planes, std::set<PlaneId>{0});
    const std::vector<int> rows = panel().matchesTable()->chosenRows();
    QCOMPARE(rows.size(), std::size_t(1));
    QCOMPARE(building().matches[static_cast<std::size_t>(rows.front())].plane, 0);
}

void MapWindowTest::colouringsHaveLegends()
{
    showMap();
    const MapScene& scene = parts_->window->mapView().scene();
    const auto last = [&scene] { return scene.legend(100).back().text; };

    QVERIFY(last().starts_with("new at stop "));
    find<QComboBox>("mapColourBy")->setCurrentIndex(static_cast<int>(MapColourBy::Floor));
    QCOMPARE(last(), std::string("floor 0"));
    find<QComboBox>("mapColourBy")->setCurrentIndex(static_cast<int>(MapColourBy::Class));
    QCOMPARE(last(), std::string("wall"));
    find<QComboBox>("mapColourBy")->setCurrentIndex(static_cast<int>(MapColourBy::Uncertainty));
    QCOMPARE(last(), std::string("0.3 mm or less"));
    QCOMPARE(scene.legend(100)[0].text, std::string("way of the map"));
    QCOMPARE(scene.legend(100)[1].text, std::string("way by odometry"));
}

void MapWindowTest::leavingTheMapBringsTheScanBack()
{
    openBuilding();
    const bool timeline = parts_->window->findChild<QDockWidget*>(QStringLiteral("dockTimeline"))->isVisible();
    shown_->action("actMapMode")->trigger();
    QVERIFY(settle());
    QVERIFY(parts_->window->showsMapMode());
    QVERIFY(!parts_->window->findChild<QDockWidget*>(QStringLiteral("dockTimeline"))->isVisible());
    QVERIFY(panel().isVisible());

    QTest::mouseClick(find<QPushButton>("mapClose"), Qt::LeftButton);

    QVERIFY(!parts_->window->showsMapMode());
    QVERIFY(!shown_->action("actMapMode")->isChecked());
    QCOMPARE(parts_->window->findChild<QDockWidget*>(QStringLiteral("dockTimeline"))->isVisible(), timeline);
    QVERIFY(!panel().isVisible());
}

void MapWindowTest::cancellingGoesBackToTheScan()
{
    openBuilding();
    shown_->action("actMapMode")->trigger();
    QVERIFY(shown_->controllers->map.isBusy());

    QTest::mouseClick(find<QPushButton>("mapClose"), Qt::LeftButton);

    QVERIFY(!shown_->controllers->map.isBusy());
    QVERIFY(!parts_->window->showsMapMode());
    QVERIFY(map() == nullptr);
}

void MapWindowTest::itLooksAsItDid_data()
{
    QTest::addColumn<bool>("dark");
    QTest::addColumn<bool>("floors");
    QTest::newRow("window-map-light") << false << false;
    QTest::newRow("window-map-dark") << true << false;
    QTest::newRow("window-floors-light") << false << true;
    QTest::newRow("window-floors-dark") << true << true;
}

void MapWindowTest::itLooksAsItDid()
{
    QFETCH(bool, dark);
    QFETCH(bool, floors);
    parts_->preferences.theme = dark ? ThemeChoice::Dark : ThemeChoice::Light;
    emit parts_->preferencesChanged();
    parts_->window->resize(1440, 900);
    if (floors) {
        openFloors(QStringLiteral("two.pwscan"));
        find<QComboBox>("mapColourBy")->setCurrentIndex(static_cast<int>(MapColourBy::Floor));
        find<QComboBox>("planFloor")->setCurrentText(QStringLiteral("1"));
        QTest::mouseClick(find<QPushButton>("placeFloor"), Qt::LeftButton);
    } else {
        showMap();
    }
    for (const char* item : {"stDevice", "stStep", "stQueue", "stRec", "stMessage"})
        parts_->window->setStatus(QLatin1String(item), QLatin1String(item));
    parts_->window->banner().hide();
    QTest::qWait(400);

    const QString difference =
        differenceFromReference(takePicture(*parts_, {}, true), QString::fromLatin1(QTest::currentDataTag()));

    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::MapWindowTest)
#include "map_window_test.moc"
