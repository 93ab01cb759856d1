// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// The window's tool bar, status bar, buttons over the view and numbered menus.

#include <QKeyEvent>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/main_window.h"

namespace planewright {

namespace {

constexpr int kCornerMargin = 10;  // [px]

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
    overlay->setContentsMargins(0, kCornerMargin, kCornerMargin, 0);
    auto* top = new QHBoxLayout;
    top->addStretch(1);
    top->addWidget(corner);
    overlay->addLayout(top);
    overlay->addStretch(1);
    view_->keepCornerFree(corner->sizeHint() + QSize(kCornerMargin, kCornerMargin));
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

}  // namespace planewright
