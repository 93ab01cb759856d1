// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/preferences_store.h"

#include <QTemporaryDir>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class PreferencesStoreTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsSavedIsLoaded();
    void whatIsAsItComesIsNotWritten();
    void whatMakesNoSenseHasItsDefault();
    void anEmptyListOfKeysIsKept();
};

namespace {

Preferences someChoice()
{
    Preferences chosen;
    chosen.theme = ThemeChoice::Dark;
    chosen.lengths = {.millimetres = true, .decimals = 3};
    chosen.renderer = Renderer::Software;
    chosen.pointBudget = 120.0;
    chosen.antiAliasing = false;
    chosen.palette = PlanePalette::HighContrast;
    chosen.recordFolder = "/data/Scans für Ö";
    chosen.freeSpaceFloor = 2.5;
    chosen.preset = "Brick walls";
    chosen.alarmSound = false;
    chosen.shortcuts = {{"actStart", {"F5", "Ctrl+Return"}}, {"actFit", {"Shift+,"}}};
    chosen.logDetail = LogDetail::Problems;
    chosen.safeModeNextStart = true;
    return chosen;
}

}  // namespace

void PreferencesStoreTest::whatIsSavedIsLoaded()
{
    const QTemporaryDir folder;
    {
        QSettings settings(folder.filePath("x.ini"), QSettings::IniFormat);
        savePreferences(someChoice(), settings);
    }

    QVERIFY(loadPreferences(QSettings(folder.filePath("x.ini"), QSettings::IniFormat)) == someChoice());
}

void PreferencesStoreTest::whatIsAsItComesIsNotWritten()
{
    const QTemporaryDir folder;
    QSettings settings(folder.filePath("x.ini"), QSettings::IniFormat);
    savePreferences(someChoice(), settings);

    savePreferences({}, settings);

    QCOMPARE(settings.allKeys(), QStringList());
    QVERIFY(loadPreferences(settings) == Preferences{});
}

void PreferencesStoreTest::whatMakesNoSenseHasItsDefault()
{
    const QTemporaryDir folder;
    QSettings settings(folder.filePath("x.ini"), QSettings::IniFormat);
    settings.setValue("general/theme", "purple");
    settings.setValue("general/decimals", "many");
    settings.setValue("view/anti-aliasing", "perhaps");
    settings.setValue("view/point-budget", "nan");
    settings.setValue("scan/free-space-floor", "");
    settings.setValue("scan/preset", "");

    QVERIFY(loadPreferences(settings) == Preferences{});
}

void PreferencesStoreTest::anEmptyListOfKeysIsKept()
{
    const QTemporaryDir folder;
    Preferences chosen;
    chosen.shortcuts = {{"actQuit", {}}};
    {
        QSettings settings(folder.filePath("x.ini"), QSettings::IniFormat);
        savePreferences(chosen, settings);
    }

    const Preferences loaded = loadPreferences(QSettings(folder.filePath("x.ini"), QSettings::IniFormat));

    QCOMPARE(loaded.shortcuts.size(), std::size_t(1));
    QVERIFY(loaded.shortcuts.at("actQuit").empty());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PreferencesStoreTest)
#include "preferences_store_test.moc"
