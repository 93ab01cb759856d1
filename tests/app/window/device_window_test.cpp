// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QtTest>

#include "app/window/waiting.h"
#include "tests/app/emulated_rig_process.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"

namespace planewright {

/// A laser and a tilt unit in the window, from their test to the planes.
class DeviceWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { useFixedLook(); }
    void init();
    void cleanup();
    void devicesAreTestedConnectedAndScannedWith();
    void aTestTellsWhatIsWrongAndWhatToDo();
    void stopMotionEndsAScanWithWhatThereIs();
    void stopMotionHoldsWhatATestMoves();
    void theHeadGoesToLevelAndStopMotionHoldsIt();
    void theHeadOfAConnectedScannerGoesToLevel_data();
    void theHeadOfAConnectedScannerGoesToLevel();
    void whatIsSetUpIsThereAfterTheNextStart();
    void aLaserByItsAddressNeedsAChosenTiltUnit();
    void aLaserByItsAddressTakesTheUnitAndThePlanOfTheForm();
    void aScanStaysWhereItsScannerDoesNotComeAgain();
    void theMenuDoesWhatTheButtonsDo();
    void whoHasAScannerIsShownTheForm();

private:
    /// What the devices say now.
    QString healthValue(const char* name) const
    {
        for (const HealthFact& fact : shown_->parts.session.health()) {
            if (fact.name == name)
                return QString::fromStdString(fact.value);
        }
        return {};
    }
    /// Takes back a stop of motion, as the banner offers it.
    void release() { shown_->parts.window->banner().findChild<QPushButton*>("bannerFirst")->click(); }
    template <class Widget>
    Widget* find(const char* name) const
    {
        return shown_->parts.sourcePanel->findChild<Widget*>(QLatin1String(name));
    }
    void choose(const QString& laser, const QString& tiltUnit);
    bool comesTo(SessionState state)
    {
        return waitUntil([&] { return shown_->parts.session.state() == state; }, kPatience);
    }

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<ShownWindow> shown_;
};

void DeviceWindowTest::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    auto shown = ShownWindow::open(folder_->filePath("settings.ini"));
    QVERIFY2(shown, shown ? "" : shown.error().message.c_str());
    shown_ = std::move(*shown);
}

void DeviceWindowTest::cleanup()
{
    shown_.reset();
    folder_.reset();
}

void DeviceWindowTest::choose(const QString& laser, const QString& tiltUnit)
{
    find<QComboBox>("sourceType")->setCurrentIndex(2);
    QVERIFY(waitUntil([&] { return find<QPushButton>("findDevices")->isEnabled(); }, kPatience));
    find<QComboBox>("laser")->setEditText(laser);
    find<QComboBox>("tiltUnit")->setEditText(tiltUnit);
    find<QDoubleSpinBox>("deviceFirstTilt")->setValue(70.0);
    find<QDoubleSpinBox>("deviceLastTilt")->setValue(110.0);
}

void DeviceWindowTest::devicesAreTestedConnectedAndScannedWith()
{
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    choose(rig.laser(), rig.tiltUnit());
    QVERIFY(find<QPushButton>("testDevices")->isEnabled());

    find<QPushButton>("testDevices")->click();
    QVERIFY(waitUntil([&] { return find<QLabel>("deviceChecks")->text().count(QChar(0x2714)) == 6; }, kPatience));
    QVERIFY(find<QLabel>("deviceChecks")->text().contains("UTM-30LX"));
    QVERIFY(waitUntil([&] { return find<QPushButton>("testDevices")->isEnabled(); }, kPatience));
    find<QPushButton>("openSource")->click();
    QVERIFY(comesTo(SessionState::Ready));
    QVERIFY(!find<QPushButton>("testDevices")->isEnabled());
    QVERIFY(find<QLabel>("deviceFacts")->text().contains("Temperature"));
    auto* health = shown_->parts.window->findChild<QLabel*>("stHealth");
    QVERIFY(health->isVisible());
    QVERIFY2(health->text().contains(QStringLiteral("scans/s, lost 0, corrupt 0, late 0, load ")),
             qPrintable(health->text()));
    QVERIFY(health->text().endsWith(QStringLiteral(" °C")));
    // The servo is asked how it is though no scan runs.
    const QString before = healthValue("angles");
    QVERIFY(!before.isEmpty());
    QVERIFY(waitUntil([&] { return healthValue("angles") != before; }, kPatience));
    QVERIFY(find<QLabel>("deviceFacts")->text().contains("angles/s"));
    // What is set up is told by what the laser says of itself: 200° of its 270° are 801 steps of 0.25°.
    find<QDoubleSpinBox>("deviceLastBearing")->setValue(200.0);
    QVERIFY2(find<QLabel>("scanSize")->text().startsWith("34 slices of 801 beams, 27,234 points, about 0."),
             qPrintable(find<QLabel>("scanSize")->text()));
    find<QDoubleSpinBox>("deviceLastBearing")->setValue(300.0);
    QVERIFY(!find<QPushButton>("openSource")->isEnabled());
    find<QDoubleSpinBox>("deviceLastBearing")->setValue(180.0);
    find<QComboBox>("sourceType")->setCurrentIndex(0);
    QTest::mouseClick(health, Qt::LeftButton);
    QCOMPARE(find<QComboBox>("sourceType")->currentIndex(), 2);
    shown_->action("actStart")->trigger();

    QVERIFY(comesTo(SessionState::Review));
    QVERIFY(shown_->parts.session.measuredSlices().size() >= 25);
    QVERIFY(!shown_->parts.session.map()->snapshot->planes.empty());
    QVERIFY(shown_->parts.session.status().source.starts_with("UTM-30LX"));
}

void DeviceWindowTest::aTestTellsWhatIsWrongAndWhatToDo()
{
    choose("tcp:127.0.0.1:1", "dynamixel:serial:/dev/no-such-port");

    find<QPushButton>("testDevices")->click();

    QVERIFY(waitUntil([&] { return find<QLabel>("deviceChecks")->text().contains(QChar(0x2718)); }, kPatience));
    const QString checks = find<QLabel>("deviceChecks")->text();
    QCOMPARE(checks.count(QChar(0x2714)), 1);  // nothing stands in the way of opening them
    QVERIFY(checks.contains("127.0.0.1:1"));
}

void DeviceWindowTest::stopMotionEndsAScanWithWhatThereIs()
{
    EmulatedRigProcess rig({"--laser", "tcp:0", "--board", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    choose(rig.laser(), rig.tiltUnit());
    find<QPushButton>("openSource")->click();
    QVERIFY(comesTo(SessionState::Ready));
    shown_->action("actStart")->trigger();
    QVERIFY(waitUntil([&] { return shown_->parts.session.status().acquired > 3; }, kPatience));

    shown_->action("actStopMotion")->trigger();

    QVERIFY(comesTo(SessionState::Review));
    QVERIFY(!shown_->parts.session.measuredSlices().empty());
}

void DeviceWindowTest::stopMotionHoldsWhatATestMoves()
{
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    choose(rig.laser(), rig.tiltUnit());
    find<QPushButton>("testDevices")->click();
    // It moves for half a second: 10° at 20° a second.
    const QString moving = QChar(0x25CC) + QStringLiteral(" 5°");
    QVERIFY(waitUntil([&] { return find<QLabel>("deviceChecks")->text().contains(moving); }, kPatience));

    shown_->action("actStopMotion")->trigger();

    QVERIFY(waitUntil([&] { return find<QLabel>("deviceChecks")->text().contains(QChar(0x2718)); }, kPatience));
    QVERIFY2(find<QLabel>("deviceChecks")->text().contains("stopped"),
             qPrintable(find<QLabel>("deviceChecks")->text()));
    QVERIFY(waitUntil([&] { return find<QPushButton>("testDevices")->isEnabled(); }, kPatience));
    // Nothing moves before it is released.
    const QString checks = find<QLabel>("deviceChecks")->text();
    find<QPushButton>("testDevices")->click();
    QCOMPARE(find<QLabel>("deviceChecks")->text(), checks);
    QVERIFY(find<QPushButton>("testDevices")->isEnabled());
    QVERIFY(shown_->parts.window->banner().text().contains("Motion was stopped"));
    release();
    find<QPushButton>("testDevices")->click();
    QVERIFY(!find<QPushButton>("testDevices")->isEnabled());
    shown_->action("actStopMotion")->trigger();
}

void DeviceWindowTest::theHeadOfAConnectedScannerGoesToLevel_data()
{
    QTest::addColumn<QString>("tilt");
    QTest::newRow("servo") << "--tilt";
    QTest::newRow("board") << "--board";
}

void DeviceWindowTest::theHeadOfAConnectedScannerGoesToLevel()
{
    QFETCH(QString, tilt);
    EmulatedRigProcess rig({"--laser", "tcp:0", tilt, "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    QVERIFY(!shown_->action("actHome")->isEnabled());
    // Its middle is said to look to 80°: level is 10° away, half a second.
    choose(rig.laser(), rig.tiltUnit() + "?zero=80");
    find<QPushButton>("openSource")->click();
    QVERIFY(comesTo(SessionState::Ready));
    QStringList said;
    connect(&shown_->parts.session, &ScanSession::logLine, this,
            [&](LogLevel, const QString&, const QString& text) { said += text; });

    shown_->action("actStopMotion")->trigger();
    shown_->action("actHome")->trigger();
    QCOMPARE(shown_->parts.session.state(), SessionState::Ready);
    QVERIFY(shown_->parts.window->banner().text().contains("Motion was stopped"));
    release();
    shown_->action("actHome")->trigger();

    QVERIFY(shown_->parts.session.goesHome());
    QVERIFY(!shown_->action("actHome")->isEnabled());
    QVERIFY(comesTo(SessionState::Ready));
    QVERIFY2(said.join(QChar(10)).contains(QRegularExpression("held at (89\\.[5-9]|90|90\\.[1-5])°")),
             qPrintable(said.join('\n')));
    QVERIFY(find<QPushButton>("homeDevices")->isEnabled());
    // The scan begins as ever.
    shown_->action("actStart")->trigger();
    QVERIFY(waitUntil([&] { return shown_->parts.session.status().acquired > 0; }, kPatience));
    shown_->action("actStopMotion")->trigger();
    QVERIFY(comesTo(SessionState::Review));
}

void DeviceWindowTest::theHeadGoesToLevelAndStopMotionHoldsIt()
{
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    // As if the servo's middle looked far down: level is 80° away, four seconds.
    choose(rig.laser(), rig.tiltUnit() + "?zero=10");
    find<QPushButton>("homeDevices")->click();
    const QString moving = QChar(0x25CC) + QStringLiteral(" Move to level");
    QVERIFY(waitUntil([&] { return find<QLabel>("deviceChecks")->text().contains(moving); }, kPatience));
    QTest::qWait(500);

    shown_->action("actStopMotion")->trigger();
    QVERIFY(waitUntil([&] { return find<QLabel>("deviceChecks")->text().contains(QChar(0x2718)); }, kPatience));
    QVERIFY(waitUntil([&] { return find<QPushButton>("homeDevices")->isEnabled(); }, kPatience));
    find<QPushButton>("homeDevices")->click();
    QVERIFY(find<QLabel>("deviceChecks")->text().contains(QChar(0x2718)));  // not before it is released
    release();
    find<QPushButton>("homeDevices")->click();

    QVERIFY(waitUntil([&] { return find<QLabel>("deviceChecks")->text().contains(QChar(0x2714)); }, kPatience));
    QVERIFY2(find<QLabel>("deviceChecks")->text().contains(QRegularExpression("held at (89\\.[5-9]|90|90\\.[1-5])°")),
             qPrintable(find<QLabel>("deviceChecks")->text()));
}

void DeviceWindowTest::whatIsSetUpIsThereAfterTheNextStart()
{
    choose("usb:00903971", "dynamixel:usb:?id=2");
    find<QDoubleSpinBox>("deviceAxisOffset")->setValue(0.081);
    shown_.reset();

    auto again = ShownWindow::open(folder_->filePath("settings.ini"));
    QVERIFY2(again, again ? "" : again.error().message.c_str());
    shown_ = std::move(*again);

    QCOMPARE(find<QComboBox>("laser")->currentText(), QString("usb:00903971"));
    QCOMPARE(find<QComboBox>("tiltUnit")->currentText(), QString("dynamixel:usb:?id=2"));
    QCOMPARE(find<QDoubleSpinBox>("deviceFirstTilt")->value(), 70.0);
    QCOMPARE(find<QDoubleSpinBox>("deviceAxisOffset")->value(), 0.081);
}

void DeviceWindowTest::whoHasAScannerIsShownTheForm()
{
    QVERIFY(shown_->parts.window->showsWelcome());
    QVERIFY(!shown_->parts.window->findChild<QLabel*>("stHealth")->isVisible());
    QVERIFY(!find<QComboBox>("laser")->isVisible());

    shown_->parts.window->findChild<QPushButton*>("welcomeConnect")->click();

    QVERIFY(find<QComboBox>("laser")->isVisible());
}

void DeviceWindowTest::aLaserByItsAddressNeedsAChosenTiltUnit()
{
    shown_->controllers->scan.open("tcp:127.0.0.1:1", true);

    QVERIFY(shown_->parts.fault);
    QVERIFY2(shown_->parts.fault->message.find("choose it in Setup, Source, Device") != std::string::npos,
             shown_->parts.fault->message.c_str());
    QCOMPARE(find<QComboBox>("laser")->currentText(), QString("tcp:127.0.0.1:1"));
    QVERIFY(find<QComboBox>("tiltUnit")->isVisible());
    QCOMPARE(shown_->parts.session.state(), SessionState::Empty);
}

void DeviceWindowTest::aLaserByItsAddressTakesTheUnitAndThePlanOfTheForm()
{
    EmulatedRigProcess rig({"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig.isServing(), rig.error().constData());
    choose("usb:", rig.tiltUnit());

    shown_->controllers->scan.open(rig.laser(), true);

    QVERIFY(comesTo(SessionState::Ready));
    QCOMPARE(shown_->parts.session.status().plannedSteps, 34);  // whole steps of 1.16° in 40°
    QCOMPARE(find<QComboBox>("laser")->currentText(), rig.laser());
    QVERIFY(!find<QLabel>("notInUse")->isVisible());
    find<QDoubleSpinBox>("deviceLastTilt")->setValue(100.0);
    QVERIFY(find<QLabel>("notInUse")->isVisible());
    shown_->action("actConnect")->trigger();
    QVERIFY(waitUntil([&] { return shown_->parts.session.status().plannedSteps == 25; }, kPatience));
    QVERIFY(!find<QLabel>("notInUse")->isVisible());
}

void DeviceWindowTest::aScanStaysWhereItsScannerDoesNotComeAgain()
{
    auto rig = std::make_unique<EmulatedRigProcess>(QStringList{"--laser", "tcp:0", "--tilt", "pty"});
    QVERIFY2(rig->isServing(), rig->error().constData());
    choose(rig->laser(), rig->tiltUnit());
    find<QPushButton>("openSource")->click();
    QVERIFY(comesTo(SessionState::Ready));
    shown_->action("actStart")->trigger();
    QVERIFY(comesTo(SessionState::Review));
    const auto snapshot = shown_->parts.session.map()->snapshot;
    const std::size_t slices = shown_->parts.session.measuredSlices().size();
    QVERIFY(slices > 0);
    rig.reset();

    shown_->action("actConnect")->trigger();

    QVERIFY(waitUntil([&] { return shown_->parts.fault.has_value(); }, kPatience));
    QVERIFY(comesTo(SessionState::Review));
    QCOMPARE(shown_->parts.session.map()->snapshot, snapshot);
    QCOMPARE(shown_->parts.session.measuredSlices().size(), slices);
    QVERIFY(!shown_->action("actStart")->isEnabled());
    QVERIFY(shown_->action("actRerun")->isEnabled());
    QVERIFY(shown_->parts.session.health().empty());
}

void DeviceWindowTest::theMenuDoesWhatTheButtonsDo()
{
    QCOMPARE(shown_->action("actConnect")->shortcut(), QKeySequence("Ctrl+K"));
    QVERIFY(!shown_->action("actRecover")->isEnabled());
    choose("tcp:127.0.0.1:1", "dynamixel:serial:/dev/no-such-port");
    find<QComboBox>("sourceType")->setCurrentIndex(0);

    shown_->action("actTestDevices")->trigger();

    QVERIFY(shown_->parts.isAtWork());
    QCOMPARE(find<QComboBox>("sourceType")->currentIndex(), 2);
    QVERIFY(waitUntil([&] { return !shown_->parts.isAtWork(); }, kPatience));
    QVERIFY(find<QLabel>("deviceChecks")->text().contains(QChar(0x2718)));
    shown_->action("actFindDevices")->trigger();
    QVERIFY(shown_->parts.isAtWork());
    QVERIFY(!shown_->action("actTestDevices")->isEnabled());
    QVERIFY(waitUntil([&] { return shown_->action("actTestDevices")->isEnabled(); }, kPatience));
    shown_->action("actStopMotion")->trigger();
    QVERIFY(shown_->action("actRecover")->isEnabled());
    shown_->action("actRecover")->trigger();
    QVERIFY(!shown_->parts.session.isMotionStopped());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::DeviceWindowTest)
#include "device_window_test.moc"
