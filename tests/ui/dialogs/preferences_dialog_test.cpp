// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/preferences_dialog.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class PreferencesDialogTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void pagesAreThoseThatDoSomething();
    void whatIsLoadedComesBack();
    void fieldsGiveTheirMembers();
    void nothingIsInForceBeforeOk();
    void defaultsAreRestoredForThePageThatIsSeen();
    void theSearchShowsPagesAndFieldsWithItsWords();
    void thingsToDoAreActions();

private:
    template <class Widget>
    Widget* find(const char* name) const
    {
        return dialog_->findChild<Widget*>(QLatin1String(name));
    }
    void open(const Preferences& preferences);
    QStringList pages() const;

    QAction reset_{QStringLiteral("Reset layout")};
    std::unique_ptr<PreferencesDialog> dialog_;
};

void PreferencesDialogTest::init()
{
    reset_.setObjectName("actResetLayout");
    open({});
}

void PreferencesDialogTest::open(const Preferences& preferences)
{
    const PreferencesContext context{
        .presets = {"precise", "paper"}, .actions = {}, .keptShortcuts = {}, .advancedActions = {&reset_}};
    dialog_ = std::make_unique<PreferencesDialog>(preferences, context);
    dialog_->show();
}

QStringList PreferencesDialogTest::pages() const
{
    QStringList titles;
    const auto* list = find<QListWidget>("preferencesPages");
    for (int row = 0; row < list->count(); ++row) {
        if (!list->item(row)->isHidden())
            titles << list->item(row)->text();
    }
    return titles;
}

void PreferencesDialogTest::pagesAreThoseThatDoSomething()
{
    QCOMPARE(pages(), (QStringList{"General", "View", "Scan", "Shortcuts", "Advanced"}));
}

void PreferencesDialogTest::whatIsLoadedComesBack()
{
    Preferences chosen;
    chosen.theme = ThemeChoice::Light;
    chosen.lengths = {.millimetres = true, .decimals = 4};
    chosen.renderer = Renderer::Gpu;
    chosen.pointBudget = 120.0;
    chosen.antiAliasing = false;
    chosen.palette = PlanePalette::ColourBlind;
    chosen.recordFolder = "/data";
    chosen.freeSpaceFloor = 0.5;
    chosen.preset = "Brick walls";
    chosen.alarmSound = false;
    chosen.shortcuts = {{"actFit", {"Shift+F"}}};
    chosen.logDetail = LogDetail::Problems;
    chosen.safeModeNextStart = true;

    open(chosen);

    QVERIFY(dialog_->preferences() == chosen);
}

void PreferencesDialogTest::fieldsGiveTheirMembers()
{
    find<QComboBox>("theme")->setCurrentText("Dark");
    find<QComboBox>("lengthUnit")->setCurrentText("Millimetres");
    find<QDoubleSpinBox>("pointBudget")->setValue(30.0);
    find<QLineEdit>("recordFolderPath")->setText(" /data ");
    find<QCheckBox>("safeMode")->setChecked(true);

    const Preferences preferences = dialog_->preferences();

    QCOMPARE(preferences.theme, ThemeChoice::Dark);
    QVERIFY(preferences.lengths.millimetres);
    QCOMPARE(preferences.pointBudget, 30.0);
    QCOMPARE(preferences.recordFolder, std::string("/data"));
    QVERIFY(preferences.safeModeNextStart);
}

void PreferencesDialogTest::nothingIsInForceBeforeOk()
{
    QSignalSpy applied(dialog_.get(), &PreferencesDialog::applied);
    find<QComboBox>("theme")->setCurrentText("Dark");
    QCOMPARE(applied.size(), 0);

    auto* buttons = dialog_->findChild<QDialogButtonBox*>();
    buttons->button(QDialogButtonBox::Apply)->click();
    QCOMPARE(applied.size(), 1);
    QVERIFY(dialog_->isVisible());
    buttons->button(QDialogButtonBox::Cancel)->click();
    QCOMPARE(applied.size(), 1);
    open({});
    QSignalSpy again(dialog_.get(), &PreferencesDialog::applied);
    dialog_->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();

    QCOMPARE(again.size(), 1);
    QVERIFY(!dialog_->isVisible());
}

void PreferencesDialogTest::defaultsAreRestoredForThePageThatIsSeen()
{
    find<QComboBox>("theme")->setCurrentText("Dark");
    find<QCheckBox>("antiAliasing")->setChecked(false);
    find<QListWidget>("preferencesPages")->setCurrentRow(1);

    find<QPushButton>("restoreDefaults")->click();

    QVERIFY(dialog_->preferences().antiAliasing);
    QCOMPARE(dialog_->preferences().theme, ThemeChoice::Dark);
}

void PreferencesDialogTest::theSearchShowsPagesAndFieldsWithItsWords()
{
    auto* search = find<QLineEdit>("preferencesSearch");

    QTest::keyClicks(search, "preset");

    QCOMPARE(pages(), QStringList{"Scan"});
    QVERIFY(find<QComboBox>("defaultPreset")->isVisible());
    QVERIFY(!find<QCheckBox>("alarmSound")->isVisible());
    search->setText("no such words");
    QCOMPARE(pages(), QStringList());
    search->clear();
    QCOMPARE(pages().size(), 5);
    QVERIFY(find<QCheckBox>("alarmSound")->isVisible());
}

void PreferencesDialogTest::thingsToDoAreActions()
{
    QSignalSpy done(&reset_, &QAction::triggered);

    find<QToolButton>("actResetLayoutButton")->click();

    QCOMPARE(done.size(), 1);
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::PreferencesDialogTest)
#include "preferences_dialog_test.moc"
