// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/window_actions.h"

#include <algorithm>
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
    Row{"&File", "actImportCloud", "&Import cloud…", "", "Open points as a scan: organised PCD, PTX, or 3DTK's uos"},
    Row{"&File", "actExportPlanes", "Export &planes…", "Ctrl+E", "Planes as CSV, JSON, PLY, OBJ or DXF"},
    Row{"&File", "actExportPoints", "Export poin&ts…", "", "Points with the plane they are of, as PLY or PCD"},
    Row{"&File", "actExportSegments", "Export se&gments…", "", "Line segments as CSV or PLY"},
    Row{"&File", "actExportFloorPlan", "Export &floor plan…", "", "Walls from above as DXF"},
    Row{"&File", "actExportReport", "Export &report…", "", "A page about the scan as HTML"},
    Row{"&File", "", "", "", "", kSeparator},
    Row{"&File", "actScreenshot", "Scr&eenshot", "Ctrl+P", "Write the 3D view to a picture"},
    Row{"&File", "actScreenshotOptions", "Screenshot o&ptions…", "Ctrl+Shift+E", "Write a picture of any size"},
    Row{"&File", "", "", "", "", kSeparator},
    Row{"&File", "actQuit", "&Quit", "Ctrl+Q", "Stop and leave; nothing is unsaved"},

    Row{"&Edit", "actUndo", "&Undo", "Ctrl+Z", "Take back the last edit or re-run"},
    Row{"&Edit", "actRedo", "&Redo", "Ctrl+Shift+Z", "Make it again"},
    Row{"&Edit", "actHistory", "&History…", "", "What was done to the scan, and what of it is undone"},
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

    Row{"&Scan", "actConnect", "&Connect", "Ctrl+K", "Connect the laser and the tilt unit that are chosen"},
    Row{"&Scan", "actStart", "&Start", "F5", "Start scanning"},
    Row{"&Scan", "actNextStop", "&Next stop", "Shift+F5",
        "Take one more scan into the same file, from where the scanner is now"},
    Row{"&Scan", "actPause", "&Pause or continue", "F6", "Hold the scan, or go on"},
    Row{"&Scan", "actStep", "S&ingle step", "",
        "Take one more slice while the scan is held; . does so at its newest step"},
    Row{"&Scan", "actFinish", "&Finish", "F7", "End the scan with what there is"},
    Row{"&Scan", "actStopMotion", "Stop &motion", "Ctrl+.", "Stop the scanner now, in whatever state"},
    Row{"&Scan", "actHome", "&Home actuator", "", "Bring the head to level, slowly, and hold it there"},
    Row{"&Scan", "", "", "", "", kSeparator},
    Row{"&Scan", "actRecord", "&Record scans", "", "Write every scan to the recording folder", kCheckable},
    Row{"&Scan", "actTestDevices", "Device &test…", "", "Open laser and tilt unit, take a slice, move by 5° and back"},
    Row{"&Scan", "actFindDevices", "Fin&d devices", "", "Look for what is connected, and ask lasers for their number"},
    Row{"&Scan", "actRecover", "Re&lease", "",
        "Let the head move again, after Stop motion or after it has turned itself off"},
    Row{"&Scan", "", "", "", "", kSeparator},
    Row{"&Scan", "actRerun", "Re-r&un extraction", "Ctrl+R", "Extract the whole scan with the present parameters"},
    Row{"&Scan", "", "", "", "", kSeparator},
    Row{"&Scan", "actMapMode", "Map of &all stops", "Ctrl+Shift+M",
        "Make one map of all scans of the file and show it, or go back to the scan", kCheckable},
    Row{"&Scan", "actExportMapPlanes", "Export map plan&es…", "", "Planes of the map as CSV, JSON, PLY, OBJ or DXF"},
    Row{"&Scan", "actExportMapPoses", "Export map p&oses…", "", "Corrected poses of the stops in the TUM format"},
    Row{"&Scan", "actExportMapPlan", "E&xport map plan…", "", "Plan of a floor as DXF or SVG"},

    Row{"&Timeline", "actPlay", "&Play", "Space", "Play the steps of the scan again, or pause", kCheckable},
    Row{"&Timeline", "actStepBack", "Step &back", ",; Left", "Look at the step before"},
    Row{"&Timeline", "actStepForward", "Step &forward", ".; Right",
        "Look at the step after; take one more slice while the scan is held at its newest"},
    Row{"&Timeline", "actTenBack", "&Ten steps back", "Ctrl+Left", "Look ten steps back"},
    Row{"&Timeline", "actTenForward", "Te&n steps forward", "Ctrl+Right", "Look ten steps on"},
    Row{"&Timeline", "actFirstStep", "F&irst step", "Home", "Look at the first step"},
    Row{"&Timeline", "actLastStep", "L&ast step", "End", "Look at the last step that there is"},
    Row{"&Timeline", "actLive", "&Live", "L", "Follow the newest step"},
    Row{"&Timeline", "", "", "", "", kSeparator},
    Row{"&Timeline", "actEventBack", "&Event back", "Shift+,", "Go back to the last event of the kind in the timeline"},
    Row{"&Timeline", "actEventForward", "Event forwar&d", "Shift+.",
        "Go to the next event of the kind in the timeline"},
    Row{"&Timeline", "actPhaseBack", "P&hase back", "Alt+,", "Look at the step one phase earlier"},
    Row{"&Timeline", "actPhaseForward", "Pha&se forward", "Alt+.", "Look at the step one phase later"},
    Row{"&Timeline", "", "", "", "", kSeparator},
    Row{"&Timeline", "actLoop", "L&oop", "", "Play a range again and again", kCheckable},
    Row{"&Timeline", "actLoopIn", "Loop f&rom here", "[", "Begin the range that is played again and again here"},
    Row{"&Timeline", "actLoopOut", "Loop &up to here", "]", "End the range that is played again and again here"},
    Row{"&Timeline", "actSlower", "Slo&wer", "-", "Play the steps more slowly"},
    Row{"&Timeline", "actFaster", "Faster (&+)", "=", "Play the steps faster"},
    Row{"&Timeline", "", "", "", "", kSeparator},
    Row{"&Timeline", "actBookmark", "Book&mark", "M", "Mark the step that is looked at, or unmark it"},
    Row{"&Timeline", "actNextBookmark", "Ne&xt bookmark", "N", "Go to the next bookmark, after the last to the first"},

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
    Row{"&Planes", "", "", "", "", kSeparator},
    Row{"&Planes", "actWhyNot", "Wh&y not?…", "Y", "Ask why two planes are not one, or a segment is not in a plane"},

    Row{"&Tools", "actMeasureDistance", "Measure &distance", "D", "Distance between two points", kCheckable},
    Row{"&Tools", "actMeasurePointPlane", "Measure &point to plane", "Shift+D", "Distance of a point from a plane",
        kCheckable},
    Row{"&Tools", "actMeasureAngle", "Measure &angle", "A", "Angle and distance between two planes", kCheckable},
    Row{"&Tools", "", "", "", "", kSeparator},
    Row{"&Tools", "actCompare", "&Compare…", "Ctrl+Shift+C", "Extract the scan once more with other parameters"},
    Row{"&Tools", "actMovingAverages", "&Moving averages", "",
        "An example: a curved wall, clustered by different averages"},
    Row{"&Tools", "", "", "", "", kSeparator},
    Row{"&Tools", "actValidate", "&Validate file…", "", "Find every problem of a recording"},
    Row{"&Tools", "actCommandPalette", "&Command palette…", "Ctrl+Shift+P", "Find and run any command"},

    Row{"&Window", "panels", "&Panels", "", "", kSubmenu},
    Row{"&Window", "actShowCharts", "&Charts", "", "Numbers of every step as charts"},
    Row{"&Window", "actShowSlice", "&Slice 2D", "", "The slice of this step and what became of its points"},
    Row{"&Window", "actLayoutOperate", "&Operate layout", "Ctrl+Alt+1", "Setup, 3D view, planes and timeline"},
    Row{"&Window", "actLayoutInspect", "&Inspect layout", "Ctrl+Alt+2", "Every panel: how the scan came to its planes"},
    Row{"&Window", "actLayoutPresent", "&Present layout", "Ctrl+Alt+3", "The 3D view alone"},
    Row{"&Window", "actLayoutCompare", "&Compare layout", "Ctrl+Alt+4", "Two views and the table of differences"},
    Row{"&Window", "actResetLayout", "&Reset layout", "", "Put every panel back where it was"},

    Row{"&Help", "actTour", "&Quick tour", "", "What is where, in four steps"},
    Row{"&Help", "actShortcuts", "&Shortcuts", "F1", "All shortcuts in a list"},
    Row{"&Help", "actManual", "&Manual", "", "What the program does and how"},
    Row{"&Help", "actParameterReference", "&Parameter reference", "", "Every parameter with its meaning"},
    Row{"&Help", "actBugReport", "Copy &bug report", "", "Copy versions and the log"},
    Row{"&Help", "actAbout", "&About Planewright", "", "Version and licences"},
};

/// A key without Ctrl, Alt or Meta is a letter, or a way about, to whoever types.
bool isSingleKey(const QKeySequence& keys)
{
    if (keys.count() != 1)
        return false;
    const QKeyCombination key = keys[0];
    const bool bare = !(key.keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    constexpr std::array kOfFields{Qt::Key_Escape, Qt::Key_Delete, Qt::Key_Home,
                                   Qt::Key_End,    Qt::Key_Left,   Qt::Key_Right};
    return bare &&
           (key.key() < Qt::Key_Escape || std::find(kOfFields.begin(), kOfFields.end(), key.key()) != kOfFields.end());
}

/// "; " stands between two.
QList<QKeySequence> keysOf(const char* text)
{
    QList<QKeySequence> keys;
    for (const QString& each : QString::fromLatin1(text).split(QStringLiteral("; "), Qt::SkipEmptyParts))
        keys.push_back(QKeySequence(each));
    return keys;
}

QString tipOf(const QString& tip, const QList<QKeySequence>& keys)
{
    QStringList words;
    for (const QKeySequence& each : keys)
        words.push_back(each.toString());
    return words.isEmpty() ? tip : tip + QStringLiteral(" (%1)").arg(words.join(QStringLiteral(" or ")));
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
        const QList<QKeySequence> keys = keysOf(row.shortcut);
        action->setShortcuts(keys);
        action->setToolTip(tipOf(tr(row.tip), keys));
        if (action->objectName() == QLatin1String("actStopMotion"))
            action->setShortcuts({keys.front(), QKeySequence(Qt::Key_Pause)});
        if (!keys.isEmpty() && isSingleKey(keys.front())) {
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

void WindowActions::letKeysWorkIn(QWidget& widget)
{
    for (QAction* action : all_) {
        if (action->shortcutContext() == Qt::WidgetWithChildrenShortcut)
            widget.addAction(action);
    }
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
