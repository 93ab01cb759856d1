// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/layers_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSlider>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class LayersPanelTest : public QObject {
    Q_OBJECT

private slots:
    void allButUncertaintyAreShownAtFirst();
    void controlsGiveSettings();
    void settingsFromElsewhereTellNobody();
    void theWheelChangesNothingInPassing();
};

void LayersPanelTest::allButUncertaintyAreShownAtFirst()
{
    const LayersPanel panel;

    for (int layer = 0; layer < static_cast<int>(kLayers); ++layer)
        QCOMPARE(panel.findChild<QCheckBox*>(QString("layer%1").arg(layer))->isChecked(),
                 layer != static_cast<int>(Layer::Uncertainty));
    QVERIFY(panel.settings() == LayerSettings{});
}

void LayersPanelTest::controlsGiveSettings()
{
    LayersPanel panel;
    QSignalSpy changed(&panel, &LayersPanel::settingsChanged);
    const auto planes = static_cast<int>(Layer::Planes);

    QTest::keyClick(panel.findChild<QCheckBox*>("layer0"), Qt::Key_Space);
    panel.findChild<QSlider*>(QString("opacity%1").arg(planes))->setValue(70);
    panel.findChild<QDoubleSpinBox*>(QString("size%1").arg(planes))->setValue(3.5);
    panel.findChild<QComboBox*>("colourBy")->setCurrentIndex(static_cast<int>(ColourBy::Height));

    QCOMPARE(changed.size(), 4);
    const LayerSettings& settings = panel.settings();
    QVERIFY(!settings[Layer::Points].visible);
    QCOMPARE(settings[Layer::Planes].opacity, 0.7);
    QCOMPARE(settings[Layer::Planes].size, 3.5);
    QCOMPARE(settings.colourBy, ColourBy::Height);
}

void LayersPanelTest::settingsFromElsewhereTellNobody()
{
    LayersPanel panel;
    QSignalSpy changed(&panel, &LayersPanel::settingsChanged);
    LayerSettings settings;
    settings[Layer::Clusters].visible = false;
    settings.palette = PlanePalette::ColourBlind;

    panel.setSettings(settings);

    QVERIFY(!panel.findChild<QCheckBox*>("layer2")->isChecked());
    QCOMPARE(changed.size(), 0);
    panel.findChild<QCheckBox*>("layer2")->click();
    QCOMPARE(panel.settings().palette, PlanePalette::ColourBlind);
}

void LayersPanelTest::theWheelChangesNothingInPassing()
{
    LayersPanel panel;
    panel.resize(300, 200);
    panel.show();
    auto* box = panel.findChild<QComboBox*>("colourBy");
    panel.findChild<QCheckBox*>("layer0")->setFocus();
    QWheelEvent wheel(QPointF(5, 5), box->mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);

    QCoreApplication::sendEvent(box, &wheel);

    QCOMPARE(box->currentIndex(), 0);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::LayersPanelTest)
#include "layers_panel_test.moc"
