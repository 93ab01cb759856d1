// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/window_actions.h"

#include <array>
#include <cassert>

#include <QKeySequence>

namespace planewright {

namespace {

enum Kind { kPlain, kCheckable, kSeparator, kSubmenu };

/// One row of the table. Names of actions begin with "act"; a submenu's name is what submenu() finds it by.
struct Row {
    const char* menu;
    const char* name;
    const char* text;
    const char* shortcut;
    const char* tip;
    Kind kind = kPlain;
};

constexpr std::array kRows{
    Row{"&File", "actNewSimulated", "&New simulated scan", "Ctrl+N", "Scan a simulated room"},
    Row{"&File", "actOpen", "&Open…", "Ctrl+O", "Open a recording or a project"},
    Row{"&File", "recent", "Open &recent", "", "", kSubmenu},
    Row{"&File", "actSave", "&Save", "Ctrl+S", "Everything is in the file at once"},
    Row{"&File", "actSaveCopy", "Save a &copy as…", "Ctrl+Shift+S", "Write the scan to another recording"},
    Row{"&File", "", "", "", "", kSeparator},
    Row{"&File", "actExportPlanes", "Export &planes…", "Ctrl+E", "Planes as CSV, JSON, PLY, OBJ or DXF"},
    Row{"&File", "actExportPoints", "Export poin&ts…", "", "Points with the plane they are of, as PLY or PCD"},
    Row{"&File", "actExportSegments", "Export se&gments…", "", "Line segments as CSV or PLY"},
    Row{"&File", "actExportFloorPlan", "Export &floor plan…", "", "Walls from above as DXF"},
    Row{"&File", "", "", "", "", kSeparator},
    Row{"&File", "actScreenshot", "Scr&eenshot", "Ctrl+P", "Write the 3D view to a picture"},
    Row{"&File", "actScreenshotOptions", "Screenshot o&ptions…", "Ctrl+Shift+E", "Write a picture of any size"},
    Row{"&File", "", "", "", "", kSeparator},
    Row{"&File", "actQuit", "&Quit", "Ctrl+Q", "Stop and leave; nothing is unsaved"},

    Row{"&Edit", "actUndo", "&Undo", "Ctrl+Z", "Take back the last edit"},
    Row{"&Edit", "actRedo", "&Redo", "Ctrl+Shift+Z", "Make the edit again"},
    Row{"&Edit", "", "", "", "", kSeparator},
    Row{"&Edit", "actCopy", "&Copy", "Ctrl+C", "Copy the selected rows as text with tabs"},
    Row{"&Edit", "actSelectAll", "Select &all planes", "Ctrl+A", "Select every plane that is shown"},
    Row{"&Edit", "actSelectInvert", "&Invert selection", "Ctrl+I", "Select the planes that are not selected"},
    Row{"&Edit", "actSelectNone", "Select &none", "Esc", "Select nothing"},
    Row{"&Edit", "actFindPlane", "&Find plane", "Ctrl+F", "Go to the filter of the planes table"},
    Row{"&Edit", "", "", "", "", kSeparator},
    Row{"&Edit", "actPreferences", "&Preferences…", "Ctrl+,", "Change how the program looks and works"},

    Row{"&View", "actViewTop", "&Top", "7", "Look from above"},
    Row{"&View", "actViewFront", "&Front", "1", "Look forward"},
    Row{"&View", "actViewSide", "&Side", "3", "Look from the right"},
    Row{"&View", "actViewIso", "&Iso", "0", "Look down from behind"},
    Row{"&View", "actViewSensor", "S&ensor", "5", "Look from where the scanner is"},
    Row{"&View", "actViewFit", "Fit &all", "F", "Show all of the scan"},
    Row{"&View", "actViewFitSelection", "Fit se&lection", "Shift+F", "Show what is selected"},
    Row{"&View", "actParallel", "Pa&rallel projection", "O", "Without perspective", kCheckable},
    Row{"&View", "", "", "", "", kSeparator},
    Row{"&View", "storeView", "Sa&ve view", "", "", kSubmenu},
    Row{"&View", "recallView", "Recall vie&w", "", "", kSubmenu},
    Row{"&View", "", "", "", "", kSeparator},
    Row{"&View", "colourBy", "&Colour by", "", "", kSubmenu},
    Row{"&View", "actNextColourBy", "Next colou&ring", "C", "Colour by the next property"},
    Row{"&View", "actLayerPoints", "&Points", "P", "Show or hide scan points", kCheckable},
    Row{"&View", "actLayerSegments", "Se&gments", "G", "Show or hide line segments", kCheckable},
    Row{"&View", "actLayerClusters", "Cl&usters", "K", "Show or hide clusters", kCheckable},
    Row{"&View", "actLayerPlanes", "Pla&nes", "H", "Show or hide planes", kCheckable},
    Row{"&View", "actLayerUnfitted", "Unfitte&d segments", "U", "Show or hide segments of no plane", kCheckable},
    Row{"&View", "actLayerUncertainty", "Uncertaint&y", "", "Show end points' uncertainty of the selection",
        kCheckable},
    Row{"&View", "actLayerSensor", "Sens&or and grid", "", "Show or hide scanner and grid", kCheckable},
    Row{"&View", "", "", "", "", kSeparator},
    Row{"&View", "actClipBox", "Clip &box", "B", "Show only what is in a box", kCheckable},
    Row{"&View", "actWalkMode", "Wal&k mode", "", "Walk with W A S D Q E in the 3D view", kCheckable},
    Row{"&View", "theme", "T&heme", "", "", kSubmenu},
    Row{"&View", "actFullScreen", "Full scree&n", "F11", "Use the whole screen", kCheckable},

    Row{"&Scan", "actStart", "&Start", "F5", "Start scanning"},
    Row{"&Scan", "actPause", "&Pause or continue", "F6", "Hold the scan, or go on"},
    Row{"&Scan", "actStep", "S&ingle step", ".", "Take one more slice while the scan is held"},
    Row{"&Scan", "actFinish", "&Finish", "F7", "End the scan with what there is"},
    Row{"&Scan", "actStopMotion", "Stop &motion", "Ctrl+.", "Stop the scanner now, in whatever state"},
    Row{"&Scan", "actHome", "&Home actuator", "", "Bring the head to level, slowly, and hold it there"},
    Row{"&Scan", "", "", "", "", kSeparator},
    Row{"&Scan", "actRecord", "&Record scans", "", "Write every scan to the recording folder", kCheckable},
    Row{"&Scan", "actRerun", "Re-r&un extraction", "Ctrl+R", "Extract the whole scan with the present parameters"},

    Row{"&Planes", "actRename", "&Rename", "F2", "Name the selected plane"},
    Row{"&Planes", "class", "&Class", "", "", kSubmenu},
    Row{"&Planes", "actHide", "&Hide", "X", "Hide the selected planes"},
    Row{"&Planes", "actIsolate", "&Isolate", "I", "Hide all planes but the selected"},
    Row{"&Planes", "actShowAll", "&Show all", "Shift+X", "Show hidden planes again"},
    Row{"&Planes", "", "", "", "", kSeparator},
    Row{"&Planes", "actMerge", "&Merge", "Ctrl+M", "Make one plane of the selected"},
    Row{"&Planes", "actSplit", "S&plit again", "Ctrl+T", "Take the selected plane apart"},
    Row{"&Planes", "actLock", "&Lock", "Ctrl+L", "Keep edits away from the selected planes"},
    Row{"&Planes", "actDelete", "&Delete", "Del", "Take the selected planes out of the map"},

    Row{"&Tools", "actMeasureDistance", "Measure &distance", "D", "Distance between two points", kCheckable},
    Row{"&Tools", "actMeasurePointPlane", "Measure &point to plane", "Shift+D", "Distance of a point from a plane",
        kCheckable},
    Row{"&Tools", "actMeasureAngle", "Measure &angle", "A", "Angle and distance between two planes", kCheckable},
    Row{"&Tools", "", "", "", "", kSeparator},
    Row{"&Tools", "actValidate", "&Validate file…", "", "Find every problem of a recording"},
    Row{"&Tools", "actCommandPalette", "&Command palette…", "Ctrl+Shift+P", "Find and run any command"},

    Row{"&Window", "panels", "&Panels", "", "", kSubmenu},
    Row{"&Window", "actLayoutOperate", "&Operate layout", "Ctrl+Alt+1", "Setup, 3D view and planes"},
    Row{"&Window", "actLayoutPresent", "&Present layout", "Ctrl+Alt+3", "The 3D view alone"},
    Row{"&Window", "actResetLayout", "&Reset layout", "", "Put every panel back where it was"},

    Row{"&Help", "actTour", "&Quick tour", "", "What is where, in four steps"},
    Row{"&Help", "actShortcuts", "&Shortcuts", "F1", "All shortcuts in a list"},
    Row{"&Help", "actManual", "&Manual", "", "What the program does and how"},
    Row{"&Help", "actParameterReference", "&Parameter reference", "", "Every parameter with its meaning"},
    Row{"&Help", "actBugReport", "Copy &bug report", "", "Copy versions and the log"},
    Row{"&Help", "actAbout", "&About Planewright", "", "Version and licences"},
};

/// A key without Ctrl, Alt or Meta is a letter to whoever types.
bool isSingleKey(const QKeySequence& keys)
{
    if (keys.count() != 1)
        return false;
    const QKeyCombination key = keys[0];
    const bool bare = !(key.keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    return bare && (key.key() < Qt::Key_Escape || key.key() == Qt::Key_Delete || key.key() == Qt::Key_Escape);
}

}  // namespace

WindowActions::WindowActions(QWidget* window, QWidget* view) : QObject(window), window_(window)
{
    for (const Row& row : kRows) {
        if (row.kind == kSeparator)
            continue;
        if (row.kind == kSubmenu) {
            auto* menu = new QMenu(tr(row.text), window);
            menu->setObjectName(QStringLiteral("menu") + QLatin1String(row.name));
            submenus_[QLatin1String(row.name)] = menu;
            continue;
        }
        auto* action = new QAction(tr(row.text), this);
        action->setObjectName(QLatin1String(row.name));
        action->setCheckable(row.kind == kCheckable);
        action->setStatusTip(tr(row.tip));
        const QKeySequence keys(QLatin1String(row.shortcut));
        if (!keys.isEmpty())
            action->setShortcut(keys);
        if (action->objectName() == QLatin1String("actStopMotion"))
            action->setShortcuts({keys, QKeySequence(Qt::Key_Pause)});
        const QString shortcut = keys.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(keys.toString());
        action->setToolTip(tr(row.tip) + shortcut);
        if (isSingleKey(keys)) {
            action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
            view->addAction(action);
        } else {
            window->addAction(action);
        }
        all_.push_back(action);
        byName_[action->objectName()] = action;
    }
}

QAction* WindowActions::operator[](const QString& name) const
{
    QAction* action = byName_.value(name);
    assert(action != nullptr);
    return action;
}

void WindowActions::fillMenuBar(QMenuBar& bar)
{
    QHash<QString, QMenu*> menus;
    for (const Row& row : kRows) {
        const QString title = QLatin1String(row.menu);
        QMenu*& menu = menus[title];
        if (menu == nullptr) {
            menu = bar.addMenu(tr(row.menu));
            menu->setObjectName(QStringLiteral("menu") + QString(title).remove(QLatin1Char('&')));
        }
        if (row.kind == kSeparator)
            menu->addSeparator();
        else if (row.kind == kSubmenu)
            menu->addMenu(submenus_[QLatin1String(row.name)]);
        else
            menu->addAction(byName_[QLatin1String(row.name)]);
    }
}

bool WindowActions::isFixed(const QAction& action)
{
    return action.objectName() == QLatin1String("actStopMotion");
}

}  // namespace planewright
