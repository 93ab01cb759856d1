// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QSpinBox>
#include <QtTest>

#include "app/window/exports.h"
#include "app/window/waiting.h"
#include "core/formats/pwscan_writer.h"
#include "core/simulation/nodding_scanner.h"
#include "devices/emulated/simulated_room.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"
#include "ui/panels/timeline_button.h"

namespace planewright {

/// The timeline in the window: somebody looks back at a scan, while it runs and after it.
class TimelineWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { useFixedLook(); }
    void init();
    void cleanup();
    void lookingBackDoesNotHoldTheScan();
    void aHeldScanIsSteppedAtItsNewestStep();
    void keysGoBothWays();
    void keysWorkInTheTimelineAndNotInFields();
    void draggingShowsEachStep();
    void eventsAreFoundByTheirKind();
    void phasesAreShownInTheView();
    void playingEndsAtTheNewestStep();
    void aRangeIsPlayedAgain();
    void bookmarksAreKeptWithTheScan();
    void editsAreMarkedWhereTheirPlaneWasBorn();
    void faultsOfARecordingAreMarkedAtTheirStep();
    void layoutsShowWhatTheyAreFor_data();
    void layoutsShowWhatTheyAreFor();
    void everyStepLooksTheSameBothWays_data();
    void everyStepLooksTheSameBothWays();

private:
    QAction* action(const char* name) { return shown_->action(name); }
    QWidget& view() { return parts_->window->view(); }
    TimelinePanel& panel() { return shown_->controllers->timeline.panel(); }
    TimelineStrip& strip() { return panel().strip(); }
    int place() const { return parts_->playhead.place(); }
    int newest() const { return static_cast<int>(parts_->playhead.history().size()) - 1; }
    QString chip() { return parts_->window->view().overlay().stateText; }
    QPoint inColumn(int place)
    {
        return {static_cast<int>(strip().columnRect(place).center().x()), strip().height() / 2};
    }
    void rest() { QVERIFY(waitForRest(*parts_, kPatience)); }

    QTemporaryDir folder_;
    std::unique_ptr<ShownWindow> shown_;
    WindowParts* parts_ = nullptr;
};

void TimelineWindowTest::init()
{
    auto shown = ShownWindow::open(folder_.filePath("settings.ini"));
    QVERIFY2(shown, shown ? "" : shown.error().message.c_str());
    shown_ = std::move(*shown);
    parts_ = &shown_->parts;
}

void TimelineWindowTest::cleanup()
{
    shown_.reset();
    QFile::remove(folder_.filePath("settings.ini"));
}

void TimelineWindowTest::lookingBackDoesNotHoldTheScan()
{
    shown_->controllers->scan.open(QStringLiteral("sim:corridor?seed=7&speed=0.5"), true);
    QVERIFY(waitUntil([this] { return newest() >= 10; }, kPatience));
    auto* live = panel().findChild<LiveButton*>();
    QVERIFY(!live->isCalling());

    QTest::mouseClick(&strip(), Qt::LeftButton, {}, inColumn(4));

    const int acquired = parts_->session.status().acquired;
    QCOMPARE(place(), 4);
    QVERIFY(live->isCalling());
    QVERIFY(waitUntil([&] { return parts_->session.status().acquired >= acquired + 10; }, kPatience));
    QCOMPARE(parts_->session.state(), SessionState::Scanning);
    QCOMPARE(place(), 4);
    QVERIFY(waitUntil([this] { return parts_->shown->step == 4; }, kPatience));
    QVERIFY(newest() > 10);
    QVERIFY2(chip().startsWith("● Scanning") && chip().contains("seen at step 5"), qPrintable(chip()));

    QTest::keyClick(&strip(), Qt::Key_L);

    QVERIFY(parts_->playhead.followsNewest());
    QVERIFY(!live->isCalling());
    QVERIFY(waitUntil([&] { return parts_->shown->step >= acquired + 10; }, kPatience));
    QVERIFY(!chip().contains("seen at"));
}

void TimelineWindowTest::aHeldScanIsSteppedAtItsNewestStep()
{
    shown_->controllers->scan.open(QStringLiteral("sim:corridor?seed=7&speed=0.5"), true);
    QVERIFY(waitUntil([this] { return newest() >= 5; }, kPatience));
    action("actPause")->trigger();
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Paused; }, kPatience));
    QVERIFY(waitUntil(
        [this] {
            const SessionStatus status = parts_->session.status();
            return status.acquired == status.extracted && newest() + 1 == status.acquired;
        },
        kPatience));
    const int held = newest();
    view().setFocus();

    QTest::keyClick(&view(), Qt::Key_Comma);
    QTest::keyClick(&view(), Qt::Key_Comma);
    QCOMPARE(place(), held - 2);
    QTest::keyClick(&view(), Qt::Key_Period);
    QTest::keyClick(&view(), Qt::Key_Period);
    QCOMPARE(place(), held);
    QTest::qWait(100);
    QCOMPARE(newest(), held);  // it was only looked at

    QTest::keyClick(&view(), Qt::Key_Period);

    QVERIFY(waitUntil([&] { return newest() == held + 1; }, kPatience));
    QCOMPARE(place(), held + 1);
}

void TimelineWindowTest::keysGoBothWays()
{
    QVERIFY(shown_->scanCorridor());
    view().setFocus();
    QCOMPARE(newest(), 137);  // 137 steps and the forced last pass
    const auto press = [&](int key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&view(), static_cast<Qt::Key>(key), modifiers);
        return place();
    };

    QCOMPARE(press(Qt::Key_Home), 0);
    QVERIFY(!action("actStepBack")->isEnabled());
    QCOMPARE(press(Qt::Key_Period), 1);
    QCOMPARE(press(Qt::Key_Right), 2);
    QCOMPARE(press(Qt::Key_Right, Qt::ControlModifier), 12);
    QCOMPARE(press(Qt::Key_Left, Qt::ControlModifier), 2);
    QCOMPARE(press(Qt::Key_Comma), 1);
    QCOMPARE(press(Qt::Key_Left), 0);
    QCOMPARE(press(Qt::Key_End), 137);
    QVERIFY(parts_->playhead.followsNewest());
    QVERIFY(!action("actStepForward")->isEnabled());
    QCOMPARE(press(Qt::Key_Comma), 136);
    rest();
    QVERIFY2(chip().contains("seen at step 137"), qPrintable(chip()));
    QCOMPARE(press(Qt::Key_L), 137);
    rest();
    QVERIFY2(!chip().contains("seen at"), qPrintable(chip()));
}

void TimelineWindowTest::keysWorkInTheTimelineAndNotInFields()
{
    QVERIFY(shown_->scanCorridor());
    strip().setFocus();

    QTest::keyClick(&strip(), Qt::Key_Home);
    QCOMPARE(place(), 0);
    QTest::keyClick(&strip(), Qt::Key_Right);
    QCOMPARE(place(), 1);
    action("actFindPlane")->trigger();
    QWidget* filter = QApplication::focusWidget();
    QVERIFY(filter != nullptr);
    for (const Qt::Key key : {Qt::Key_Period, Qt::Key_Space, Qt::Key_End, Qt::Key_Right, Qt::Key_M})
        QTest::keyClick(filter, key);
    QCOMPARE(place(), 1);
    QVERIFY(parts_->playhead.bookmarks().empty());

    auto* box = panel().findChild<QSpinBox*>("timelineStep");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, "63");
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(parts_->playhead.snapshot()->report.step, 62);
}

void TimelineWindowTest::draggingShowsEachStep()
{
    QVERIFY(shown_->scanCorridor());
    QTest::mousePress(&strip(), Qt::LeftButton, {}, inColumn(20));
    for (const int to : {40, 90, 30}) {
        QTest::mouseMove(&strip(), inColumn(to));
        QCOMPARE(place(), to);
        rest();
        QCOMPARE(parts_->shown->step, to);
        QCOMPARE(parts_->shown->snapshot, parts_->playhead.history()[static_cast<std::size_t>(to)]);
    }
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, inColumn(30));
}

void TimelineWindowTest::eventsAreFoundByTheirKind()
{
    QVERIFY(shown_->scanCorridor());
    auto* kind = panel().findChild<QComboBox*>("timelineEventKind");
    kind->setCurrentIndex(1);  // new planes
    view().setFocus();
    // The places where the number of the fits that succeeded says so, by the decisions themselves.
    std::vector<int> expected;
    const auto& history = parts_->playhead.history();
    for (std::size_t each = 1; each < history.size(); ++each) {
        const auto& decisions = history[each]->report.decisions;
        if (std::any_of(decisions.begin(), decisions.end(), [](const Decision& decision) {
                return decision.kind == DecisionKind::Fit && decision.phase != Phase::SplitMerge;
            }))
            expected.push_back(static_cast<int>(each));
    }
    QVERIFY(expected.size() > 2);

    QTest::keyClick(&view(), Qt::Key_Home);
    std::vector<int> found;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        QTest::keyClick(&view(), Qt::Key_Period, Qt::ShiftModifier);
        found.push_back(place());
    }
    QCOMPARE(found, expected);
    for (std::size_t i = expected.size() - 1; i-- > 0;) {
        QTest::keyClick(&view(), Qt::Key_Comma, Qt::ShiftModifier);
        QCOMPARE(place(), expected[i]);
    }
}

void TimelineWindowTest::phasesAreShownInTheView()
{
    QVERIFY(shown_->scanCorridor());
    view().setFocus();
    // A step whose fit gave a plane: before that phase there is none of it.
    int fitted = -1;
    const auto& history = parts_->playhead.history();
    for (int each = 1; each < newest() && fitted < 0; ++each) {
        const auto planes = [&](int at) { return history[static_cast<std::size_t>(at)]->planes.size(); };
        if (planes(each) > planes(each - 1) && planes(each - 1) > 0)
            fitted = each;
    }
    QVERIFY(fitted > 0);
    parts_->playhead.goTo(fitted);
    rest();
    const std::size_t after = parts_->shown->planes.size();
    const QImage whole = parts_->window->view().picture({320, 200}, 1.0);

    QStringList chips;
    std::size_t before = after;
    while (place() == fitted) {
        QTest::keyClick(&view(), Qt::Key_Comma, Qt::AltModifier);
        rest();
        if (place() != fitted)
            break;
        chips.push_back(chip());
        QCOMPARE(parts_->shown->snapshot, parts_->shownPhase);
        before = parts_->shown->planes.size();
    }
    QVERIFY(before < after);
    QVERIFY(chips.size() >= 3);  // of extract, assign, cluster, fit: all but the last
    QVERIFY2(chips.back().contains(QStringLiteral("seen at step %1 after extracting segments").arg(fitted + 1)),
             qPrintable(chips.back()));
    QVERIFY(parts_->window->view().picture({320, 200}, 1.0) != whole);
    // It went on to the last phase of the step before; and forward again, to what the whole step gives.
    QCOMPARE(place(), fitted - 1);
    QTest::keyClick(&view(), Qt::Key_Period, Qt::AltModifier);
    QCOMPARE(place(), fitted);
    QCOMPARE(parts_->playhead.phase(), std::optional<std::size_t>(0));
    for (qsizetype i = 0; i < chips.size(); ++i)
        QTest::keyClick(&view(), Qt::Key_Period, Qt::AltModifier);
    rest();
    QCOMPARE(place(), fitted);
    QCOMPARE(parts_->shown->planes.size(), after);
}

void TimelineWindowTest::playingEndsAtTheNewestStep()
{
    QVERIFY(shown_->scanCorridor());
    view().setFocus();
    panel().changeSpeed(10);  // 137 turns of the mirror in a third of a second
    QTest::keyClick(&view(), Qt::Key_Home);

    QTest::keyClick(&view(), Qt::Key_Space);

    QVERIFY(action("actPlay")->isChecked());
    QVERIFY(waitUntil([this] { return place() > 0; }, kPatience));
    QVERIFY(waitUntil([this] { return place() == newest(); }, kPatience));
    QVERIFY(!action("actPlay")->isChecked());
    QVERIFY(parts_->playhead.followsNewest());

    QTest::keyClick(&view(), Qt::Key_Space);  // anew
    QVERIFY(shown_->controllers->timeline.player().isPlaying());
    QTest::keyClick(&view(), Qt::Key_Period);
    QVERIFY(!shown_->controllers->timeline.player().isPlaying());
}

void TimelineWindowTest::aRangeIsPlayedAgain()
{
    QVERIFY(shown_->scanCorridor());
    view().setFocus();
    parts_->playhead.goTo(20);
    QTest::keyClick(&view(), Qt::Key_BracketLeft);
    parts_->playhead.goTo(24);
    QTest::keyClick(&view(), Qt::Key_BracketRight);
    QCOMPARE(parts_->playhead.loop(), std::optional(std::pair(20, 24)));
    QVERIFY(action("actLoop")->isChecked());

    QSet<int> seen;
    int turns = 0;
    QObject listener;
    connect(&parts_->playhead, &Playhead::placeChanged, &listener, [&, last = -1](int at) mutable {
        seen << at;
        turns += at < last ? 1 : 0;
        last = at;
    });
    QTest::keyClick(&view(), Qt::Key_Space);
    QVERIFY(waitUntil([&] { return turns >= 2; }, kPatience));
    action("actPlay")->trigger();

    for (const int at : seen)
        QVERIFY(at >= 20 && at <= 24);
    QVERIFY(!action("actPlay")->isChecked());
    action("actLoop")->trigger();
    QVERIFY(!parts_->playhead.loop());
}

void TimelineWindowTest::bookmarksAreKeptWithTheScan()
{
    QVERIFY(shown_->scanCorridor());
    const QString file = folder_.filePath("bookmarked.pwscan");
    const auto write = copyOf(*parts_, file);
    QVERIFY(write && (*write)());
    const auto open = [&] {
        shown_->controllers->scan.open(file);
        QVERIFY(waitUntil(
            [&] {
                return parts_->session.address() == file.toStdString() &&
                       parts_->session.state() == SessionState::Review;
            },
            kPatience));
        rest();
    };
    open();
    view().setFocus();
    for (const int at : {20, 90, 50, 20}) {
        parts_->playhead.goTo(at);
        QTest::keyClick(&view(), Qt::Key_M);
    }
    QTest::keyClick(&view(), Qt::Key_End);
    QTest::keyClick(&view(), Qt::Key_M);
    QCOMPARE(parts_->playhead.bookmarks(), (std::set<int>{50, 90, 137}));

    shown_->controllers->scan.open(QStringLiteral("sim:corridor?seed=7&speed=0"), true);
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    QVERIFY(parts_->playhead.bookmarks().empty());
    open();

    QCOMPARE(parts_->playhead.bookmarks(), (std::set<int>{50, 90, 137}));
    QTest::keyClick(&view(), Qt::Key_Home);
    QTest::keyClick(&view(), Qt::Key_N);
    QCOMPARE(place(), 50);
    QTest::keyClick(&view(), Qt::Key_N);
    QCOMPARE(place(), 90);
    // Extracting once more makes another history of the same steps.
    action("actRerun")->trigger();
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    rest();
    QCOMPARE(parts_->playhead.bookmarks(), (std::set<int>{50, 90, 137}));
}

void TimelineWindowTest::editsAreMarkedWhereTheirPlaneWasBorn()
{
    QVERIFY(shown_->scanCorridor());
    // The last plane that was fitted in a step, and the first step that shows it.
    const PlaneId plane = parts_->shown->planes.back().plane->id;
    const auto& history = parts_->playhead.history();
    int born = 0;
    const auto has = [&](const Snapshot& snapshot) {
        return std::any_of(snapshot.planes.begin(), snapshot.planes.end(),
                           [&](const auto& each) { return each->id == plane; });
    };
    while (!has(*history[static_cast<std::size_t>(born)]))
        ++born;
    const auto edits = [&](int at) { return strip().columns()[static_cast<std::size_t>(at)].edits; };
    QVERIFY(edits(born).isEmpty());
    parts_->selection.select({plane});

    action("actHide")->trigger();
    QVERIFY(waitUntil([&] { return !edits(born).isEmpty(); }, kPatience));
    QVERIFY2(edits(born).front().contains("hidden"), qPrintable(edits(born).front()));
    action("actUndo")->trigger();
    QVERIFY(waitUntil([&] { return edits(born).isEmpty(); }, kPatience));
}

void TimelineWindowTest::faultsOfARecordingAreMarkedAtTheirStep()
{
    const std::string path = folder_.filePath("faults.pwscan").toStdString();
    const SimulatedScan scan = simulate(*makeScene("corridor", 7), {}, simulationNoise("default").value(), 7);
    ScanRecord record;
    record.name = "with faults";
    record.startedUtc = "2026-03-01T08:30:00Z";
    record.description = scan.recording.description;
    auto writer = PwscanWriter::create(path, record);
    QVERIFY2(writer, writer ? "" : writer.error().message.c_str());
    for (const ScanSlice& slice : scan.recording.slices) {
        // Step 21 was lost with a fault; what is told of it stands at the step before.
        if (slice.step != 20)
            QVERIFY(writer->write(slice));
    }
    const auto tell = [&](ScanEvent::Kind kind, std::optional<int> step, const char* payload) {
        return writer->write(ScanEvent{kind, step, {}, payload}).has_value();
    };
    QVERIFY(tell(ScanEvent::Kind::Fault, 8, "The scanner did not answer\nwithin 2 s."));
    QVERIFY(tell(ScanEvent::Kind::Recovered, 9, ""));
    QVERIFY(tell(ScanEvent::Kind::Fault, 20, R"({"message":"The cable was pulled."})"));
    QVERIFY(tell(ScanEvent::Kind::Fault, {}, "somewhen"));
    QVERIFY(tell(ScanEvent::Kind::Note, 12, "no fault"));
    QVERIFY(writer->close(ScanState::Complete));

    shown_->controllers->scan.open(QString::fromStdString(path), true);
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    rest();

    const auto faultsAt = [this](int at) { return strip().columns()[static_cast<std::size_t>(at)].faults; };
    QCOMPARE(faultsAt(8), QStringList{"The scanner did not answer within 2 s."});
    QCOMPARE(faultsAt(9), QStringList{"went on after a fault"});
    QVERIFY(faultsAt(12).empty());
    QCOMPARE(faultsAt(19), QStringList{"The cable was pulled."});
    QCOMPARE(faultsAt(20), QStringList{"step 21 was lost"});
    panel().findChild<QComboBox*>("timelineEventKind")->setCurrentIndex(3);  // faults
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Home);
    std::vector<int> found;
    for (int i = 0; i < 4; ++i) {
        QTest::keyClick(&view(), Qt::Key_Period, Qt::ShiftModifier);
        found.push_back(place());
    }
    QCOMPARE(found, (std::vector<int>{8, 9, 19, 20}));
}

void TimelineWindowTest::layoutsShowWhatTheyAreFor_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("first start") << QSize(1440, 900);
    QTest::newRow("smallest") << QSize(1024, 700);
}

void TimelineWindowTest::layoutsShowWhatTheyAreFor()
{
    QFETCH(QSize, size);
    MainWindow& window = *parts_->window;
    window.resize(size);
    const auto dock = [&](const char* name) { return window.findChild<QDockWidget*>(QLatin1String(name)); };
    const auto fits = [&] {
        QTest::qWait(50);
        QCOMPARE(window.size(), size);
        for (QDockWidget* each : window.findChildren<QDockWidget*>()) {
            const QRect placed(each->mapTo(&window, QPoint()), each->size());
            QVERIFY2(!each->isVisible() || window.rect().contains(placed), qPrintable(each->objectName()));
        }
        QVERIFY(window.centralWidget()->height() >= 200);
        // All of its buttons are to be seen.
        const QRect live(panel().findChild<LiveButton*>()->mapTo(&panel(), QPoint()),
                         panel().findChild<LiveButton*>()->size());
        QVERIFY(panel().rect().contains(live));
    };

    action("actLayoutOperate")->trigger();
    fits();
    QVERIFY(dock("dockTimeline")->isVisible() && dock("dockSetup")->isVisible() && dock("dockPlanes")->isVisible());
    QVERIFY(!dock("dockBottom")->isVisible());
    const int tall = window.centralWidget()->height();
    action("actLayoutInspect")->trigger();
    fits();
    QVERIFY(dock("dockTimeline")->isVisible() && dock("dockBottom")->isVisible());
    QVERIFY(dock("dockBottom")->y() > dock("dockTimeline")->y());
    QVERIFY(window.centralWidget()->height() < tall);
    QVERIFY(std::abs(dock("dockTimeline")->height() - 132) <= 12);
    QVERIFY(!dock("dockTimeline")->features().testFlag(QDockWidget::DockWidgetClosable));
    action("actLayoutPresent")->trigger();
    QTest::qWait(50);
    QVERIFY(!dock("dockTimeline")->isVisible());
    action("actLayoutInspect")->trigger();
    fits();
}

/// Some of 155 steps, neighbours and jumps; and with PLANEWRIGHT_TEST_LONG set all of them, in ranges that overlap.
void TimelineWindowTest::everyStepLooksTheSameBothWays_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::addColumn<int>("apart");
    QTest::newRow("some") << 3 << 155 << 31;
    if (!qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG"))
        return;
    constexpr int kRange = 31;
    for (int from = 0; from < 155; from += kRange)
        QTest::addRow("from step %d", from + 1) << from << from + kRange << 1;
}

void TimelineWindowTest::everyStepLooksTheSameBothWays()
{
    QFETCH(int, from);
    QFETCH(int, to);
    QFETCH(int, apart);
    constexpr int kSteps = 155;
    SimulatedScanner simulation = SessionOptions{}.simulation;
    simulation.settings.slices = kSteps;
    simulation.settings.tiltStep = degrees(160.0) / kSteps;
    shown_->controllers->scan.openRoom(simulation, QStringLiteral("sim:corridor?seed=7&speed=0"));
    QVERIFY(waitUntil([this] { return parts_->session.state() == SessionState::Review; }, kPatience));
    rest();
    QCOMPARE(newest(), kSteps);
    std::vector<int> places;
    for (int at = from; at < to; at += apart)
        places.insert(places.end(), {at, at + 1});
    if (places.back() != kSteps)
        places.push_back(kSteps);  // the forced last pass
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const auto pictureAt = [&](int at) {
        parts_->playhead.goTo(at);
        static_cast<void>(waitForRest(*parts_, kPatience));
        return parts_->window->view().picture({480, 300}, 1.0);
    };

    std::map<int, QImage> forward;
    for (const int at : places)
        forward[at] = pictureAt(at);
    std::reverse(places.begin(), places.end());
    for (const int at : places)
        QVERIFY2(pictureAt(at) == forward[at], qPrintable(QStringLiteral("step %1").arg(at + 1)));
    for (auto each = std::next(forward.begin()); each != forward.end(); ++each)
        QVERIFY(each->second != std::prev(each)->second || each->first - std::prev(each)->first == 1);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::TimelineWindowTest)
#include "timeline_window_test.moc"
