// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/preferences.h"

#include <limits>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class PreferencesTest : public QObject {
    Q_OBJECT

private slots:
    void defaultsAreValid();
    void numbersAreBroughtIntoTheirLimits();
    void whatIsNoNumberHasItsDefault();
};

void PreferencesTest::defaultsAreValid()
{
    QVERIFY(validated({}) == Preferences{});
}

void PreferencesTest::numbersAreBroughtIntoTheirLimits()
{
    Preferences preferences;
    preferences.lengths.decimals = 9;
    preferences.pointBudget = 0.0;
    preferences.freeSpaceFloor = 1e6;
    preferences.preset = "";

    const Preferences valid = validated(preferences);

    QCOMPARE(valid.lengths.decimals, 4);
    QCOMPARE(valid.pointBudget, kFewestPointsMoving);
    QCOMPARE(valid.freeSpaceFloor, 1000.0);
    QCOMPARE(valid.preset, std::string("precise"));
}

void PreferencesTest::whatIsNoNumberHasItsDefault()
{
    Preferences preferences;
    preferences.pointBudget = std::numeric_limits<double>::quiet_NaN();
    preferences.freeSpaceFloor = std::numeric_limits<double>::infinity();

    QVERIFY(validated(preferences) == Preferences{});
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PreferencesTest)
#include "preferences_test.moc"
