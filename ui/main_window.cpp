// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/main_window.h"

#include <algorithm>
#include <iterator>

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace planewright {

namespace {

constexpr int kLayoutVersion = 2;
constexpr QSize kDefaultSize{1440, 900};
constexpr QSize kMinimumSize{1024, 700};
constexpr int kSetupWidth = 300;
constexpr int kPlanesWidth = 420;
constexpr int kLeastSideWidth = 240;  ///< what is at the sides can be used in the smallest window, too
constexpr int kTimelineHeight = 132;
constexpr int kBottomHeight = 220;
/// The tabs at the bottom from the left, whoever comes first; others follow.
constexpr QLatin1String kBottomOrder[]{QLatin1String("chartsPanel"), QLatin1String("slicePanel"),
                                       QLatin1String("segmentsPanel"), QLatin1String("measurePanel"),
                                       QLatin1String("logPanel")};
constexpr int kBottomHeightSmall = 140;  ///< where the window is lower than this:
constexpr int kLowWindow = 820;

/// The one file that was dropped, where it is a file of this machine.
QString droppedFile(const QMimeData& data)
{
    const QList<QUrl> urls = data.urls();
    return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

/// A button answers Space while it has the keyboard, whatever else Space does in the view around it.
class SpaceIsOfButtons : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* /*watched*/, QEvent* event) override
    {
        if (event->type() != QEvent::ShortcutOverride || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Space)
            return false;
        event->accept();
        return true;
    }
};

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
    pages_->setCurrentWidget(shown ? static_cast<QWidget*>(welcome_) : views_);
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

void MainWindow::makeToolBar()
{
    QToolBar* bar = addToolBar(tr("Scan"));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    source_->setObjectName(QStringLiteral("source"));
    source_->setAccessibleName(tr("Source"));
    source_->setContentsMargins(8, 0, 12, 0);
    source_->setMinimumWidth(160);
    bar->addWidget(source_);
    bar->addSeparator();
    struct Button {
        const char* action;
        const char* text;
    };
    constexpr Button kButtons[]{{"actRecord", "● REC"},
                                {"actStart", "▶ Scan"},
                                {"actPause", "❚❚ Pause"},
                                {"actFinish", "■ Finish"},
                                {"actStopMotion", "Stop motion"},
                                {"", ""},
                                {"actOpen", "Open"},
                                {"actExportPlanes", "Export"},
                                {"actScreenshot", "Screenshot"},
                                {"", ""},
                                {"actShortcuts", "?"}};
    for (const Button& button : kButtons) {
        if (*button.action == '\0') {
            bar->addSeparator();
            continue;
        }
        QAction* action = (*actions_)[QLatin1String(button.action)];
        action->setIconText(tr(button.text));
        bar->addAction(action);
        bar->widgetForAction(action)->setMinimumHeight(30);
        bar->widgetForAction(action)->setAccessibleName(QString(action->text()).remove(QLatin1Char('&')));
    }
    auto* exports = static_cast<QToolButton*>(bar->widgetForAction((*actions_)[QStringLiteral("actExportPlanes")]));
    exports->setObjectName(QStringLiteral("exportButton"));
    exports->setPopupMode(QToolButton::MenuButtonPopup);
    for (const char* name :
         {"actExportPlanes", "actExportPoints", "actExportSegments", "actExportFloorPlan", "actExportReport"})
        exports->addAction((*actions_)[QLatin1String(name)]);
    // Stopping must be found at once.
    bar->widgetForAction((*actions_)[QStringLiteral("actStopMotion")])
        ->setStyleSheet(QStringLiteral("QToolButton { font-weight: bold; color: white; background: #b3261e; "
                                       "border-radius: 4px; padding: 2px 10px; }"));
}

void MainWindow::makeStatusBar()
{
    for (const char* name : {"stDevice", "stHealth", "stLoss", "stQueue", "stStep", "stRec", "stCoord", "stMessage"}) {
        auto* label = new QLabel;
        label->setObjectName(QLatin1String(name));
        label->setContentsMargins(6, 0, 6, 0);
        label->setTextFormat(Qt::PlainText);
        const bool message = QLatin1String(name) == QLatin1String("stMessage");
        statusBar()->addWidget(label, message ? 1 : 0);
        status_[QLatin1String(name)] = label;
    }
}

void MainWindow::setStatus(const QString& item, const QString& text, const QString& tip, bool warns)
{
    QLabel* label = status_[item];
    label->setText(text);
    label->setToolTip(tip);
    label->setStyleSheet(warns ? QStringLiteral("background: #8a5a00; color: white;") : QString());
}

void MainWindow::setSource(const QString& source)
{
    source_->setText(source.isEmpty() ? tr("No scan") : source);
}

/// Buttons over the corner of the 3D view.
void MainWindow::makeViewButtons()
{
    auto* corner = new QWidget(view_);
    corner->setObjectName(QStringLiteral("viewButtons"));
    auto* row = new QHBoxLayout(corner);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    auto* space = new SpaceIsOfButtons(corner);
    for (const char* name : {"actViewTop", "actViewFront", "actViewSide", "actViewIso", "actViewFit"}) {
        auto* button = new QToolButton;
        button->setDefaultAction((*actions_)[QLatin1String(name)]);
        button->setText(QLatin1String(name) == QLatin1String("actViewFit")
                            ? tr("Fit")
                            : QString((*actions_)[QLatin1String(name)]->text()).remove(QLatin1Char('&')));
        button->setMinimumSize(40, 28);
        button->setFocusPolicy(Qt::TabFocus);
        button->installEventFilter(space);
        row->addWidget(button);
    }
    auto* overlay = new QVBoxLayout(view_);
    overlay->setContentsMargins(0, 10, 10, 0);
    auto* top = new QHBoxLayout;
    top->addStretch(1);
    top->addWidget(corner);
    overlay->addLayout(top);
    overlay->addStretch(1);
}

void MainWindow::makeSubmenus()
{
    for (int i = 1; i <= 9; ++i) {
        const auto add = [&](const char* menu, const char* name, const QString& text, const QString& shortcut) {
            auto* action = new QAction(text, this);
            action->setObjectName(QLatin1String(name) + QString::number(i));
            action->setShortcut(QKeySequence(shortcut));
            actions_->submenu(QLatin1String(menu))->addAction(action);
        };
        add("storeView", "actStoreView", tr("View &%1").arg(i), QStringLiteral("Ctrl+%1").arg(i));
        add("recallView", "actRecallView", tr("View &%1").arg(i), QStringLiteral("Alt+%1").arg(i));
    }
}

void MainWindow::operate()
{
    arrange({QStringLiteral("dockSetup"), QStringLiteral("dockPlanes"), QStringLiteral("dockTimeline")});
}

void MainWindow::inspect()
{
    arrange(docks_.keys());
    resizeDocks({docks_[QStringLiteral("dockPlanes")], docks_[QStringLiteral("dockInspector")]}, {2, 3}, Qt::Vertical);
}

void MainWindow::arrange(const QStringList& shown)
{
    for (auto dock = docks_.cbegin(); dock != docks_.cend(); ++dock) {
        dock.value()->setFloating(false);
        dock.value()->setVisible(shown.contains(dock.key()));
    }
    resizeDocks({docks_[QStringLiteral("dockSetup")], docks_[QStringLiteral("dockPlanes")]},
                {kSetupWidth, kPlanesWidth}, Qt::Horizontal);
    const int bottom = height() < kLowWindow ? kBottomHeightSmall : kBottomHeight;
    resizeDocks({docks_[QStringLiteral("dockTimeline")], docks_[QStringLiteral("dockBottom")]},
                {kTimelineHeight, bottom}, Qt::Vertical);
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
        dock->setVisible(!on);
    statusBar()->setVisible(!on);
    findChild<QToolBar*>(QStringLiteral("toolBar"))->setVisible(!on);
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
    if (geometry.isEmpty() || !restoreGeometry(geometry) || !restoreState(state, kLayoutVersion)) {
        resize(kDefaultSize);
        restoreState(plainLayout_, kLayoutVersion);
        return;
    }
    for (QDockWidget* dock : docks_) {
        if (dock->isFloating() && QGuiApplication::screenAt(dock->frameGeometry().center()) == nullptr)
            dock->setFloating(false);
    }
}

void MainWindow::saveLayout(QSettings& settings) const
{
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
    if (!file.isEmpty() && QFileInfo(file).isFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QString file = droppedFile(*event->mimeData());
    if (!file.isEmpty())
        emit openRequested(file);
}

}  // namespace planewright
