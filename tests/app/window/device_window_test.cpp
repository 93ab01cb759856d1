// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include "app/window/waiting.h"
#include "tests/app/emulated_rig_process.h"
#include "tests/app/window/shown_window.h"

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

private:
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

}  // namespace planewright

QTEST_MAIN(planewright::DeviceWindowTest)
#include "device_window_test.moc"
