// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/parameters_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/panels/parameter_field.h"

namespace planewright {

class ParametersPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void everyParameterHasAFieldWithHelp();
    void whatIsTypedIsTakenOverWhenTheFieldIsLeft();
    void whatIsNotAllowedSaysSoBelowAndStays();
    void whatIsBeingWrittenOutlivesChangesOfOthers();
    void aChangedParameterHasAnArrowBack();
    void aPresetIsChosenFromTheBox();
    void switchesAndChoicesAreTakenAtOnce();
    void parametersAreSavedAsAPreset();
    void aPresetThatCouldNotBeKeptSaysWhy();
    void aParameterCanBeShownByItsKey();
    void parametersFromElsewhereAreShown();
    void whatCannotChangeDuringAScanIsGreyedOut();

private:
    ParameterField* field(const char* key) const { return panel_->findChild<ParameterField*>(key); }
    QLineEdit* edit(const char* key) const { return field(key)->findChild<QLineEdit*>("field"); }
    void show();

    std::unique_ptr<ParameterModel> model_;
    std::unique_ptr<ParametersPanel> panel_;
};

void ParametersPanelTest::init()
{
    panel_.reset();
    model_ = std::make_unique<ParameterModel>();
    panel_ = std::make_unique<ParametersPanel>(*model_);
    panel_->resize(300, 700);
}

void ParametersPanelTest::show()
{
    panel_->show();
    panel_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(panel_.get()));
}

void ParametersPanelTest::everyParameterHasAFieldWithHelp()
{
    QCOMPARE(static_cast<std::size_t>(panel_->findChildren<ParameterField*>().size()), parameterRows().size());
    for (const ParameterField* parameter : panel_->findChildren<ParameterField*>()) {
        const auto* control = parameter->findChild<QWidget*>("field");
        QVERIFY(!control->accessibleName().isEmpty());
        QVERIFY(!control->accessibleDescription().isEmpty());
        QVERIFY(!parameter->toolTip().isEmpty());
    }
}

void ParametersPanelTest::whatIsTypedIsTakenOverWhenTheFieldIsLeft()
{
    show();
    QSignalSpy changed(panel_.get(), &ParametersPanel::parametersChanged);
    panel_->showParameter("segments.split-distance");
    edit("segments.split-distance")->selectAll();

    QTest::keyClicks(edit("segments.split-distance"), "0.025");
    QCOMPARE(changed.size(), 0);
    QTest::keyClick(edit("segments.split-distance"), Qt::Key_Tab);

    QCOMPARE(changed.size(), 1);
    QCOMPARE(model_->parameters().segments.splitDistance, 0.025);
}

void ParametersPanelTest::whatIsNotAllowedSaysSoBelowAndStays()
{
    show();
    panel_->showParameter("segments.split-distance");
    edit("segments.split-distance")->selectAll();

    QTest::keyClicks(edit("segments.split-distance"), "9");
    QTest::keyClick(edit("segments.split-distance"), Qt::Key_Return);

    QCOMPARE(field("segments.split-distance")->problem(), QStringLiteral("Give a number from 0 to 0.5 m."));
    QCOMPARE(edit("segments.split-distance")->text(), QStringLiteral("9"));
    QCOMPARE(model_->parameters().segments.splitDistance, 0.01);  // of the preset "precise"
}

void ParametersPanelTest::whatIsBeingWrittenOutlivesChangesOfOthers()
{
    show();
    panel_->showParameter("segments.split-distance");
    edit("segments.split-distance")->selectAll();
    QTest::keyClicks(edit("segments.split-distance"), "0.2");

    model_->setText("planes.flatness", "0.1");
    QCOMPARE(edit("segments.split-distance")->text(), QStringLiteral("0.2"));
    QTest::keyClicks(edit("segments.split-distance"), "x");
    QTest::keyClick(edit("segments.split-distance"), Qt::Key_Return);
    model_->setText("planes.flatness", "0.2");
    QCOMPARE(edit("segments.split-distance")->text(), QStringLiteral("0.2x"));
    QVERIFY(!field("segments.split-distance")->problem().isEmpty());
    model_->setPreset("paper");

    QCOMPARE(edit("segments.split-distance")->text(), QStringLiteral("0.03"));
    QCOMPARE(field("segments.split-distance")->problem(), QString());
}

void ParametersPanelTest::aChangedParameterHasAnArrowBack()
{
    show();
    panel_->showParameter("planes.flatness");
    auto* arrow = field("planes.flatness")->findChild<QToolButton*>("reset");
    auto* all = panel_->findChild<QPushButton*>("resetAll");
    QVERIFY(!arrow->isVisible());
    QVERIFY(!all->isEnabled());

    model_->setText("planes.flatness", "0.1");
    QVERIFY(arrow->isVisible());
    QVERIFY(all->isEnabled());
    arrow->click();

    QCOMPARE(edit("planes.flatness")->text(), QStringLiteral("0.002"));
    QVERIFY(!arrow->isVisible());
    QVERIFY(edit("planes.flatness")->hasFocus());
}

void ParametersPanelTest::aPresetIsChosenFromTheBox()
{
    show();
    auto* preset = panel_->findChild<QComboBox*>("preset");
    preset->setFocus();

    QTest::keyClick(preset, Qt::Key_Down);

    QCOMPARE(model_->preset(), QStringLiteral("paper"));
    QCOMPARE(edit("planes.flatness")->text(), QStringLiteral("0.005"));
    QVERIFY(panel_->findChild<QLabel*>("presetMeaning")->text().startsWith("The published method"));
}

void ParametersPanelTest::switchesAndChoicesAreTakenAtOnce()
{
    show();
    panel_->showParameter("noise.estimated");
    auto* toggle = field("noise.estimated")->findChild<QCheckBox*>("field");
    QVERIFY(toggle->isChecked());
    QTest::keyClick(toggle, Qt::Key_Space);
    QVERIFY(!model_->parameters().noise.estimated);

    panel_->showParameter("planes.cost");
    auto* choices = field("planes.cost")->findChild<QComboBox*>("field");
    QTest::keyClick(choices, Qt::Key_Down);

    QCOMPARE(model_->parameters().planes.cost, PlaneCost::Foot);
}

void ParametersPanelTest::parametersAreSavedAsAPreset()
{
    show();
    QString kept;
    panel_->setPresetKeeper([&](const QString& name, const Parameters&) {
        kept = name;
        return QString();
    });
    model_->setText("planes.flatness", "0.1");
    panel_->findChild<QPushButton*>("savePreset")->click();
    auto* name = panel_->findChild<QLineEdit*>("presetName");

    QTest::keyClicks(name, "paper");
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(kept, QString());
    name->selectAll();
    QTest::keyClicks(name, "Brick walls");
    QTest::keyClick(name, Qt::Key_Return);

    QCOMPARE(kept, QStringLiteral("Brick walls"));
    QCOMPARE(model_->preset(), QStringLiteral("Brick walls"));
    QCOMPARE(panel_->findChild<QComboBox*>("preset")->currentText(), QStringLiteral("Brick walls"));
    QVERIFY(!model_->isAnyChanged());
    QVERIFY(!name->isVisible());
}

void ParametersPanelTest::aPresetThatCouldNotBeKeptSaysWhy()
{
    show();
    panel_->setPresetKeeper([](const QString&, const Parameters&) { return QStringLiteral("The disk is full."); });
    panel_->findChild<QPushButton*>("savePreset")->click();
    auto* name = panel_->findChild<QLineEdit*>("presetName");

    QTest::keyClicks(name, "Brick walls");
    QTest::keyClick(name, Qt::Key_Return);

    QVERIFY(name->isVisible());
    QCOMPARE(model_->preset(), QStringLiteral("precise"));
}

void ParametersPanelTest::aParameterCanBeShownByItsKey()
{
    show();
    QVERIFY(!field("schedule.fit-every")->isVisible());

    panel_->showParameter("schedule.fit-every");

    QVERIFY(field("schedule.fit-every")->isVisible());
    QVERIFY(edit("schedule.fit-every")->hasFocus());
}

void ParametersPanelTest::parametersFromElsewhereAreShown()
{
    Parameters parameters = model_->parameters();
    parameters.schedule.fitEvery = 9;

    model_->setParameters(parameters);

    QCOMPARE(edit("schedule.fit-every")->text(), QStringLiteral("9"));
}

void ParametersPanelTest::whatCannotChangeDuringAScanIsGreyedOut()
{
    panel_->setScanning(true);

    QVERIFY(!field("method.estimator")->isEnabled());
    QVERIFY(!field("sensor.range-offset")->isEnabled());
    QVERIFY(field("segments.split-distance")->isEnabled());

    panel_->setScanning(false);
    QVERIFY(field("method.estimator")->isEnabled());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ParametersPanelTest)
#include "parameters_panel_test.moc"
