// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/device_form.h"

#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/panels/source_panel.h"

namespace planewright {

class DeviceFormTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void theOnlyDeviceThatThereIsIsChosen();
    void whatWasTypedStaysWhenSomethingIsPluggedIn();
    void eachFieldOffersWhatItMayBe();
    void whatStandsInTheWayIsToldWithItsCure();
    void theCureCanBeCopied();
    void aSearchThatCannotFindIsTold();
    void aTestNeedsBothDevices();
    void levelNeedsATiltUnit();
    void limitsThatMakeNoSenseMoveNothing();
    void aUnitThatWaitsForAPersonIsReleasedByOne();
    void anglesBeyondTheLimitsAreTold();
    void limitsAreFoldedAway();
    void checksHaveASignAndWords();
    void factsStandOutWhereTheyAreTrouble();
    void theSetupIsGivenAsItWasTyped();
    void steppingTakesLonger();

private:
    template <class Widget>
    Widget* find(const char* name) const
    {
        return panel_->findChild<Widget*>(QLatin1String(name));
    }
    DeviceForm& form() { return panel_->devices(); }

    std::unique_ptr<SourcePanel> panel_;
};

namespace {

const DeviceChoice kLaser{"usb:00903971", "UTM-30LX, number 00903971", "", true, false};
const DeviceChoice kServo{"dynamixel:usb:AB12", "USB2Dynamixel", "", false, true};

}  // namespace

void DeviceFormTest::init()
{
    panel_ = std::make_unique<SourcePanel>();
    panel_->resize(300, 800);
    find<QComboBox>("sourceType")->setCurrentIndex(2);
    panel_->show();
}

void DeviceFormTest::theOnlyDeviceThatThereIsIsChosen()
{
    form().setChoices({kLaser, kServo});

    QCOMPARE(form().setup().laser, std::string("usb:00903971"));
    QCOMPARE(form().setup().tiltUnit, std::string("dynamixel:usb:AB12"));
    QVERIFY(find<QPushButton>("openSource")->isEnabled());
    QCOMPARE(find<QPushButton>("openSource")->text(), QString("Connect"));
}

void DeviceFormTest::whatWasTypedStaysWhenSomethingIsPluggedIn()
{
    find<QComboBox>("laser")->setEditText("tcp:192.168.0.10:10940");

    form().setChoices({kLaser, kServo});

    QCOMPARE(form().setup().laser, std::string("tcp:192.168.0.10:10940"));
}

void DeviceFormTest::eachFieldOffersWhatItMayBe()
{
    form().setChoices({kLaser, kServo, {"usb:00903972", "another", "", true, false}});

    QCOMPARE(find<QComboBox>("laser")->count(), 2);
    QCOMPARE(find<QComboBox>("tiltUnit")->count(), 1);
    QVERIFY(form().setup().laser.empty());  // of two none is chosen for anybody
    emit find<QComboBox>("laser")->activated(1);
    QCOMPARE(form().setup().laser, std::string("usb:00903972"));
}

void DeviceFormTest::whatStandsInTheWayIsToldWithItsCure()
{
    DeviceChoice denied = kLaser;
    denied.problem = "you may not use it yet; once, run: sudo something";

    form().setChoices({denied, kServo});

    const auto labels = form().findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->text().contains("sudo something");
    }));
}

void DeviceFormTest::theCureCanBeCopied()
{
    DeviceChoice denied = kServo;
    denied.problem = "usb 1-3: you may not use it yet; once, run: sudo something";
    denied.cure = "sudo something";
    form().setChoices({kLaser, kServo});
    QVERIFY(!find<QPushButton>("copyCure")->isVisible());

    form().setChoices({kLaser, denied});

    QVERIFY(find<QPushButton>("copyCure")->isVisible());
    find<QPushButton>("copyCure")->click();
    QCOMPARE(QGuiApplication::clipboard()->text(), QString("sudo something"));
    denied.cure.clear();  // nothing that a command cures
    form().setChoices({kLaser, denied});
    QVERIFY(!find<QPushButton>("copyCure")->isVisible());
}

void DeviceFormTest::aSearchThatCannotFindIsTold()
{
    form().setSearchProblem("USB cannot be used here");

    const auto labels = form().findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->text() == "USB cannot be used here";
    }));
}

void DeviceFormTest::levelNeedsATiltUnit()
{
    QSignalSpy requested(&form(), &DeviceForm::homeRequested);
    QVERIFY(!find<QPushButton>("homeDevices")->isEnabled());
    form().setChoices({kServo});

    find<QPushButton>("homeDevices")->click();
    form().setTestable(false);

    QCOMPARE(requested.count(), 1);
    QVERIFY(!find<QPushButton>("homeDevices")->isEnabled());
    form().setConnectedHead(true);
    QVERIFY(find<QPushButton>("homeDevices")->isEnabled());
}

void DeviceFormTest::aUnitThatWaitsForAPersonIsReleasedByOne()
{
    QSignalSpy requested(&form(), &DeviceForm::recoverRequested);
    form().setChoices({kServo});
    QVERIFY(!find<QPushButton>("recoverDevices")->isVisible());

    form().setRecoverable(true);

    QVERIFY(find<QPushButton>("recoverDevices")->isVisible());
    QVERIFY(find<QLabel>("recoverySteps")->isVisible());
    find<QPushButton>("recoverDevices")->click();
    QCOMPARE(requested.count(), 1);
    form().setRecoverable(false);
    QVERIFY(!find<QPushButton>("recoverDevices")->isVisible());
}

void DeviceFormTest::anglesBeyondTheLimitsAreTold()
{
    form().setChoices({kLaser, kServo});
    QVERIFY(form().problem().isEmpty());

    find<QDoubleSpinBox>("deviceLastTilt")->setValue(181.0);
    QVERIFY(form().problem().contains(QStringLiteral("from 0° to 180°")));
    QVERIFY(!find<QPushButton>("openSource")->isEnabled());
    find<QDoubleSpinBox>("deviceHighest")->setValue(190.0);
    QVERIFY(form().problem().isEmpty());
    find<QDoubleSpinBox>("deviceLowest")->setValue(200.0);
    QVERIFY(form().problem().contains("below the highest"));
    find<QDoubleSpinBox>("deviceLowest")->setValue(20.0);
    QVERIFY(form().problem().contains(QStringLiteral("from 20° to 190°")));
    // Limits in the address are its own matter.
    find<QComboBox>("tiltUnit")->setEditText("dynamixel:usb:AB12?lowest=0");
    QVERIFY(form().problem().isEmpty());
}

void DeviceFormTest::limitsAreFoldedAway()
{
    QVERIFY(!find<QDoubleSpinBox>("deviceFastest")->isVisible());

    find<QToolButton>("deviceDetails")->click();

    QVERIFY(find<QDoubleSpinBox>("deviceFastest")->isVisible());
}

void DeviceFormTest::aTestNeedsBothDevices()
{
    QVERIFY(!find<QPushButton>("testDevices")->isEnabled());
    QVERIFY(!find<QPushButton>("openSource")->isEnabled());
    form().setChoices({kLaser, kServo});
    QVERIFY(find<QPushButton>("testDevices")->isEnabled());

    form().setTestable(false);

    QVERIFY(!find<QPushButton>("testDevices")->isEnabled());
    QVERIFY(!find<QPushButton>("findDevices")->isEnabled());
}

void DeviceFormTest::checksHaveASignAndWords()
{
    using State = DeviceCheck::State;
    form().setChecks({{"Permission", State::Passed, ""},
                      {"Laser answers", State::Failed, "plug <it> in"},
                      {"One slice", State::Waiting, ""}});

    const QString text = find<QLabel>("deviceChecks")->text();
    QVERIFY(text.contains(QStringLiteral("✔ Permission")));
    QVERIFY(text.contains(QStringLiteral("✘ Laser answers</b>: plug &lt;it&gt; in")));
    QVERIFY(text.contains(QStringLiteral("○ One slice")));
    QVERIFY(find<QLabel>("deviceChecks")->isVisible());
    form().setChecks({});
    QVERIFY(!find<QLabel>("deviceChecks")->isVisible());
}

void DeviceFormTest::factsStandOutWhereTheyAreTrouble()
{
    form().setFacts(
        {{"", "the servo is too warm", true}, {"Temperature", "41 °C", false}, {"angles", "9, lost 2", true}});

    const QString text = find<QLabel>("deviceFacts")->text();
    QVERIFY(text.contains(QStringLiteral("<td>Temperature</td><td>41 °C</td>")));
    QVERIFY(text.contains(QStringLiteral("<b>▲ the servo is too warm</b>")));
    QVERIFY(text.contains(QStringLiteral("<td><b>▲ angles</b></td><td><b>9, lost 2</b></td>")));
    form().setFacts({});
    QVERIFY(!find<QLabel>("deviceFacts")->isVisible());
}

void DeviceFormTest::theSetupIsGivenAsItWasTyped()
{
    QSignalSpy requested(panel_.get(), &SourcePanel::devicesRequested);
    const DeviceSetup setup{"usb:", "board:usb:", true, 20.0,  120.0, 2.5,  10.0,  170.0,
                            4,      30.0,         45.0, -10.0, 150.0, 60.0, 0.081, "/tmp/dialogues"};
    panel_->showDevices(setup);

    find<QPushButton>("openSource")->click();

    QCOMPARE(requested.count(), 1);
    QVERIFY(requested.at(0).at(0).value<DeviceSetup>() == setup);
    // A long address shows its beginning, and all of it when somebody points at it.
    QCOMPARE(find<QComboBox>("tiltUnit")->lineEdit()->cursorPosition(), 0);
    QCOMPARE(find<QComboBox>("tiltUnit")->toolTip(), QString("board:usb:"));
}

void DeviceFormTest::steppingTakesLonger()
{
    QCOMPARE(find<QLabel>("scanSize")->text(), QStringLiteral("137 steps × 721 points = 98,777 points, about 3.4 s"));

    find<QComboBox>("scanMode")->setCurrentIndex(1);

    QCOMPARE(find<QLabel>("scanSize")->text(), QStringLiteral("137 steps × 721 points = 98,777 points, about 10.3 s"));
}

void DeviceFormTest::limitsThatMakeNoSenseMoveNothing()
{
    form().setChoices({kServo});
    QVERIFY(form().canGoHome());

    find<QDoubleSpinBox>("deviceHighest")->setValue(50.0);
    find<QDoubleSpinBox>("deviceLowest")->setValue(100.0);

    QVERIFY(!form().canGoHome());
    QVERIFY(!find<QPushButton>("homeDevices")->isEnabled());
    const auto labels = panel_->findChildren<QLabel*>("problem");
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->text().contains("lowest tilt below the highest");
    }));
    // A head that is connected has the limits that it was connected with.
    form().setConnectedHead(true);
    QVERIFY(form().canGoHome());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::DeviceFormTest)
#include "device_form_test.moc"
