// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSlider>
#include <QTableView>
#include <QTreeView>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/drawn_lives.h"
#include "tests/ui/made_map.h"
#include "tests/ui/made_timeline.h"
#include "ui/panels/compare_panel.h"
#include "ui/panels/filtered_table.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/layers_panel.h"
#include "ui/panels/lineage_panel.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/parameter_group_box.h"
#include "ui/panels/parameters_panel.h"
#include "ui/panels/planes_panel.h"
#include "ui/panels/segments_panel.h"
#include "ui/panels/source_panel.h"
#include "ui/panels/why_not_panel.h"
#include "ui/theme/theme.h"

namespace planewright {

/// What holds for every control of every panel.
class PanelAccessTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everyControlHasANameAndASize_data();
    void everyControlHasANameAndASize();
    void everyControlIsReachedWithTab_data();
    void everyControlIsReachedWithTab();
    void nothingIsCutOffAtTheWidthOfItsDock_data();
    void nothingIsCutOffAtTheWidthOfItsDock();

private:
    void addPanels();

    std::vector<std::unique_ptr<QObject>> models_;
    MadeTimeline timeline_;
    std::vector<std::pair<QWidget*, int>> panels_;  // with the width of its dock [px]
};

namespace {

bool isControl(const QWidget* widget)
{
    if (qobject_cast<const QScrollBar*>(widget) != nullptr || widget->objectName().startsWith("qt_"))
        return false;
    // The line inside a box of numbers or words is a part of it.
    if (qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()) != nullptr ||
        qobject_cast<const QComboBox*>(widget->parentWidget()) != nullptr ||
        qobject_cast<const QLineEdit*>(widget->parentWidget()) != nullptr ||
        qobject_cast<const QTableView*>(widget->parentWidget()) != nullptr ||
        qobject_cast<const QTreeView*>(widget->parentWidget()) != nullptr)
        return false;
    return qobject_cast<const QAbstractButton*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr || qobject_cast<const QLineEdit*>(widget) != nullptr ||
           qobject_cast<const QSlider*>(widget) != nullptr || qobject_cast<const QTableView*>(widget) != nullptr ||
           qobject_cast<const QTreeView*>(widget) != nullptr || qobject_cast<const LineageView*>(widget) != nullptr;
}

QString nameOf(const QWidget* widget)
{
    return QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
}

}  // namespace

void PanelAccessTest::initTestCase()
{
    applyTheme(Theme::Light);
    const auto keep = [this](auto* model) -> auto&
    {
        models_.emplace_back(model);
        return *model;
    };
    auto& selection = keep(new MapSelection);
    auto& planes = keep(new PlanesModel);
    auto& segments = keep(new SegmentsModel);
    auto& log = keep(new LogModel);
    auto& measurements = keep(new MeasurementsModel);
    auto& parameters = keep(new ParameterModel);
    MadeMap made;
    made.slice(2);
    constexpr int kMoreThanFit = 40;
    for (PlaneId id = 0; id < kMoreThanFit; ++id)
        made.plane(made.wall(id, {{0, 0}})).outlined(22.0, 11.0, 2.0);
    const auto map = made.get();
    planes.setMap(map);
    segments.setMap(map);
    log.append({QDateTime::currentDateTime(), LogSeverity::Info, "file", "opened"});
    measurements.addPoints({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    auto* parametersPanel = new ParametersPanel(parameters);
    for (ParameterGroupBox* group : parametersPanel->findChildren<ParameterGroupBox*>())
        group->setOpen(true);
    auto* recording = new SourcePanel;
    recording->showRecording("x");
    recording->setObjectName("recordingPanel");
    auto* logPanel = new LogPanel(log);
    logPanel->setReportHead([] { return QString(); });
    auto* inspector = new InspectorPanel;
    auto step = std::make_shared<Snapshot>();
    step->report.step = 4;
    inspector->setStep(InspectedStep{step, nullptr, {}});
    auto* whyNot = new WhyNotPanel;
    whyNot->setAnswer(
        {{PlaneRef{3}, PlaneRef{11}}, false, {{"merge", {{"plane_distance", 0.061, Comparison::Less, 0.025}}}}}, "5");
    auto* lineage = new LineagePanel;
    const PlaneLives lives = drawnLives();
    lineage->setChart(lineageChart(lives, lives.familyOf(2), 20, true));
    auto& differences = keep(new CompareModel);
    differences.setMaps(map->snapshot, map->snapshot);
    auto* compare = new ComparePanel(differences);
    compare->setChoices({"paper"}, {"the published method"});
    compare->setIdle(true);
    panels_ = {{new PlanesPanel(planes, selection), 420},
               {new SegmentsPanel(segments, selection), 700},
               {logPanel, 700},
               {new MeasurePanel(measurements), 700},
               {parametersPanel, 300},
               {new LayersPanel, 300},
               {new SourcePanel, 300},
               {recording, 300},
               {inspector, 320},
               {whyNot, 320},
               {lineage, 320},
               {compare, 1020}};
    timeline_.panel->setColumns(madeColumns(137, true), 137, true);
    constexpr int kTimelineInSmallWindow = 750;
    panels_.emplace_back(timeline_.panel, kTimelineInSmallWindow);
    for (const auto& [panel, width] : panels_) {
        if (panel != timeline_.panel)
            models_.emplace_back(panel);
        panel->resize(width, 400);
        panel->show();
    }
    QTest::qWait(500);  // layouts settle, also on a busy machine
}

void PanelAccessTest::addPanels()
{
    QTest::addColumn<QWidget*>("panel");
    QTest::addColumn<int>("width");
    for (const auto& [panel, width] : panels_)
        QTest::newRow(qPrintable(panel->objectName())) << panel << width;
}

void PanelAccessTest::everyControlHasANameAndASize_data()
{
    addPanels();
}

void PanelAccessTest::everyControlHasANameAndASize()
{
    QFETCH(QWidget*, panel);

    for (const QWidget* widget : panel->findChildren<QWidget*>()) {
        if (!isControl(widget) || !widget->isVisible())
            continue;
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const bool isNamed = !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
        QVERIFY2(isNamed, qPrintable(nameOf(widget)));
        QVERIFY2(!widget->objectName().isEmpty(), qPrintable(nameOf(widget)));
        QVERIFY2(widget->height() >= 28, qPrintable(nameOf(widget) + QString(": %1 px").arg(widget->height())));
    }
}

void PanelAccessTest::everyControlIsReachedWithTab_data()
{
    addPanels();
}

void PanelAccessTest::everyControlIsReachedWithTab()
{
    QFETCH(QWidget*, panel);
    panel->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(panel));
    QSet<QWidget*> reached;
    QList<QWidget*> expected;
    for (QWidget* widget : panel->findChildren<QWidget*>()) {
        if (isControl(widget) && widget->isVisible() && widget->isEnabled() && widget->focusPolicy() != Qt::NoFocus)
            expected << widget;
    }
    QVERIFY(!expected.isEmpty());
    expected.first()->setFocus();

    for (qsizetype i = 0; i < 3 * expected.size() + 10; ++i) {
        if (QWidget* focused = QApplication::focusWidget()) {
            reached << focused;
            QTest::keyClick(focused, Qt::Key_Tab);
        }
    }

    for (QWidget* widget : expected) {
        if (widget->isEnabled())
            QVERIFY2(reached.contains(widget), qPrintable(nameOf(widget)));
    }
}

void PanelAccessTest::nothingIsCutOffAtTheWidthOfItsDock_data()
{
    addPanels();
}

void PanelAccessTest::nothingIsCutOffAtTheWidthOfItsDock()
{
    QFETCH(QWidget*, panel);
    QFETCH(int, width);

    QCOMPARE(panel->width(), width);
    for (const QWidget* widget : panel->findChildren<QWidget*>()) {
        if (!isControl(widget) || !widget->isVisible())
            continue;
        const QRect placed(widget->mapTo(panel, QPoint()), widget->size());
        QVERIFY2(placed.left() >= 0 && placed.right() < width, qPrintable(nameOf(widget)));
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        if (button != nullptr && !button->text().isEmpty())
            QVERIFY2(widget->width() >= widget->sizeHint().width(), qPrintable(nameOf(widget)));
    }
    for (const QTableView* view : panel->findChildren<QTableView*>())
        QVERIFY2(
            !view->isVisible() || view->horizontalScrollBar()->maximum() == 0,
            qPrintable(QString("%1: %2 px too wide").arg(nameOf(view)).arg(view->horizontalScrollBar()->maximum())));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::PanelAccessTest)
#include "panel_access_test.moc"
