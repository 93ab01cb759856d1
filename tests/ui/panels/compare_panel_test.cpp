// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/compare_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QFont>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "core/params/presets.h"
#include "core/pipeline/plane_extractor.h"
#include "tests/core/pipeline/simulated_room.h"
#include "tests/test_program.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/panels/filtered_table.h"
#include "ui/theme/theme.h"

namespace planewright {

class ComparePanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void aChoiceStaysWhereItIsStillThere();
    void itIsAskedForWhatIsChosen();
    void progressCanBeCancelled();
    void aRowTellsItsPlanes();
    void itLooksAsItDid_data();
    void itLooksAsItDid();

private:
    std::shared_ptr<const Snapshot> precise_;
    std::shared_ptr<const Snapshot> paper_;
    QFont before_;
};

namespace {

std::shared_ptr<const Snapshot> extracted(const Recording& recording, std::string_view preset)
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset), parameters);
    PlaneExtractor extractor(sensorOf(recording.description), parameters);
    for (const ScanSlice& slice : recording.slices)
        extractor.advance(slice);
    return extractor.finish();
}

}  // namespace

void ComparePanelTest::initTestCase()
{
    before_ = QApplication::font();
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    QApplication::setFont(font);
    const Recording recording = scanOf("corridor", "default", 7, "table10-2").scan.recording;
    precise_ = extracted(recording, "precise");
    paper_ = extracted(recording, "paper");
}

void ComparePanelTest::cleanupTestCase()
{
    applyTheme(Theme::Light);
    QApplication::setFont(before_);
}

void ComparePanelTest::aChoiceStaysWhereItIsStillThere()
{
    CompareModel model;
    ComparePanel panel(model);
    panel.setChoices({"one", "two", "three"}, {"first", "second", "third"});
    panel.setChoice(1);
    const auto* meaning = panel.findChild<QLabel*>(QStringLiteral("compareMeaning"));
    QCOMPARE(meaning->text(), QStringLiteral("second"));

    panel.setChoices({"zero", "one", "two"}, {"none", "first", "second"});
    QCOMPARE(panel.choice(), 2);
    panel.setChoices({"other"}, {"another"});
    QCOMPARE(panel.choice(), 0);
    QCOMPARE(meaning->text(), QStringLiteral("another"));
}

void ComparePanelTest::itIsAskedForWhatIsChosen()
{
    CompareModel model;
    ComparePanel panel(model);
    panel.setChoices({"one", "two"}, {"first", "second"});
    panel.setChoice(1);
    QSignalSpy runs(&panel, &ComparePanel::runRequested);

    QTest::mouseClick(panel.findChild<QPushButton*>(QStringLiteral("compareRun")), Qt::LeftButton);

    QCOMPARE(runs.count(), 1);
    QCOMPARE(runs[0][0].toInt(), 1);
}

void ComparePanelTest::progressCanBeCancelled()
{
    CompareModel model;
    ComparePanel panel(model);
    const auto* run = panel.findChild<QPushButton*>(QStringLiteral("compareRun"));
    auto* close = panel.findChild<QPushButton*>(QStringLiteral("compareClose"));
    const auto* progress = panel.findChild<QProgressBar*>(QStringLiteral("compareProgress"));
    QVERIFY(!close->isEnabled());
    QSignalSpy closes(&panel, &ComparePanel::closeRequested);

    panel.setProgress(30, 120);
    QVERIFY(!run->isEnabled());
    QVERIFY(!progress->isHidden());
    QCOMPARE(progress->value(), 30);
    QCOMPARE(progress->maximum(), 120);
    QTest::mouseClick(close, Qt::LeftButton);
    QCOMPARE(closes.count(), 1);

    panel.setIdle(true);
    QVERIFY(run->isEnabled() && close->isEnabled());
    QVERIFY(progress->isHidden());
}

void ComparePanelTest::aRowTellsItsPlanes()
{
    CompareModel model;
    ComparePanel panel(model);
    model.setMaps(precise_, paper_);
    QSignalSpy chosen(&panel, &ComparePanel::planesChosen);
    const MapComparison& comparison = model.comparison();
    QVERIFY(comparison.pairs.size() >= 4);  // floor, ceiling and both long walls

    panel.table()->choose({1});

    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen[0][0].toInt(), comparison.pairs[1].a);
    QCOMPARE(chosen[0][1].toInt(), comparison.pairs[1].b);
    QVERIFY(panel.table()->footer().startsWith(QStringLiteral("%1 in both, %2 only in A, %3 only in B")
                                                   .arg(comparison.pairs.size())
                                                   .arg(comparison.onlyA.size())
                                                   .arg(comparison.onlyB.size())));
}

void ComparePanelTest::itLooksAsItDid_data()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

void ComparePanelTest::itLooksAsItDid()
{
    QFETCH(bool, dark);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    CompareModel model;
    ComparePanel panel(model);
    panel.setChoices({"precise", "paper"}, {"maximum likelihood", "the published method, with its formulas corrected"});
    panel.setChoice(1);
    panel.setNames("this scan", "paper");
    panel.setIdle(true);
    model.setMaps(precise_, paper_);
    panel.setTotals(precise_.get(), paper_.get());
    panel.resize(1180, 260);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));

    const QString difference = differenceFromReference(
        panel.grab().toImage(), QStringLiteral("compare-") + QString::fromLatin1(QTest::currentDataTag()));

    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ComparePanelTest)
#include "compare_panel_test.moc"
