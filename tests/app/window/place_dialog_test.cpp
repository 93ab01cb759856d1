// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/place_dialog.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include "core/types/angle.h"
#include "tests/app/window/shown_window.h"
#include "tests/test_program.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/theme/theme.h"

namespace planewright {

namespace {

Pose placeAt(const Eigen::Vector3d& translation, double heading)
{
    return {Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ())), translation};
}

PlaceDialog::Words floorWords()
{
    return {QStringLiteral("floor"), QStringLiteral("Place floor 1 by its stop 12"),
            QStringLiteral("&The stop is here in the building")};
}

}  // namespace

/// Where a stop or a floor is, in numbers.
class PlaceDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { useFixedLook(); }
    void nobodySaysWhereItIsUntilItIsTicked();
    void aTiltedStopIsTurnedAboutTheVertical();
    void aFitMovesThePlaceAndSaysSo();
    void itLooksAsItDid_data();
    void itLooksAsItDid();

private:
    static QDoubleSpinBox* field(PlaceDialog& dialog, const char* name)
    {
        return dialog.findChild<QDoubleSpinBox*>(QLatin1String(name));
    }
};

void PlaceDialogTest::nobodySaysWhereItIsUntilItIsTicked()
{
    PlaceDialog dialog(floorWords(), std::nullopt, placeAt({1.0, 2.0, 3.0}, 0.0));

    QVERIFY(!dialog.place());
    QVERIFY(!field(dialog, "floorX")->isEnabled());
    QCOMPARE(field(dialog, "floorY")->value(), 2.0);
    dialog.findChild<QCheckBox*>(QStringLiteral("floorKnown"))->setChecked(true);

    QVERIFY(field(dialog, "floorX")->isEnabled());
    field(dialog, "floorZ")->setValue(3.5);
    QVERIFY(dialog.place());
    QVERIFY(dialog.place()->translation.isApprox(Eigen::Vector3d(1.0, 2.0, 3.5), 1e-12));
}

void PlaceDialogTest::aTiltedStopIsTurnedAboutTheVertical()
{
    const Eigen::Quaterniond tilt(Eigen::AngleAxisd(degrees(5.0), Eigen::Vector3d::UnitX()));
    const Pose tilted{tilt, Eigen::Vector3d::Zero()};
    PlaceDialog dialog(floorWords(), tilted, Pose{});

    field(dialog, "floorHeading")->setValue(90.0);

    // A quarter turn about the vertical after the tilt about x.
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(degrees(90.0), Eigen::Vector3d::UnitZ()));
    QVERIFY(dialog.pose().rotation.angularDistance(turn * tilt) < 1e-9);
}

void PlaceDialogTest::aFitMovesThePlaceAndSaysSo()
{
    PlaceDialog dialog(floorWords(), std::nullopt, placeAt({1.0, 0.0, 0.0}, 0.0));
    dialog.offerToFit(QStringLiteral("&Snap"), [](const Pose& from) {
        return std::pair(placeAt(from.translation + Eigen::Vector3d::UnitY(), degrees(10.0)), QStringLiteral("Moved."));
    });
    QSignalSpy changes(&dialog, &PlaceDialog::placeChanged);

    dialog.findChild<QPushButton*>(QStringLiteral("floorFit"))->click();

    QCOMPARE(changes.count(), 1);
    QVERIFY(dialog.place());
    QCOMPARE(field(dialog, "floorX")->value(), 1.0);
    QCOMPARE(field(dialog, "floorY")->value(), 1.0);
    QCOMPARE(field(dialog, "floorHeading")->value(), 10.0);
    QCOMPARE(dialog.findChild<QLabel*>(QStringLiteral("floorFitted"))->text(), QStringLiteral("Moved."));
}

void PlaceDialogTest::itLooksAsItDid_data()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("dialog-place-light") << false;
    QTest::newRow("dialog-place-dark") << true;
}

void PlaceDialogTest::itLooksAsItDid()
{
    QFETCH(bool, dark);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    PlaceDialog dialog(floorWords(), placeAt({-12.345, 100.25, 3.0}, degrees(-123.5)), Pose{});
    dialog.offerToFit(QStringLiteral("&Snap to walls and stairs of floor 0"), [](const Pose& from) {
        return std::pair(from,
                         QStringLiteral("2 walls over walls of floor 0, within 12.5 mm. They fix not all of its place: "
                                        "along them it stays as it was. Its height stays: no stairs are seen from both "
                                        "floors near where it is now."));
    });
    dialog.explain(
        QStringLiteral("Or drag the handles in the view: the middle shifts the floor, the knob on the ring "
                       "turns it, the arrow raises it."));
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    QApplication::setCursorFlashTime(0);
    dialog.findChild<QPushButton*>(QStringLiteral("floorFit"))->click();
    QTest::qWait(20);

    const QString difference = differenceFromReference(dialog.grab().toImage(), QTest::currentDataTag());

    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::PlaceDialogTest)
#include "place_dialog_test.moc"
