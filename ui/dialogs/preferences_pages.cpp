// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/dialogs/preferences_pages.h"

#include <QAction>
#include <QCoreApplication>
#include <QStandardPaths>
#include <QToolButton>

namespace planewright {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("PreferencesPages", text);
}

}  // namespace

PreferencesPage* makeGeneralPage(QWidget* parent)
{
    auto* page = new PreferencesPage(tr("General"), parent);
    page->addChoice(tr("Theme"), QStringLiteral("theme"), {tr("As the desktop"), tr("Light"), tr("Dark")},
                    &Preferences::theme);
    page->addIndex(
        tr("Unit of lengths"), QStringLiteral("lengthUnit"), {tr("Metres"), tr("Millimetres")},
        [](const Preferences& p) { return p.lengths.millimetres ? 1 : 0; },
        [](Preferences& p, int index) { p.lengths.millimetres = index == 1; });
    QStringList decimals;
    for (int count = 0; count <= kMostDecimals; ++count)
        decimals << QString::number(count);
    page->addIndex(
        tr("Decimal places of metres"), QStringLiteral("decimals"), decimals,
        [](const Preferences& p) { return p.lengths.decimals; },
        [](Preferences& p, int index) { p.lengths.decimals = index; });
    return page;
}

PreferencesPage* makeViewPage(QWidget* parent)
{
    auto* page = new PreferencesPage(tr("View"), parent);
    page->addChoice(tr("Renderer, from the next start on"), QStringLiteral("renderer"),
                    {tr("Automatic"), tr("Graphics card"), tr("Software")}, &Preferences::renderer);
    page->addNumber(tr("Points drawn while the view moves"), QStringLiteral("pointBudget"), tr("thousand"),
                    kFewestPointsMoving, kMostPointsMoving, 0, &Preferences::pointBudget);
    page->addToggle(tr("Smooth edges, with a graphics card"), QStringLiteral("antiAliasing"),
                    &Preferences::antiAliasing);
    page->addChoice(tr("Colours of planes"), QStringLiteral("palette"),
                    {tr("Normal"), tr("Colour-blind"), tr("High contrast")}, &Preferences::palette);
    return page;
}

PreferencesPage* makeScanPage(const QStringList& presets, QWidget* parent)
{
    auto* page = new PreferencesPage(tr("Scan"), parent);
    page->addFolder(tr("Folder of recordings"), QStringLiteral("recordFolder"),
                    QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation), &Preferences::recordFolder);
    page->addNumber(tr("Free space that must be left"), QStringLiteral("freeSpaceFloor"), tr("GB"), 0.0, 1000.0, 1,
                    &Preferences::freeSpaceFloor);
    page->addWord(tr("Preset of a new scan"), QStringLiteral("defaultPreset"), presets, &Preferences::preset);
    page->addToggle(tr("Sound at a fault"), QStringLiteral("alarmSound"), &Preferences::alarmSound);
    return page;
}

PreferencesPage* makeAdvancedPage(const QList<QAction*>& actions, QWidget* parent)
{
    auto* page = new PreferencesPage(tr("Advanced"), parent);
    page->addChoice(tr("Log"), QStringLiteral("logDetail"), {tr("Errors and warnings"), tr("Everything")},
                    &Preferences::logDetail);
    page->addToggle(tr("Safe mode at the next start"), QStringLiteral("safeMode"), &Preferences::safeModeNextStart);
    for (QAction* action : actions) {
        auto* button = new QToolButton(page);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setObjectName(action->objectName() + QStringLiteral("Button"));
        button->setAccessibleName(action->text());
        page->addWidget(button, action->text());
    }
    return page;
}

}  // namespace planewright
