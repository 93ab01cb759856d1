// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/main_window.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace planewright {

namespace {

constexpr int kLayoutVersion = 2;
constexpr QSize kDefaultSize{1440, 900};
constexpr QSize kMinimumSize{1024, 700};
constexpr int kSetupWidth = 300;
constexpr int kPlanesWidth = 420;
constexpr int kLeastSideWidth = 240;  ///< what is at the sides can be used in the smallest window, too
constexpr int kLeastViewWidth = 220;  ///< of each of two
constexpr int kLeastViewWidthAlone = 320;
constexpr int kTimelineHeight = 132;
constexpr int kBottomHeight = 220;
/// The tabs at the bottom from the left, whoever comes first; others follow.
constexpr QLatin1String kBottomOrder[]{QLatin1String("chartsPanel"), QLatin1String("slicePanel"),
                                       QLatin1String("segmentsPanel"), QLatin1String("measurePanel"),
                                       QLatin1String("logPanel")};
constexpr int kBottomHeightSmall = 140;  ///< where the window is lower than this:
constexpr int kLowWindow = 820;

/// The one file or folder that was dropped, where it is one of this machine.
QString droppedFile(const QMimeData& data)
{
    const QList<QUrl> urls = data.urls();
    return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      view_(new View3d),
      views_(new QSplitter),
      actions_(new WindowActions(this, view_)),
      banner_(new Banner),
      welcome_(new WelcomePage),
      pages_(new QStackedWidget),
      bottom_(new QTabWidget),
      source_(new QLabel)
{
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(QStringLiteral("Planewright"));
    setMinimumSize(kMinimumSize);
    resize(kDefaultSize);
    setAcceptDrops(true);
    setDockOptions(AllowTabbedDocks | AllowNestedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);

    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(banner_);
    pages_->addWidget(welcome_);
    views_->setObjectName(QStringLiteral("views"));
    views_->setChildrenCollapsible(false);
    views_->addWidget(view_);
    pages_->addWidget(views_);
    layout->addWidget(pages_, 1);
    setCentralWidget(centre);

    addDock(QStringLiteral("dockSetup"), tr("Setup"), Qt::LeftDockWidgetArea);
    addDock(QStringLiteral("dockPlanes"), tr("Planes"), Qt::RightDockWidgetArea);
    addDock(QStringLiteral("dockInspector"), tr("Step inspector"), Qt::RightDockWidgetArea);
    for (QDockWidget* dock : docks_)
        dock->setMinimumWidth(kLeastSideWidth);
    // Its title is written beside it: it is low and wide.
    QDockWidget* timeline = addDock(QStringLiteral("dockTimeline"), tr("Timeline"), Qt::BottomDockWidgetArea);
    timeline->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable |
                          QDockWidget::DockWidgetVerticalTitleBar);
    timeline->setMinimumHeight(kTimelineHeight);
    QDockWidget* details = addDock(QStringLiteral("dockBottom"), tr("Details"), Qt::BottomDockWidgetArea);
    details->setWidget(bottom_);
    splitDockWidget(timeline, details, Qt::Vertical);
    bottom_->setObjectName(QStringLiteral("bottomTabs"));
    bottom_->setDocumentMode(true);

    actions_->fillMenuBar(*menuBar());
    makeSubmenus();
    makeToolBar();
    makeStatusBar();
    makeViewButtons();
    inspect();
    plainLayout_ = saveState(kLayoutVersion);
    connect(welcome_, &WelcomePage::openRequested, this, &MainWindow::openRequested);
}

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setAccessibleName(title);
    addDockWidget(area, dock);
    docks_[name] = dock;
    QAction* toggle = dock->toggleViewAction();
    toggle->setObjectName(QStringLiteral("actShow_") + name);
    actions_->submenu(QStringLiteral("panels"))->addAction(toggle);
    return dock;
}

void MainWindow::setPanel(const QString& dock, QWidget* panel)
{
    docks_[dock]->setWidget(panel);
}

void MainWindow::addBottomPanel(QWidget* panel, const QString& title)
{
    const auto rank = [](const QString& name) {
        return std::find(std::begin(kBottomOrder), std::end(kBottomOrder), name) - std::begin(kBottomOrder);
    };
    int place = 0;
    while (place < bottom_->count() && rank(bottom_->widget(place)->objectName()) <= rank(panel->objectName()))
        ++place;
    bottom_->insertTab(place, panel, title);
}

void MainWindow::showBottomPanel(const QString& name)
{
    for (int i = 0; i < bottom_->count(); ++i) {
        if (bottom_->widget(i)->objectName() != name)
            continue;
        bottom_->setCurrentIndex(i);
        docks_[QStringLiteral("dockBottom")]->show();
    }
}

void MainWindow::showWelcome(bool shown)
{
    if (!shown && showsMapMode())
        return;
    showMapMode(false);
    pages_->setCurrentWidget(shown ? static_cast<QWidget*>(welcome_) : views_);
    if (shown)
        foldEmpty();
    else
        unfold();
}

void MainWindow::foldEmpty()
{
    if (folded_.isEmpty())
        beforeFold_ = isVisible() || isRestored_ ? saveState(kLayoutVersion) : QByteArray();
    for (const char* name : {"dockInspector", "dockBottom"}) {
        QDockWidget* dock = docks_[QLatin1String(name)];
        if (dock->isHidden() || dock->isFloating())
            continue;
        dock->hide();
        folded_ += QLatin1String(name);
    }
    if (!folded_.isEmpty())
        resizeDocks({docks_[QStringLiteral("dockTimeline")]}, {kTimelineHeight}, Qt::Vertical);
}

/// Everything is as large again as it was, and what somebody has shown or closed meanwhile stays so.
void MainWindow::unfold()
{
    if (folded_.isEmpty())
        return;
    const QStringList folded = std::exchange(folded_, {});
    if (presents())
        return;  // leaving that shows them all
    if (beforeFold_.isEmpty()) {
        for (const QString& name : folded)
            docks_[name]->show();
        useOwnSizes();
        return;
    }
    QHash<QString, bool> isHidden;
    for (auto dock = docks_.cbegin(); dock != docks_.cend(); ++dock)
        isHidden[dock.key()] = dock.value()->isHidden();
    restoreState(beforeFold_, kLayoutVersion);
    for (auto dock = docks_.cbegin(); dock != docks_.cend(); ++dock) {
        if (!folded.contains(dock.key()))
            dock.value()->setHidden(isHidden[dock.key()]);
    }
}

View3d& MainWindow::secondView()
{
    if (secondView_ == nullptr) {
        secondView_ = new View3d;
        secondView_->setObjectName(QStringLiteral("secondView"));
        secondView_->setAccessibleName(tr("3D view of the second extraction"));
        secondView_->hide();
        views_->addWidget(secondView_);
        views_->setStretchFactor(0, 1);
        views_->setStretchFactor(1, 1);
    }
    return *secondView_;
}

void MainWindow::showSecondView(bool shown)
{
    if (!shown && secondView_ == nullptr)
        return;
    secondView().setVisible(shown);
    // Both fit between the panels of the smallest window.
    for (View3d* view : {view_, secondView_})
        view->setMinimumWidth(shown ? kLeastViewWidth : kLeastViewWidthAlone);
    if (shown)
        views_->setSizes({views_->width() / 2, views_->width() / 2});
}

bool MainWindow::showsSecondView() const
{
    return secondView_ != nullptr && !secondView_->isHidden();
}

bool MainWindow::showsWelcome() const
{
    return pages_->currentWidget() == welcome_;
}

void MainWindow::operate()
{
    arrange({QStringLiteral("dockSetup"), QStringLiteral("dockPlanes"), QStringLiteral("dockTimeline")});
}

void MainWindow::inspect()
{
    arrange(docks_.keys());
}

void MainWindow::compare()
{
    arrange({QStringLiteral("dockTimeline"), QStringLiteral("dockBottom")});
}

void MainWindow::arrange(const QStringList& shown)
{
    folded_.clear();
    for (auto dock = docks_.cbegin(); dock != docks_.cend(); ++dock) {
        dock.value()->setFloating(false);
        dock.value()->setVisible(shown.contains(dock.key()));
    }
    useOwnSizes();
}

void MainWindow::useOwnSizes()
{
    resizeDocks({docks_[QStringLiteral("dockSetup")], docks_[QStringLiteral("dockPlanes")]},
                {kSetupWidth, kPlanesWidth}, Qt::Horizontal);
    const int bottom = height() < kLowWindow ? kBottomHeightSmall : kBottomHeight;
    resizeDocks({docks_[QStringLiteral("dockTimeline")], docks_[QStringLiteral("dockBottom")]},
                {kTimelineHeight, bottom}, Qt::Vertical);
    resizeDocks({docks_[QStringLiteral("dockPlanes")], docks_[QStringLiteral("dockInspector")]}, {2, 3}, Qt::Vertical);
}

void MainWindow::showInspector()
{
    QDockWidget* inspector = docks_[QStringLiteral("dockInspector")];
    inspector->show();
    inspector->raise();
}

void MainWindow::present(bool on)
{
    for (QDockWidget* dock : docks_)
        dock->setVisible(!on && !showsMapMode());
    if (showsMapMode())
        mapDock_->setVisible(!on);
    statusBar()->setVisible(!on);
    findChild<QToolBar*>(QStringLiteral("toolBar"))->setVisible(!on);
}

bool MainWindow::presents() const
{
    return findChild<QToolBar*>(QStringLiteral("toolBar"))->isHidden();
}

void MainWindow::resetLayout()
{
    present(false);
    restoreState(plainLayout_, kLayoutVersion);
    inspect();
}

void MainWindow::restoreLayout(QSettings& settings)
{
    const QByteArray geometry = settings.value(QStringLiteral("window/geometry")).toByteArray();
    const QByteArray state = settings.value(QStringLiteral("window/state")).toByteArray();
    isRestored_ = !geometry.isEmpty() && restoreGeometry(geometry) && restoreState(state, kLayoutVersion);
    if (!isRestored_) {
        resize(kDefaultSize);
        restoreState(plainLayout_, kLayoutVersion);
    }
    for (QDockWidget* dock : docks_) {
        if (dock->isFloating() && QGuiApplication::screenAt(dock->frameGeometry().center()) == nullptr)
            dock->setFloating(false);
    }
    folded_.clear();
    if (showsWelcome())
        foldEmpty();
}

void MainWindow::saveLayout(QSettings& settings)
{
    showMapMode(false);
    unfold();
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), saveState(kLayoutVersion));
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (beforeClose)
        beforeClose();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const QString file = droppedFile(*event->mimeData());
    const QFileInfo info(file);
    if (!file.isEmpty() && (info.isFile() || info.isDir()))
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QString file = droppedFile(*event->mimeData());
    if (!file.isEmpty())
        emit openRequested(file);
}

}  // namespace planewright
