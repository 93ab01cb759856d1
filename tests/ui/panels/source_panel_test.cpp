// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/source_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyleOptionComboBox>
#include <QTemporaryFile>
#include <QtTest>

#include "core/simulation/scene.h"
#include "tests/test_program.h"

namespace planewright {

class SourcePanelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void itOffersWhatCanBeConnected();
    void theSizeOfTheScanIsComputed();
    void aScanThatIsNoneSaysWhatToGive();
    void everyRoomAndNoiseOfTheSimulatorIsOffered();
    void aSimulationIsRequestedAsItIsSetUp();
    void numbersAreReadInANarrowDock_data();
    void numbersAreReadInANarrowDock();
    void aSetupIsShownAsItWasGiven();
    void aFileThatIsNotThereIsNotOpened();
    void aRecordingIsOpenedOrPlayed();
    void recentRecordingsAreChosenWithTheKeyboard();

private:
    template <class Widget>
    Widget* find(const char* name) const
    {
        return panel_->findChild<Widget*>(QLatin1String(name));
    }

    std::unique_ptr<SourcePanel> panel_;
};

void SourcePanelTest::init()
{
    panel_ = std::make_unique<SourcePanel>();
    panel_->resize(300, 600);
    panel_->show();
}

void SourcePanelTest::itOffersWhatCanBeConnected()
{
    QCOMPARE(find<QComboBox>("sourceType")->count(), 3);
    QCOMPARE(find<QComboBox>("sourceType")->itemText(0), QStringLiteral("Simulator"));
    QCOMPARE(find<QComboBox>("sourceType")->itemText(1), QStringLiteral("Recording"));
    QCOMPARE(find<QComboBox>("sourceType")->itemText(2), QStringLiteral("Device"));
}

void SourcePanelTest::theSizeOfTheScanIsComputed()
{
    QCOMPARE(find<QLabel>("scanSize")->text(), QStringLiteral("137 steps × 721 points = 98,777 points, about 3.4 s"));

    find<QDoubleSpinBox>("tiltStep")->setValue(16.0);  // 160 / 16 = 10
    find<QDoubleSpinBox>("bearingStep")->setValue(1.0);

    QCOMPARE(find<QLabel>("scanSize")->text(), QStringLiteral("10 steps × 181 points = 1,810 points, about 0.2 s"));
}

void SourcePanelTest::aScanThatIsNoneSaysWhatToGive()
{
    find<QDoubleSpinBox>("tiltStep")->setValue(-1.0);

    QVERIFY(find<QLabel>("problem")->isVisible());
    QVERIFY(find<QLabel>("problem")->text().startsWith("Tilt: give a step"));
    QVERIFY(!find<QLabel>("scanSize")->isVisible());
    QVERIFY(!find<QPushButton>("openSource")->isEnabled());
}

void SourcePanelTest::everyRoomAndNoiseOfTheSimulatorIsOffered()
{
    const auto* scenes = find<QComboBox>("scene");
    QCOMPARE(static_cast<std::size_t>(scenes->count()), sceneNames().size());
    for (int i = 0; i < scenes->count(); ++i)
        QVERIFY(makeScene(scenes->itemData(i).toString().toStdString(), 1));
    const auto* noises = find<QComboBox>("noise");
    QCOMPARE(static_cast<std::size_t>(noises->count()), simulationNoiseNames().size());
    for (int i = 0; i < noises->count(); ++i)
        QVERIFY(simulationNoise(noises->itemData(i).toString().toStdString()));
}

void SourcePanelTest::aSimulationIsRequestedAsItIsSetUp()
{
    QSignalSpy requested(panel_.get(), &SourcePanel::simulationRequested);
    find<QComboBox>("scene")->setCurrentText("Office");
    find<QLineEdit>("seed")->setText("42");
    find<QComboBox>("speed")->setCurrentText("As fast as possible");
    find<QDoubleSpinBox>("lastTilt")->setValue(90.5);

    find<QPushButton>("openSource")->click();

    QCOMPARE(requested.size(), 1);
    const auto setup = requested[0][0].value<SimulationSetup>();
    QVERIFY(setup == (SimulationSetup{.scene = "office", .seed = 42, .lastTilt = 90.5, .speed = 0.0}));
}

void SourcePanelTest::numbersAreReadInANarrowDock_data()
{
    QTest::addColumn<int>("width");
    for (const int width : {300, 285, 240})
        QTest::addRow("%d", width) << width;
}

void SourcePanelTest::numbersAreReadInANarrowDock()
{
    QFETCH(int, width);
    panel_->resize(width, 600);
    QTest::qWait(0);

    auto* noise = find<QComboBox>("noise");
    for (int i = 0; i < noise->count(); ++i) {
        noise->setCurrentIndex(i);
        QStyleOptionComboBox option;
        option.initFrom(noise);
        const QRect text =
            noise->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, noise);
        const int needed = noise->fontMetrics().horizontalAdvance(noise->currentText());
        QVERIFY2(
            text.width() >= needed,
            qPrintable(QStringLiteral("%1: %2 of %3 pixels").arg(noise->currentText()).arg(text.width()).arg(needed)));
    }
    for (const char* name : {"firstTilt", "lastTilt", "tiltStep", "firstBearing", "lastBearing", "bearingStep"}) {
        auto* box = find<QDoubleSpinBox>(name);
        box->setValue(box->minimum());
        const auto* line = box->findChild<QLineEdit*>();
        QVERIFY2(line->width() >= line->fontMetrics().horizontalAdvance(line->text()), name);
    }
    // Nothing reaches beyond the panel, whose contents scroll up and down only: it does not become too narrow.
    QVERIFY(panel_->width() <= std::max(width, 285));
    for (const QWidget* field : panel_->findChildren<QWidget*>()) {
        const bool isField = qobject_cast<const QComboBox*>(field) != nullptr ||
                             qobject_cast<const QDoubleSpinBox*>(field) != nullptr ||
                             qobject_cast<const QPushButton*>(field) != nullptr;
        if (isField && field->isVisible())
            QVERIFY2(field->mapTo(panel_.get(), QPoint(field->width(), 0)).x() <= panel_->width(),
                     qPrintable(field->objectName()));
    }
}

void SourcePanelTest::aSetupIsShownAsItWasGiven()
{
    const SimulationSetup setup{.scene = "hall",
                                .seed = 7,
                                .noise = "P",
                                .firstTilt = 170.0,
                                .lastTilt = 10.0,
                                .tiltStep = -0.58,
                                .firstBearing = -90.0,
                                .lastBearing = 90.0,
                                .bearingStep = 0.125,
                                .speed = 3.5};

    panel_->showSimulation(setup);

    QVERIFY(panel_->simulation() == setup);
}

void SourcePanelTest::aFileThatIsNotThereIsNotOpened()
{
    panel_->showRecording("");
    QVERIFY(!find<QPushButton>("openSource")->isEnabled());
    QVERIFY(!find<QLabel>("problem")->isVisible());

    find<QLineEdit>("recordingFile")->setText("/no/such/file.csv");

    QCOMPARE(find<QLabel>("problem")->text(), QStringLiteral("There is no file /no/such/file.csv."));
    QVERIFY(!find<QPushButton>("openSource")->isEnabled());
}

void SourcePanelTest::aRecordingIsOpenedOrPlayed()
{
    QTemporaryFile file;
    QVERIFY(file.open());
    QSignalSpy opened(panel_.get(), &SourcePanel::openRequested);
    panel_->showRecording(file.fileName());

    find<QPushButton>("openSource")->click();
    find<QCheckBox>("playRecording")->setChecked(true);
    find<QComboBox>("playSpeed")->setCurrentText("2 ×");
    find<QPushButton>("openSource")->click();

    QCOMPARE(opened.value(0).value(0).toString(), file.fileName());
    QCOMPARE(opened.value(1).value(0).toString(), "replay:" + file.fileName() + "?speed=2");
}

void SourcePanelTest::recentRecordingsAreChosenWithTheKeyboard()
{
    panel_->showRecording("");
    panel_->setRecentFiles({"/data/one.csv", "/data/two.pwscan"});
    auto* recent = find<QListWidget>("recentRecordings");
    QCOMPARE(recent->item(1)->text(), QStringLiteral("two.pwscan"));

    recent->setFocus();
    recent->setCurrentRow(0);
    QTest::keyClick(recent, Qt::Key_Down);

    QCOMPARE(find<QLineEdit>("recordingFile")->text(), QStringLiteral("/data/two.pwscan"));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::SourcePanelTest)
#include "source_panel_test.moc"
