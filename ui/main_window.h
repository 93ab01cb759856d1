// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include <QDockWidget>
#include <QHash>
#include <QLabel>
#include <QMainWindow>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>

#include "ui/banner.h"
#include "ui/view3d/view3d.h"
#include "ui/welcome_page.h"
#include "ui/window_actions.h"

namespace planewright {

/// The window: arranges view, panels, actions and status; what they do is connected from outside.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);

    View3d& view() { return *view_; }
    /// Beside the first one while it is shown; made when it is asked for first, and then presents nothing yet.
    View3d& secondView();
    void showSecondView(bool shown);
    bool showsSecondView() const;
    /// In the place of the first one while a map of several stops is shown; made when it is asked for first.
    View3d& mapView();
    /// The view that is to be seen: of the map, or the first one.
    View3d& shownView();
    /// The map's view, and its panel at the side in the place of all others, which come back as they were.
    void showMapMode(bool shown, QWidget* panel = nullptr);
    bool showsMapMode() const;
    WindowActions& actions() { return *actions_; }
    Banner& banner() { return *banner_; }
    WelcomePage& welcome() { return *welcome_; }

    /// Puts panels where they belong: "dockSetup", "dockPlanes", "dockInspector", "dockTimeline".
    void setPanel(const QString& dock, QWidget* panel);
    /// A tab of the dock at the bottom, by its objectName; tabs that are known stand in their order.
    void addBottomPanel(QWidget* panel, const QString& title);
    void showBottomPanel(const QString& name);
    void showInspector();

    /// What is empty without a scan is folded away meanwhile.
    void showWelcome(bool shown);
    bool showsWelcome() const;

    /// Text and tool tip of a status item: "stDevice", "stLoss", "stQueue", "stStep", "stRec", "stCoord", "stMessage".
    void setStatus(const QString& item, const QString& text, const QString& tip = {}, bool warns = false);

    void setSource(const QString& source);

    // Layouts: what a scan is run with; every panel, as at the first start; two views over
    // timeline and table; the view alone.
    void operate();
    void inspect();
    void compare();
    void present(bool on);
    /// The view stands alone.
    bool presents() const;
    void resetLayout();
    /// Docks and sizes of the last time; a layout of another version, or one off the screen, is left alone.
    void restoreLayout(QSettings& settings);
    void saveLayout(QSettings& settings);

    /// Asked before the window closes; it always may, but something may have to stop first.
    std::function<void()> beforeClose;

signals:
    void openRequested(const QString& fileOrAddress);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    QDockWidget* addDock(const QString& name, const QString& title, Qt::DockWidgetArea area);
    void arrange(const QStringList& shown);
    void foldEmpty();
    void unfold();
    void useOwnSizes();
    void makeToolBar();
    void makeStatusBar();
    void makeViewButtons();
    void makeSubmenus();

    View3d* view_;
    View3d* secondView_ = nullptr;
    View3d* mapView_ = nullptr;
    QDockWidget* mapDock_ = nullptr;
    QStringList besideMap_;  ///< docks that come back after the map
    QSplitter* views_;
    WindowActions* actions_;
    Banner* banner_;
    WelcomePage* welcome_;
    QStackedWidget* pages_;
    QHash<QString, QDockWidget*> docks_;
    QTabWidget* bottom_;
    QHash<QString, QLabel*> status_;
    QLabel* source_;
    QByteArray plainLayout_;
    QStringList folded_;     ///< docks that come back with a scan
    QByteArray beforeFold_;  ///< the layout then; empty: nobody has seen it yet
    bool isRestored_ = false;
};

}  // namespace planewright
