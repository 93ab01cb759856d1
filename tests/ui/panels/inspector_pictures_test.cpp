// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QApplication>
#include <QFont>
#include <QtTest>

#include "core/pipeline/step_replay.h"
#include "tests/core/pipeline/simulated_room.h"
#include "tests/test_program.h"
#include "tests/ui/drawn_lives.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/panels/decision_tree.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/lineage_panel.h"
#include "ui/panels/why_not_panel.h"
#include "ui/theme/theme.h"

namespace planewright {

/// The panels that tell why, beside pictures that somebody has looked at.
class InspectorPicturesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void stepsAreAsTheyWere_data() { addThemes(); }
    void stepsAreAsTheyWere();
    void answersAreAsTheyWere_data() { addThemes(); }
    void answersAreAsTheyWere();
    void livesAreAsTheyWere_data() { addThemes(); }
    void livesAreAsTheyWere();

private:
    static void addThemes();
    void compare(QWidget& panel, const QString& name);

    std::unique_ptr<StepReplay> replay_;
    QFont before_;
};

namespace {

constexpr int kInspected = 69;  // the screen's step 70, where every phase is due

}  // namespace

void InspectorPicturesTest::initTestCase()
{
    before_ = QApplication::font();
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    QApplication::setFont(font);
    const Recording recording = scanOf("corridor", "default", 7, "table10-2").scan.recording;
    replay_ = std::make_unique<StepReplay>(sensorOf(recording.description), Parameters{});
    for (const ScanSlice& slice : recording.slices)
        replay_->add(std::make_shared<const ScanSlice>(slice));
}

void InspectorPicturesTest::cleanupTestCase()
{
    applyTheme(Theme::Light);
    QApplication::setFont(before_);
}

void InspectorPicturesTest::addThemes()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

void InspectorPicturesTest::compare(QWidget& panel, const QString& name)
{
    panel.resize(420, 460);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    QTest::qWait(200);

    const QString difference =
        differenceFromReference(panel.grab().toImage(), name + '-' + QString::fromLatin1(QTest::currentDataTag()));

    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

void InspectorPicturesTest::stepsAreAsTheyWere()
{
    QFETCH(bool, dark);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    const auto went = *replay_->at(kInspected);
    auto snapshot = std::make_shared<Snapshot>(*went->snapshot);
    // What depends on the machine is drawn by hand.
    for (std::size_t phase = 0; phase < kPhases; ++phase)
        snapshot->report.times[phase] = std::chrono::microseconds{300 + 400 * phase};
    InspectedStep step;
    step.snapshot = std::move(snapshot);
    step.phased = went;
    step.time = std::chrono::milliseconds{1725};
    step.newest = static_cast<int>(replay_->slices()) - 1;
    step.planned = step.newest + 1;
    InspectorPanel panel;

    panel.setStep(std::move(step));
    panel.setShownPhase(4);
    panel.tree()->expand(panel.model().indexOfPhase(1));
    panel.tree()->expand(panel.model().index(0, 0, panel.model().indexOfPhase(1)));
    panel.tree()->scrollToTop();

    compare(panel, QStringLiteral("inspector"));
}

void InspectorPicturesTest::answersAreAsTheyWere()
{
    QFETCH(bool, dark);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    const auto step = *replay_->at(kInspected);
    const PlaneRef first{step->snapshot->planes[0]->id};
    const PlaneRef second{step->snapshot->planes[1]->id};
    WhyNotPanel panel;

    panel.setOperands(first, second);
    panel.setAnswer(*replay_->whyNot(kInspected, first, second), QStringLiteral("70"));

    compare(panel, QStringLiteral("why-not"));
}

void InspectorPicturesTest::livesAreAsTheyWere()
{
    QFETCH(bool, dark);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    const PlaneLives lives = drawnLives();
    LineagePanel panel;

    panel.setChart(lineageChart(lives, lives.familyOf(2), 20, true));
    panel.setChosen({2});
    panel.setStep(11);
    panel.view()->setCurrentEvent(2);

    compare(panel, QStringLiteral("lineage"));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::InspectorPicturesTest)
#include "inspector_pictures_test.moc"
