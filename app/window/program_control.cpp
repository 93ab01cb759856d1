// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/program_control.h"

#include <vtkVersion.h>

#include <QApplication>
#include <QClipboard>
#include <QDesktopServices>
#include <QDialog>
#include <QFile>
#include <QSysInfo>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

#include "app/window/asking.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/command_palette.h"
#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/shortcuts_dialog.h"
#include "ui/models/preferences_store.h"

namespace planewright {

ProgramControl::ProgramControl(WindowParts& parts) : QObject(&parts), parts_(parts), tour_(new Tour(parts.window.get()))
{
    for (QAction* action : parts_.window->actions().all())
        ownShortcuts_[action->objectName()] = action->shortcuts();
    applyShortcuts();
    connectLayouts();
    connectHelp();
    connectTour();
    parts_.logPanel->setReportHead([this] { return versions(); });
    connect(parts_.window->actions()[QStringLiteral("actPreferences")], &QAction::triggered, this,
            &ProgramControl::openPreferences);
    connect(&parts_, &WindowParts::preferencesChanged, this, &ProgramControl::applyShortcuts);
}

void ProgramControl::applyShortcuts()
{
    for (QAction* action : parts_.window->actions().all()) {
        QList<QKeySequence> keys = ownShortcuts_[action->objectName()];
        const auto chosen = parts_.preferences.shortcuts.find(action->objectName().toStdString());
        if (chosen != parts_.preferences.shortcuts.end()) {
            if (!WindowActions::isFixed(*action))
                keys.clear();
            for (const std::string& text : chosen->second) {
                if (const QKeySequence key(QString::fromStdString(text)); !keys.contains(key))
                    keys.push_back(key);
            }
        }
        action->setShortcuts(keys);
    }
}

void ProgramControl::connectLayouts()
{
    MainWindow& window = *parts_.window;
    WindowActions& actions = window.actions();
    connect(actions[QStringLiteral("actLayoutOperate")], &QAction::triggered, &window, [&window] {
        window.present(false);
        window.operate();
    });
    connect(actions[QStringLiteral("actLayoutInspect")], &QAction::triggered, &window, [&window] {
        window.present(false);
        window.inspect();
    });
    connect(actions[QStringLiteral("actLayoutPresent")], &QAction::triggered, &window, [&window] {
        window.present(true);
        window.view().setFocus();
    });
    connect(actions[QStringLiteral("actResetLayout")], &QAction::triggered, &window, &MainWindow::resetLayout);
    connect(actions[QStringLiteral("actFullScreen")], &QAction::toggled, &window, [&window](bool on) {
        window.setWindowState(on ? window.windowState() | Qt::WindowFullScreen
                                 : window.windowState() & ~Qt::WindowFullScreen);
    });
}

/// Whoever sees it work for the first time is shown around, once.
void ProgramControl::connectTour()
{
    connect(parts_.window->actions()[QStringLiteral("actTour")], &QAction::triggered, this, &ProgramControl::startTour);
    connect(&parts_.window->welcome(), &WelcomePage::sampleRequested, this,
            [this] { tourIsDue_ = !parts_.settings.value(QStringLiteral("tour/seen"), false).toBool(); });
    connect(&parts_, &WindowParts::mapShown, this, [this] {
        if (tourIsDue_ && !parts_.shown->planes.empty())
            startTour();
    });
}

void ProgramControl::startTour()
{
    tourIsDue_ = false;
    parts_.settings.setValue(QStringLiteral("tour/seen"), true);
    tour_->start(
        {{&parts_.window->view(),
          tr("Line segments appear slice by slice, and planes grow from the fifth slice on. Drag to look "
             "around, click a plane to select it.")},
         {parts_.window->findChild<QWidget*>(QStringLiteral("timelinePanel")),
          tr("Every step of the scan: drag to look back, while it goes on. Space plays it again; dots are fits "
             "of planes, diamonds splits and merges.")},
         {parts_.planesPanel, tr("Every plane with its numbers: sort, filter, name, hide, merge. What is "
                                 "selected here is selected in the view.")},
         {parts_.window->findChild<QWidget*>(QStringLiteral("exportButton")),
          tr("Planes as CSV, JSON, PLY, OBJ or DXF, points, segments and a floor plan.")}});
}

QString ProgramControl::versions() const
{
    Presenter* presenter = parts_.window->view().presenter();
    return tr("Planewright %1\nQt %2\nVTK %3\n%4\n%5\nsource: %6")
        .arg(QStringLiteral(PLANEWRIGHT_VERSION), QString::fromLatin1(qVersion()),
             QString::fromLatin1(vtkVersion::GetVTKVersion()), QSysInfo::prettyProductName(),
             presenter != nullptr ? presenter->rendererName() : tr("no renderer"),
             QString::fromStdString(parts_.session.status().source));
}

void ProgramControl::connectHelp()
{
    WindowActions& actions = parts_.window->actions();
    const auto on = [&](const char* name, auto&& call) {
        connect(actions[QLatin1String(name)], &QAction::triggered, this, call);
    };
    on("actShortcuts", [this, &actions] { ask(new ShortcutsDialog(actions.all(), parts_.window.get())); });
    on("actCommandPalette", [this, &actions] { ask(new CommandPalette(actions.all(), parts_.window.get())); });
    on("actManual", [this] { showPage(tr("Manual"), QStringLiteral(":/manual/window.md")); });
    on("actParameterReference", [this] { showPage(tr("Parameters"), QStringLiteral(":/manual/parameters.md")); });
    on("actBugReport", [this] {
        QApplication::clipboard()->setText(parts_.logPanel->bugReport());
        parts_.say(tr("Versions and the log are on the clipboard."));
    });
    on("actAbout", [this] {
        ask(new AboutDialog({{tr("Planewright"), QStringLiteral(PLANEWRIGHT_VERSION)},
                             {QStringLiteral("Qt"), QString::fromLatin1(qVersion())},
                             {QStringLiteral("VTK"), QString::fromLatin1(vtkVersion::GetVTKVersion())}},
                            parts_.window.get()));
    });
}

void ProgramControl::showPage(const QString& title, const QString& resource)
{
    QFile file(resource);
    auto* dialog = new QDialog(parts_.window.get());
    dialog->setObjectName(QStringLiteral("pageDialog"));
    dialog->setWindowTitle(title);
    dialog->resize(860, 640);
    auto* layout = new QVBoxLayout(dialog);
    auto* text = new QTextBrowser;
    text->setOpenExternalLinks(false);
    text->setAccessibleName(title);
    if (file.open(QIODevice::ReadOnly))
        text->setMarkdown(QString::fromUtf8(file.readAll()));
    layout->addWidget(text);
    ask(dialog);
}

void ProgramControl::openPreferences()
{
    WindowActions& actions = parts_.window->actions();
    PreferencesContext context;
    context.presets = parts_.parameters.presetNames();
    context.actions = actions.all();
    for (const QAction* action : actions.all()) {
        if (WindowActions::isFixed(*action))
            context.keptShortcuts.insert(action->objectName());
    }
    context.advancedActions = {actions[QStringLiteral("actResetLayout")]};
    auto* dialog = new PreferencesDialog(parts_.preferences, context, parts_.window.get());
    connect(dialog, &PreferencesDialog::applied, this, [this](const Preferences& preferences) {
        parts_.preferences = preferences;
        savePreferences(parts_.preferences, parts_.settings);
        emit parts_.preferencesChanged();
    });
    ask(dialog);
}

}  // namespace planewright
