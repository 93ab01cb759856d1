// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <sstream>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QtTest>

#include "app/window/exports.h"
#include "app/window/waiting.h"
#include "core/formats/planes_csv.h"
#include "core/pipeline/apply_edits.h"
#include "core/pipeline/plane_extractor.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"
#include "ui/panels/filtered_table.h"
#include "ui/panels/timeline_panel.h"

namespace planewright {

/// The whole window, driven by its widgets: somebody sits before it.
class WindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void theFirstPageShowsPlanesAfterOneClick();
    void aScanIsHeldSteppedAndFinished();
    void stoppingWorksInEveryState();
    void nothingMovesAfterAStopBeforeItIsReleased();
    void aLongQueueIsAmber();
    void aClickInTheTableSelectsInTheViewAndBack();
    void namesAreTypedInTheTableAndTakenBack();
    void theFilterKeepsWhatItAsksFor();
    void hidingTakesThePlaneOutOfThePicture();
    void shortcutsOfLettersWorkInTheViewOnly();
    void exportsAreTheBytesOfTheCommandLine();
    void reportsHavePicturesOfTheView();
    void measurementsComeFromClicks();
    void layersFollowMenuAndPanel();
    void anUnknownSceneIsToldInABanner();
    void theSourceSaysWhatIsOpen();
    void whatIsEmptyWithoutAScanIsFoldedAway();
    void theFirstPageIsWholeInTheSmallestWindow();
    void theTimelineSaysWhatToDoNext();
    void aLongMessageDoesNotWidenTheWindow();
    void extractingOnceMoreTakesTheNewParameters();
    void editsAndRerunsAreTakenBackInTheirOrder();
    void everyActionHasAWordATipAndAName();

private:
    QAction* action(const char* name) { return shown_->action(name); }
    QTableView* table() { return parts_->planesPanel->table()->view(); }

    QTemporaryDir folder_;
    std::unique_ptr<ShownWindow> shown_;
    WindowParts* parts_ = nullptr;
};

void WindowTest::initTestCase()
{
    useFixedLook();
}

void WindowTest::init()
{
    auto shown = ShownWindow::open(folder_.filePath("settings.ini"));
    QVERIFY2(shown, shown ? "" : shown.error().message.c_str());
    shown_ = std::move(*shown);
    parts_ = &shown_->parts;
}

void WindowTest::cleanup()
{
    shown_.reset();
    QFile::remove(folder_.filePath("settings.ini"));
}

void WindowTest::theFirstPageShowsPlanesAfterOneClick()
{
    QVERIFY(parts_->window->showsWelcome());
    auto* play = parts_->window->findChild<QPushButton*>(QStringLiteral("welcomeSample"));

    QTest::mouseClick(play, Qt::LeftButton);

    QVERIFY(!parts_->window->showsWelcome());
    QVERIFY(waitUntil([this] { return !parts_->shown->planes.empty(); }, kPatience));
}

void WindowTest::aScanIsHeldSteppedAndFinished()
{
    shown_->controllers->scan.open(QStringLiteral("sim:corridor?seed=7&speed=0.5"), true);
    QVERIFY(waitUntil([this] { return parts_->shown->step >= 2; }, kPatience));

    action("actPause")->trigger();
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Paused; }, kPatience));
    const auto isWorkedIn = [this] {
        const SessionStatus status = parts_->session.status();
        return status.acquired == status.extracted && parts_->session.map()->step + 1 == status.acquired;
    };
    QVERIFY(waitUntil(isWorkedIn, kPatience));
    const int held = parts_->session.map()->step;
    QVERIFY(action("actStep")->isEnabled());
    action("actStep")->trigger();
    QVERIFY(waitUntil([&] { return parts_->session.map()->step == held + 1; }, kPatience));
    QTest::qWait(200);
    QCOMPARE(parts_->session.map()->step, held + 1);

    action("actFinish")->trigger();
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    QVERIFY(waitForRest(*parts_, kPatience));
    QVERIFY(parts_->shown->finished);
    QCOMPARE(parts_->shown->step, held + 1);
}

void WindowTest::stoppingWorksInEveryState()
{
    QVERIFY(action("actStopMotion")->isEnabled());
    action("actStopMotion")->trigger();
    QVERIFY(parts_->session.isMotionStopped());
    QVERIFY(parts_->session.release());

    shown_->controllers->scan.open(QStringLiteral("sim:corridor?seed=7&speed=0.2"), true);
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Scanning; }, kPatience));
    action("actStopMotion")->trigger();

    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    QVERIFY(action("actStopMotion")->isEnabled());
}

void WindowTest::nothingMovesAfterAStopBeforeItIsReleased()
{
    shown_->controllers->scan.open(QStringLiteral("sim:corridor?seed=7&speed=0.2"), true);
    QVERIFY(waitUntil([this] { return parts_->session.status().acquired > 0; }, kPatience));
    action("actStopMotion")->trigger();
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    Banner& banner = parts_->window->banner();
    QVERIFY(banner.isVisible() && banner.text().contains("Motion was stopped"));
    banner.hide();

    action("actStart")->trigger();

    QCOMPARE(parts_->session.state(), SessionState::Review);
    QVERIFY(banner.isVisible() && banner.text().contains("release"));
    banner.findChild<QPushButton*>(QStringLiteral("bannerFirst"))->click();
    QVERIFY(!parts_->session.isMotionStopped());
    QVERIFY(!banner.isVisible());
    action("actStart")->trigger();
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Scanning; }, kPatience));
}

void WindowTest::aLongQueueIsAmber()
{
    const auto* queue = shown_->parts.window->findChild<QLabel*>(QStringLiteral("stQueue"));
    QVERIFY(queue != nullptr);
    SessionStatus status;

    status.queueDepth = 63;
    emit parts_->session.statusChanged(status);
    const bool isAmberBefore = queue->styleSheet().contains("#8a5a00");
    status.queueDepth = 64;
    emit parts_->session.statusChanged(status);

    QVERIFY(!isAmberBefore);
    QVERIFY(queue->styleSheet().contains("#8a5a00"));
    QVERIFY(queue->text().contains("64"));
}

void WindowTest::aClickInTheTableSelectsInTheViewAndBack()
{
    QVERIFY(shown_->scanCorridor());
    const QModelIndex first = table()->model()->index(0, static_cast<int>(PlaneColumn::Id));
    QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, table()->visualRect(first).center());

    QCOMPARE(parts_->selection.planes().size(), std::size_t(1));
    QCOMPARE(parts_->window->view().scene().selection().planes, parts_->selection.planes());

    parts_->window->view().showNamed(NamedView::Top);
    QTest::mouseClick(&parts_->window->view(), Qt::LeftButton, {}, parts_->window->view().rect().center());
    QCOMPARE(parts_->selection.planes().size(), std::size_t(1));
    const QModelIndexList rows = table()->selectionModel()->selectedRows();
    QCOMPARE(rows.size(), 1);
}

void WindowTest::namesAreTypedInTheTableAndTakenBack()
{
    QVERIFY(shown_->scanCorridor());
    const PlaneId plane = parts_->shown->planes.front().plane->id;
    parts_->selection.select({plane});

    action("actRename")->trigger();
    auto* editor = table()->findChild<QLineEdit*>();
    QVERIFY(editor != nullptr);
    QTest::keyClicks(editor, "North wall");
    QTest::keyClick(editor, Qt::Key_Return);

    QVERIFY(waitUntil([this] { return parts_->shown->planes.front().name == "North wall"; }, kPatience));
    action("actUndo")->trigger();
    QVERIFY(waitUntil([this] { return parts_->shown->planes.front().name.empty(); }, kPatience));
    action("actRedo")->trigger();
    QVERIFY(waitUntil([this] { return parts_->shown->planes.front().name == "North wall"; }, kPatience));
}

void WindowTest::theFilterKeepsWhatItAsksFor()
{
    QVERIFY(shown_->scanCorridor());
    const auto walls = std::count_if(parts_->shown->planes.begin(), parts_->shown->planes.end(),
                                     [](const ShownPlane& plane) { return plane.className == "wall"; });
    QVERIFY(walls > 0 && static_cast<std::size_t>(walls) < parts_->shown->planes.size());

    action("actFindPlane")->trigger();
    QWidget* filter = QApplication::focusWidget();
    QVERIFY(filter != nullptr);
    QTest::keyClicks(filter, "class:wall");

    QTRY_COMPARE(table()->model()->rowCount(), static_cast<int>(walls));
}

void WindowTest::hidingTakesThePlaneOutOfThePicture()
{
    QVERIFY(shown_->scanCorridor());
    const auto& planes = parts_->shown->planes;
    const auto largest = std::max_element(
        planes.begin(), planes.end(), [](const auto& a, const auto& b) { return a.plane->points < b.plane->points; });
    parts_->selection.select({largest->plane->id});
    parts_->window->view().scene().update();
    const std::size_t before = parts_->window->view().scene().points().points();

    action("actHide")->trigger();
    QVERIFY(waitForRest(*parts_, kPatience));
    QVERIFY(waitUntil(
        [this] {
            return std::any_of(parts_->shown->planes.begin(), parts_->shown->planes.end(),
                               [](const ShownPlane& plane) { return plane.hidden; });
        },
        kPatience));

    parts_->window->view().scene().update();
    QVERIFY(parts_->window->view().scene().points().points() < before);
    action("actShowAll")->trigger();
    QVERIFY(waitUntil(
        [this] {
            return std::none_of(parts_->shown->planes.begin(), parts_->shown->planes.end(),
                                [](const ShownPlane& plane) { return plane.hidden; });
        },
        kPatience));
}

void WindowTest::shortcutsOfLettersWorkInTheViewOnly()
{
    QVERIFY(shown_->scanCorridor());
    parts_->window->activateWindow();
    parts_->window->view().setFocus();
    const bool shown = parts_->layers[Layer::Points].visible;

    QTest::keyClick(&parts_->window->view(), Qt::Key_P);
    QCOMPARE(parts_->layers[Layer::Points].visible, !shown);

    action("actFindPlane")->trigger();
    QWidget* filter = QApplication::focusWidget();
    QTest::keyClick(filter, Qt::Key_P);
    QCOMPARE(parts_->layers[Layer::Points].visible, !shown);
}

void WindowTest::exportsAreTheBytesOfTheCommandLine()
{
    QVERIFY(shown_->scanCorridor());
    const QString file = folder_.filePath("planes.csv");

    const auto write = exportOf(*parts_, ExportKind::PlanesFound, file);

    QVERIFY2(write, write ? "" : write.error().message.c_str());
    const auto done = (*write)();
    QVERIFY2(done, done ? "" : done.error().message.c_str());
    // The same slices in one go, as the command line extracts them.
    const SessionMap& map = *parts_->session.map();
    const Parameters& parameters = parts_->session.parameters();
    PlaneExtractor extractor(map.sensor, parameters);
    for (const SharedSlice& slice : map.slices)
        extractor.advance(*slice);
    const auto snapshot = extractor.finish();
    const EditedPlanes planes = applyEdits(*snapshot, {}, parts_->session.description(), parameters);
    std::ostringstream expected;
    QVERIFY(writePlanesCsv(expected, planeResults(planes.planes, snapshot->segments)));
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QCOMPARE(written.readAll().toStdString(), expected.str());
}

void WindowTest::reportsHavePicturesOfTheView()
{
    QVERIFY(shown_->scanCorridor());
    const QString file = folder_.filePath("report.html");
    const ViewCamera camera = parts_->window->view().camera();

    const auto write = exportOf(*parts_, ExportKind::PageOfScan, file);

    QVERIFY2(write, write ? "" : write.error().message.c_str());
    QCOMPARE(parts_->window->view().camera(), camera);
    QVERIFY((*write)());
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QByteArray page = written.readAll();
    QCOMPARE(page.count("src=\"data:image/png;base64,"), 2);
    const qsizetype begin = page.indexOf("base64,") + 7;
    const QImage picture =
        QImage::fromData(QByteArray::fromBase64(page.mid(begin, page.indexOf('"', begin) - begin)), "png");
    QCOMPARE(picture.size(), QSize(1040, 650));
}

void WindowTest::measurementsComeFromClicks()
{
    QVERIFY(shown_->scanCorridor());
    View3d& view = parts_->window->view();
    view.showNamed(NamedView::Top);
    action("actMeasureDistance")->setChecked(true);

    QTest::mouseClick(&view, Qt::LeftButton, {}, view.rect().center());
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.rect().center() + QPoint(0, 40));

    QCOMPARE(parts_->measurements.rowCount(), 1);
    QVERIFY(*parts_->measurements.at(0).distance > 0.1);
}

void WindowTest::layersFollowMenuAndPanel()
{
    action("actLayerClusters")->setChecked(false);
    QVERIFY(!parts_->layersPanel->settings()[Layer::Clusters].visible);
    QVERIFY(!parts_->window->view().scene().layers()[Layer::Clusters].visible);

    LayerSettings changed = parts_->layersPanel->settings();
    changed[Layer::Clusters].visible = true;
    emit parts_->layersPanel->settingsChanged(changed);
    QVERIFY(action("actLayerClusters")->isChecked());
}

void WindowTest::anUnknownSceneIsToldInABanner()
{
    shown_->controllers->scan.open(QStringLiteral("sim:palace"), true);

    QTRY_VERIFY(parts_->window->banner().isVisible());
    QVERIFY(parts_->window->banner().text().contains("palace"));
    QVERIFY(parts_->window->banner().text().contains("corridor"));
}

void WindowTest::extractingOnceMoreTakesTheNewParameters()
{
    QVERIFY(shown_->scanCorridor());
    const std::size_t before = parts_->shown->snapshot->segments.segmentCount();

    QVERIFY(parts_->parameters.setText("segments.min-points", "80").isEmpty());
    QVERIFY(action("actRerun")->isEnabled());
    const auto snapshot = parts_->shown->snapshot;
    action("actRerun")->trigger();
    QVERIFY(waitUntil([&] { return parts_->shown->snapshot != snapshot; }, kPatience));
    QVERIFY(waitForRest(*parts_, kPatience));

    QVERIFY(parts_->shown->snapshot->segments.segmentCount() < before);
}

void WindowTest::everyActionHasAWordATipAndAName()
{
    QSet<QString> names;
    QSet<QString> shortcuts;
    for (const QAction* each : parts_->window->actions().all()) {
        QVERIFY(!each->text().isEmpty());
        QVERIFY2(!each->statusTip().isEmpty(), qPrintable(each->objectName()));
        QVERIFY(each->objectName().startsWith("act"));
        QVERIFY2(!names.contains(each->objectName()), qPrintable(each->objectName()));
        names.insert(each->objectName());
        for (const QKeySequence& keys : each->shortcuts()) {
            QVERIFY2(!shortcuts.contains(keys.toString()), qPrintable(keys.toString()));
            shortcuts.insert(keys.toString());
        }
    }
    QCOMPARE(action("actStopMotion")->shortcuts().size(), 2);
}

void WindowTest::editsAndRerunsAreTakenBackInTheirOrder()
{
    QVERIFY(shown_->scanCorridor());
    const auto settle = [this] { return waitForRest(*parts_, kPatience).has_value(); };
    const auto name = [this] { return QString::fromStdString(parts_->shown->planes.front().name); };
    const PlaneId plane = parts_->shown->planes.front().plane->id;
    QVERIFY(parts_->undo.add({Edit::Kind::Rename, {plane}, "North", true}));
    const auto before = parts_->session.map()->snapshot;
    action("actRerun")->trigger();
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    const auto again = parts_->session.map()->snapshot;
    QVERIFY(again != before);
    QVERIFY(settle());
    QCOMPARE(name(), QStringLiteral("North"));
    QCOMPARE(parts_->undo.entries().size(), std::size_t(2));

    action("actUndo")->trigger();
    QVERIFY(settle());
    QCOMPARE(parts_->session.map()->snapshot, before);
    QCOMPARE(name(), QStringLiteral("North"));
    action("actUndo")->trigger();
    QVERIFY(settle());
    QVERIFY(name().isEmpty());
    QVERIFY(!action("actUndo")->isEnabled());

    action("actRedo")->trigger();
    QVERIFY(settle());
    QCOMPARE(parts_->session.map()->snapshot, before);
    QCOMPARE(name(), QStringLiteral("North"));
    action("actRedo")->trigger();
    QVERIFY(settle());
    QCOMPARE(parts_->session.map()->snapshot, again);
    QVERIFY(!action("actRedo")->isEnabled());

    // Whoever goes another way has nothing to make again.
    action("actUndo")->trigger();
    QVERIFY(parts_->undo.add({Edit::Kind::Rename, {plane}, "South", true}));
    QVERIFY(!action("actRedo")->isEnabled());
    QVERIFY(settle());
}

void WindowTest::theSourceSaysWhatIsOpen()
{
    const auto field = [this](const char* name) {
        return parts_->sourcePanel->findChild<QWidget*>(QLatin1String(name));
    };
    shown_->controllers->scan.open(QStringLiteral("sim:office?seed=3&speed=0"), true);
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));

    QCOMPARE(parts_->sourcePanel->simulation(), (SimulationSetup{.scene = "office", .seed = 3, .speed = 0.0}));
    QVERIFY(!field("notInUse")->isVisible());

    // A form that was changed stays when the open room is scanned again.
    static_cast<QLineEdit*>(field("seed"))->setText(QStringLiteral("4"));
    QVERIFY(field("notInUse")->isVisible());
    action("actStart")->trigger();
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    QCOMPARE(parts_->sourcePanel->simulation().seed, std::uint64_t(4));
    QVERIFY(field("notInUse")->isVisible());

    static_cast<QPushButton*>(field("openSource"))->click();
    QVERIFY(waitUntil([this] { return parts_->session.address().find("seed=4") != std::string::npos; }, kPatience));
    QVERIFY(!field("notInUse")->isVisible());
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));

    const std::string file = PLANEWRIGHT_SOURCE_DIR "/resources/samples/desk.csv.gz";
    shown_->controllers->scan.open(QString::fromStdString(file));
    QVERIFY(waitUntil([&] { return parts_->session.address() == file; }, kPatience));
    QCOMPARE(static_cast<QComboBox*>(field("sourceType"))->currentIndex(), 1);
    QCOMPARE(static_cast<QLineEdit*>(field("recordingFile"))->text().toStdString(), file);
    QVERIFY(!field("notInUse")->isVisible());
}

void WindowTest::whatIsEmptyWithoutAScanIsFoldedAway()
{
    const auto dock = [this](const char* name) { return parts_->window->findChild<QWidget*>(QLatin1String(name)); };
    QVERIFY(dock("dockSetup")->isVisible());
    QVERIFY(!dock("dockInspector")->isVisible());
    QVERIFY(!dock("dockBottom")->isVisible());

    QVERIFY(shown_->scanCorridor());
    QVERIFY(dock("dockInspector")->isVisible());
    QVERIFY(dock("dockBottom")->isVisible());

    // What somebody has closed stays closed.
    dock("dockInspector")->hide();
    parts_->session.close();
    QVERIFY(!dock("dockBottom")->isVisible());
    QVERIFY(shown_->scanCorridor());
    QVERIFY(!dock("dockInspector")->isVisible());
    QVERIFY(dock("dockBottom")->isVisible());
}

void WindowTest::theFirstPageIsWholeInTheSmallestWindow()
{
    parts_->window->resize(1024, 700);
    QTest::qWait(0);

    const WelcomePage& page = parts_->window->welcome();
    for (const QLabel* label : page.findChildren<QLabel*>()) {
        QVERIFY2(label->mapTo(&page, QPoint(label->width(), 0)).x() <= page.width(), qPrintable(label->text()));
        QVERIFY2(label->sizeHint().width() <= label->width() || label->wordWrap(), qPrintable(label->text()));
        QVERIFY2(label->heightForWidth(label->width()) <= label->height(), qPrintable(label->text()));
    }
    for (const QPushButton* button : page.findChildren<QPushButton*>())
        QVERIFY2(button->mapTo(&page, QPoint(button->width(), 0)).x() <= page.width(), qPrintable(button->text()));
}

void WindowTest::aLongMessageDoesNotWidenTheWindow()
{
    parts_->window->resize(1024, 700);
    const QString message(600, QLatin1Char('w'));

    parts_->say(message);
    QTest::qWait(0);

    const auto* label = parts_->window->findChild<QLabel*>(QStringLiteral("stMessage"));
    QCOMPARE(parts_->window->size(), QSize(1024, 700));
    QVERIFY(parts_->window->minimumSizeHint().width() <= 1024);
    QVERIFY(label->mapTo(parts_->window.get(), QPoint(label->width(), 0)).x() <= 1024);
    QCOMPARE(label->text(), message);
    QCOMPARE(label->toolTip(), message);
}

void WindowTest::theTimelineSaysWhatToDoNext()
{
    const auto hint = [this] {
        return parts_->window->findChild<TimelinePanel*>(QStringLiteral("timelinePanel"))->strip().hint();
    };
    QVERIFY(!hint().contains(QStringLiteral("F5")));  // there is nothing to scan

    shown_->controllers->scan.open(QStringLiteral("sim:corridor?seed=7"));
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Ready; }, kPatience));
    QCOMPARE(hint(), QStringLiteral("Press F5 to scan."));
    action("actStopMotion")->trigger();
    QVERIFY(hint().startsWith(QStringLiteral("Release the motion")));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::WindowTest)
#include "window_test.moc"
