// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/clip_box_panel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class ClipBoxPanelTest : public QObject {
    Q_OBJECT

private slots:
    void fieldsAreOfUseWithTheBoxOnly();
    void whatIsTypedIsTheBox();
    void aBoxFromElsewhereTellsNobody();
};

void ClipBoxPanelTest::fieldsAreOfUseWithTheBoxOnly()
{
    ClipBoxPanel panel;
    const QSignalSpy used(&panel, &ClipBoxPanel::useRequested);
    QVERIFY(!panel.findChild<QDoubleSpinBox*>("clipToZ")->isEnabled());

    panel.findChild<QCheckBox*>("clipBoxInUse")->click();

    QCOMPARE(used.size(), 1);
    QVERIFY(panel.findChild<QDoubleSpinBox*>("clipToZ")->isEnabled());
    QVERIFY(panel.findChild<QPushButton*>("clipBoxFit")->isEnabled());
}

void ClipBoxPanelTest::whatIsTypedIsTheBox()
{
    ClipBoxPanel panel;
    panel.setInUse(true);
    panel.setBox({Eigen::Vector3d{-1.0, -2.0, 0.0}, Eigen::Vector3d{1.0, 2.0, 3.0}});
    QSignalSpy changed(&panel, &ClipBoxPanel::boxChanged);

    panel.findChild<QDoubleSpinBox*>("clipToZ")->setValue(1.25);

    QCOMPARE(changed.size(), 1);
    QVERIFY(panel.box().min() == Eigen::Vector3d(-1.0, -2.0, 0.0));
    QVERIFY(panel.box().max() == Eigen::Vector3d(1.0, 2.0, 1.25));
}

void ClipBoxPanelTest::aBoxFromElsewhereTellsNobody()
{
    ClipBoxPanel panel;
    const QSignalSpy changed(&panel, &ClipBoxPanel::boxChanged);
    const QSignalSpy used(&panel, &ClipBoxPanel::useRequested);

    panel.setInUse(true);
    panel.setBox({Eigen::Vector3d{0.0, 0.0, 0.0}, Eigen::Vector3d{1.0, 2.0, 3.0}});

    QVERIFY(changed.isEmpty());
    QVERIFY(used.isEmpty());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::ClipBoxPanelTest)
#include "clip_box_panel_test.moc"
