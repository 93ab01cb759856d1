// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <csignal>
#include <sys/resource.h>

#include <QApplication>
#include <QtTest>

#include "app/files/recording_file.h"
#include "app/window/exports.h"
#include "app/window/waiting.h"
#include "core/formats/sqlite_database.h"
#include "core/simulation/nodding_scanner.h"
#include "core/simulation/scenes.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"

namespace planewright {

/// Scans that are recorded from the window, and what it says when the disk does not want them.
class RecordingWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { useFixedLook(); }
    void init();
    void cleanup();
    void editsMadeWhileItScansAreInTheFile();
    void aFullDiskIsToldAndTheScanGoesOn();
    void aFolderThatTakesNothingIsToldAndTheScanGoesOn();
    void tooLittleSpaceIsToldBeforeItScans();
    void aRoomIsScannedAsItWasSetUp();
    void aProjectOpensAsItWasLeft();
    void aDamagedProjectIsPartialAndToldSo();
    void aProjectOfANewerVersionSaysWhyItIsReadOnly();
    void aScanThatLacksSlicesIsPartial_data();
    void aScanThatLacksSlicesIsPartial();
    void aCopyHoldsWhatWasMeasuredAndTheEdits();
    void aCopyOfAProjectHoldsAllOfIt();

private:
    void openWindow();
    void record(const QString& folder);
    Banner& banner() { return shown_->parts.window->banner(); }
    bool comesToReview();
    /// Records the corridor, changes its file with SQL, and opens that; its state then.
    void reopenChanged(const std::string& sql, SessionState state);
    QString chip() { return shown_->parts.window->view().overlay().stateText; }

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<ShownWindow> shown_;
};

void RecordingWindowTest::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    openWindow();
}

void RecordingWindowTest::openWindow()
{
    auto shown = ShownWindow::open(folder_->filePath("settings.ini"));
    QVERIFY2(shown, shown ? "" : shown.error().message.c_str());
    shown_ = std::move(*shown);
    shown_->parts.preferences.freeSpaceFloor = 0.0;
}

void RecordingWindowTest::cleanup()
{
    shown_.reset();
    folder_.reset();
}

void RecordingWindowTest::record(const QString& folder)
{
    shown_->parts.preferences.recordFolder = folder.toStdString();
    shown_->action("actRecord")->setChecked(true);
}

bool RecordingWindowTest::comesToReview()
{
    return waitUntil([this] { return shown_->parts.session.state() == SessionState::Review; }, kPatience);
}

void RecordingWindowTest::editsMadeWhileItScansAreInTheFile()
{
    record(folder_->path());
    WindowParts& parts = shown_->parts;
    shown_->controllers->scan.open("sim:corridor?seed=7&speed=0.5", true);
    QVERIFY(waitUntil([&] { return !parts.shown->planes.empty(); }, kPatience));
    const std::string file = parts.session.status().recording;

    parts.selection.select({parts.shown->planes.front().plane->id});
    shown_->action("actHide")->trigger();

    QCOMPARE(parts.session.state(), SessionState::Scanning);
    const auto meanwhile = loadRecordingFile(file);
    QVERIFY(meanwhile);
    QCOMPARE(meanwhile->notes->edits.size(), std::size_t(1));
    shown_->action("actFinish")->trigger();
    QVERIFY(comesToReview());
    shown_->action("actUndo")->trigger();
    const auto afterwards = loadRecordingFile(file);
    QVERIFY(afterwards);
    QVERIFY(!afterwards->damaged);
    QCOMPARE(afterwards->notes->edits.size(), std::size_t(1));
    QVERIFY(afterwards->notes->edits.front().undone);
}

/// A limit on file sizes makes every write beyond it fail, for root too.
void RecordingWindowTest::aFullDiskIsToldAndTheScanGoesOn()
{
    std::signal(SIGXFSZ, SIG_IGN);
    record(folder_->path());
    WindowParts& parts = shown_->parts;
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{256 * 1024, before.rlim_max};

    setrlimit(RLIMIT_FSIZE, &small);
    shown_->controllers->scan.open("sim:corridor?seed=7", true);
    const bool told =
        waitUntil([&] { return banner().isVisible() && parts.session.status().notOnDisk > 0; }, kPatience);
    const QString text = banner().text();
    const std::string file = parts.session.status().recording;
    const auto meanwhile = loadRecordingFile(file);
    const bool wentOn = waitUntil([&] { return parts.session.status().extracted == 137; }, kPatience);
    setrlimit(RLIMIT_FSIZE, &before);

    QVERIFY(told);
    QVERIFY2(text.contains("kept in memory"), qPrintable(text));
    QVERIFY(meanwhile);
    QVERIFY(!meanwhile->damaged);
    QVERIFY(meanwhile->recording.slices.size() < 137);
    QVERIFY(wentOn);
    QVERIFY(comesToReview());
    const auto afterwards = loadRecordingFile(file);
    QVERIFY(afterwards);
    QVERIFY(!afterwards->damaged);
    QCOMPARE(afterwards->recording.slices.size(), std::size_t(137));
}

void RecordingWindowTest::aFolderThatTakesNothingIsToldAndTheScanGoesOn()
{
    record("/proc/planewright");
    WindowParts& parts = shown_->parts;

    shown_->controllers->scan.open("sim:corridor?seed=7", true);

    QVERIFY(waitUntil([&] { return banner().isVisible(); }, kPatience));
    QVERIFY2(banner().text().contains("/proc/planewright"), qPrintable(banner().text()));
    QVERIFY(waitUntil([&] { return parts.session.status().extracted == 137; }, kPatience));
    shown_->action("actStopMotion")->trigger();
    QVERIFY(comesToReview());
    QCOMPARE(parts.session.map()->slices.size(), std::size_t(137));
}

void RecordingWindowTest::tooLittleSpaceIsToldBeforeItScans()
{
    record(folder_->path());
    shown_->parts.preferences.freeSpaceFloor = 1e9;

    shown_->controllers->scan.open("sim:corridor?seed=7&speed=0", true);

    QVERIFY(comesToReview());
    QVERIFY2(banner().isVisible() && banner().text().contains("is not recorded"), qPrintable(banner().text()));
    QVERIFY(shown_->parts.session.status().recording.empty());
    QVERIFY(QDir(folder_->path()).entryList({"*.pwscan"}).isEmpty());
}

void RecordingWindowTest::aRoomIsScannedAsItWasSetUp()
{
    SimulationSetup setup;
    setup.scene = "hall";
    setup.firstTilt = 20.0;
    setup.lastTilt = 60.0;
    setup.tiltStep = 4.0;
    setup.bearingStep = 1.0;
    setup.noise = "none";
    setup.speed = 0.0;

    shown_->controllers->scan.simulate(setup);

    QVERIFY(comesToReview());
    const auto slices = shown_->parts.session.measuredSlices();
    QCOMPARE(slices.size(), std::size_t(10));
    QCOMPARE(slices.front()->ranges.size(), std::size_t(181));
    const Recording expected = simulate(makeHall(1), *acquisitionOf(setup), *simulationNoise("none"), 1).recording;
    QVERIFY(std::ranges::equal(slices.back()->ranges, expected.slices.back().ranges, [](double a, double b) {
        constexpr double kRounding = 0.00051;  // a scanner gives millimetres
        return std::abs(a - b) < kRounding || (std::isnan(a) && std::isnan(b));
    }));
}

void RecordingWindowTest::aProjectOpensAsItWasLeft()
{
    record(folder_->path());
    QVERIFY(shown_->scanCorridor());
    const QString file = QString::fromStdString(shown_->parts.session.project()->path());
    shown_->parts.window->view().showNamed(NamedView::Top);
    const double heading = shown_->parts.window->view().camera().heading;
    const double elevation = shown_->parts.window->view().camera().elevation;
    shown_->action("actLayerClusters")->setChecked(false);
    const PlaneId plane = shown_->parts.shown->planes[2].plane->id;
    shown_->parts.selection.select({plane});
    shown_->controllers->kept.save();

    shown_.reset();
    openWindow();
    shown_->controllers->scan.open(file);
    QVERIFY(comesToReview());
    QVERIFY(waitForRest(shown_->parts, kPatience));

    QVERIFY(shown_->parts.selection.planes() == std::set<PlaneId>{plane});
    QVERIFY(!shown_->parts.layers[Layer::Clusters].visible);
    QVERIFY(std::abs(shown_->parts.window->view().camera().heading - heading) < 1e-6);
    QVERIFY(std::abs(shown_->parts.window->view().camera().elevation - elevation) < 1e-6);
}

void RecordingWindowTest::reopenChanged(const std::string& sql, SessionState state)
{
    record(folder_->path());
    QVERIFY(shown_->scanCorridor());
    const std::string file = shown_->parts.session.project()->path();
    shown_.reset();
    {
        auto database = SqlDatabase::open(file, SqlDatabase::Access::Write, ErrorCode::NotWritten);
        QVERIFY(database && database->run(sql.c_str()));
    }
    openWindow();
    shown_->controllers->scan.open(QString::fromStdString(file));
    QVERIFY(waitUntil([&] { return shown_->parts.session.state() == state; }, kPatience));
    QVERIFY(waitForRest(shown_->parts, kPatience));
}

void RecordingWindowTest::aDamagedProjectIsPartialAndToldSo()
{
    // Steps 0, 5, … 130.
    reopenChanged("UPDATE slice SET crc32 = crc32 + 1 WHERE step % 5 = 0 AND step < 135", SessionState::Review);

    QVERIFY2(chip().startsWith("◐ Partial 110/137, "), qPrintable(chip()));
    QVERIFY(banner().isVisible());
    QVERIFY2(banner().text().contains("27 of 137 slices were damaged and left out."), qPrintable(banner().text()));
    shown_->parts.window->showBottomPanel("measurePanel");
    QVERIFY(!shown_->parts.logPanel->isVisible());
    banner().findChild<QPushButton*>("bannerFirst")->click();
    QVERIFY(shown_->parts.logPanel->isVisible());
    QVERIFY(!banner().isVisible());
    const LogModel& log = shown_->parts.logModel;
    int named = 0;
    for (int row = 0; row < log.rowCount(); ++row)
        named += log.index(row, log.columnCount() - 1).data().toString().contains("crc32") ? 1 : 0;
    QCOMPARE(named, 27);
    // What is sound is opened without a word.
    shown_->controllers->scan.open("sim:empty?seed=1&speed=0", true);
    QVERIFY(comesToReview());
    QVERIFY(!banner().isVisible());
}

void RecordingWindowTest::aProjectOfANewerVersionSaysWhyItIsReadOnly()
{
    reopenChanged("PRAGMA user_version = 2", SessionState::ReadOnly);

    QVERIFY2(chip().startsWith("Read-only: newer version 137/137, "), qPrintable(chip()));
    QVERIFY(shown_->parts.window->view().overlay().locked);
    QVERIFY(banner().isVisible());
    QVERIFY2(banner().text().contains("newer version of the program"), qPrintable(banner().text()));
}

void RecordingWindowTest::aScanThatLacksSlicesIsPartial_data()
{
    const QString malformed = QStringLiteral(PLANEWRIGHT_SOURCE_DIR "/tests/core/formats/malformed/");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("chip");
    QTest::addColumn<bool>("isTold");
    QTest::newRow("steps 3 and 9") << malformed + "fine-equal-times-and-gap.csv"
                                   << "◐ Partial 2/10, 0 planes" << false;
    QTest::newRow("a row cut short") << malformed + "cut-in-a-number.csv"
                                     << "◐ Partial 1/?, 0 planes" << true;
    QTest::newRow("whole") << malformed + "fine-crlf.csv"
                           << "✔ Complete" << false;
}

void RecordingWindowTest::aScanThatLacksSlicesIsPartial()
{
    QFETCH(QString, file);
    QFETCH(bool, isTold);

    shown_->controllers->scan.open(file);

    QVERIFY(comesToReview());
    QVERIFY(waitForRest(shown_->parts, kPatience));
    QFETCH(QString, chip);
    QVERIFY2(this->chip().startsWith(chip), qPrintable(this->chip()));
    QCOMPARE(banner().isVisible(), isTold);
}

void RecordingWindowTest::aCopyHoldsWhatWasMeasuredAndTheEdits()
{
    QVERIFY(shown_->scanCorridor());
    WindowParts& parts = shown_->parts;
    QVERIFY(parts.edits.add({Edit::Kind::Rename, {parts.shown->planes.front().plane->id}, "North", true}));
    const QString file = folder_->filePath("copy.pwscan");

    const auto copy = copyOf(parts, file);
    QVERIFY2(copy, copy ? "" : copy.error().message.c_str());
    QVERIFY((*copy)());

    const auto read = loadRecordingFile(file.toStdString());
    QVERIFY(read);
    QCOMPARE(read->recording.slices.size(), std::size_t(137));
    QVERIFY(read->recording.slices[60].ranges == parts.session.measuredSlices()[60]->ranges);
    QCOMPARE(read->notes->edits.size(), std::size_t(1));
    QCOMPARE(read->notes->edits.front().edit.text, std::string("North"));
    QVERIFY(!read->notes->events.empty());
}

void RecordingWindowTest::aCopyOfAProjectHoldsAllOfIt()
{
    record(folder_->path());
    QVERIFY(shown_->scanCorridor());
    WindowParts& parts = shown_->parts;
    QVERIFY(parts.edits.add({Edit::Kind::Hide, {parts.shown->planes.front().plane->id}, {}, true}));
    const std::string original = parts.session.project()->path();
    const QString file = folder_->filePath("copy.pwscan");

    const auto copy = copyOf(parts, file);
    QVERIFY2(copy, copy ? "" : copy.error().message.c_str());
    QVERIFY((*copy)());

    const auto before = loadRecordingFile(original);
    const auto after = loadRecordingFile(file.toStdString());
    QVERIFY(before && after);
    QCOMPARE(after->recording.slices.size(), before->recording.slices.size());
    QCOMPARE(after->notes->edits.size(), std::size_t(1));
    QCOMPARE(after->notes->events.size(), before->notes->events.size());
    QCOMPARE(after->notes->scan.startedUtc, before->notes->scan.startedUtc);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::RecordingWindowTest)
#include "recording_window_test.moc"
