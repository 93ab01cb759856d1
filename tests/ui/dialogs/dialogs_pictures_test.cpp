// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <functional>
#include <memory>

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QtTest>

#include "tests/test_program.h"
#include "tests/ui/view3d/reference_image.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/command_palette.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/shortcuts_dialog.h"
#include "ui/theme/theme.h"

namespace planewright {

/// The dialogs beside pictures that somebody has looked at.
class DialogsPicturesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void dialogsAreAsTheyWere_data();
    void dialogsAreAsTheyWere();

private:
    QAction* add(QMenu& menu, const char* name, const char* text, const char* keys);
    std::unique_ptr<QDialog> made(const QString& name) const;

    QMenu file_{QStringLiteral("&File")};
    QMenu scan_{QStringLiteral("&Scan")};
    QList<QAction*> actions_;
};

QAction* DialogsPicturesTest::add(QMenu& menu, const char* name, const char* text, const char* keys)
{
    QAction* action = menu.addAction(QString::fromLatin1(text));
    action->setObjectName(QLatin1String(name));
    action->setShortcut(QKeySequence(QLatin1String(keys)));
    actions_.push_back(action);
    return action;
}

void DialogsPicturesTest::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(12);
    QApplication::setFont(font);
    add(file_, "actOpen", "&Open...", "Ctrl+O");
    add(file_, "actExportPlanes", "Export &planes...", "Ctrl+E")->setEnabled(false);
    add(file_, "actScreenshot", "&Screenshot", "Ctrl+P");
    add(scan_, "actStart", "&Start", "F5");
    add(scan_, "actPause", "&Pause or continue", "F6")->setEnabled(false);
    add(scan_, "actStopMotion", "Stop &motion", "Ctrl+.");
    add(scan_, "actRerun", "&Re-run extraction", "Ctrl+R");
    add(scan_, "actResetLayout", "Reset &layout", "");
}

void DialogsPicturesTest::dialogsAreAsTheyWere_data()
{
    QTest::addColumn<bool>("dark");
    QTest::addColumn<QString>("dialog");
    for (const char* dialog : {"preferences", "shortcuts", "palette", "about"}) {
        QTest::addRow("dialog-%s-light", dialog) << false << QString::fromLatin1(dialog);
        QTest::addRow("dialog-%s-dark", dialog) << true << QString::fromLatin1(dialog);
    }
}

std::unique_ptr<QDialog> DialogsPicturesTest::made(const QString& name) const
{
    if (name == QLatin1String("shortcuts"))
        return std::make_unique<ShortcutsDialog>(actions_);
    if (name == QLatin1String("palette"))
        return std::make_unique<CommandPalette>(actions_);
    if (name == QLatin1String("about"))
        return std::make_unique<AboutDialog>(
            QList<QPair<QString, QString>>{{"Planewright", "1.2.3"}, {"Qt", "6.4.2"}, {"VTK", "9.1.0"}});
    return std::make_unique<PreferencesDialog>(Preferences{},
                                               PreferencesContext{.presets = {"precise", "paper"},
                                                                  .actions = actions_,
                                                                  .keptShortcuts = {QStringLiteral("actStopMotion")},
                                                                  .advancedActions = {actions_.back()}});
}

void DialogsPicturesTest::dialogsAreAsTheyWere()
{
    QFETCH(bool, dark);
    QFETCH(QString, dialog);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    const std::unique_ptr<QDialog> shown = made(dialog);
    shown->show();
    QVERIFY(QTest::qWaitForWindowExposed(shown.get()));
    QApplication::setCursorFlashTime(0);
    QTest::qWait(20);

    const QString difference = differenceFromReference(shown->grab().toImage(), QTest::currentDataTag());

    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::DialogsPicturesTest)
#include "dialogs_pictures_test.moc"
