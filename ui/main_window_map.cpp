// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <utility>

#include "ui/main_window.h"

namespace planewright {

namespace {

constexpr int kMapWidth = 520;

}  // namespace

View3d& MainWindow::mapView()
{
    if (mapView_ == nullptr) {
        mapView_ = new View3d;
        mapView_->setObjectName(QStringLiteral("mapView"));
        mapView_->setAccessibleName(tr("3D view of the map"));
        actions_->letKeysWorkIn(*mapView_);
        pages_->addWidget(mapView_);
    }
    return *mapView_;
}

View3d& MainWindow::shownView()
{
    return showsMapMode() ? *mapView_ : *view_;
}

bool MainWindow::showsMapMode() const
{
    return mapView_ != nullptr && pages_->currentWidget() == mapView_;
}

void MainWindow::showMapMode(bool shown, QWidget* panel)
{
    if (shown == showsMapMode())
        return;
    if (!shown) {
        mapDock_->hide();
        for (const QString& name : std::exchange(besideMap_, {}))
            docks_[name]->show();
        pages_->setCurrentWidget(views_);
        return;
    }
    if (mapDock_ == nullptr) {
        // No part of the layout that is kept: it is there with the map alone.
        mapDock_ = new QDockWidget(tr("Map"), this);
        mapDock_->setObjectName(QStringLiteral("dockMap"));
        mapDock_->setAccessibleName(tr("Map"));
        mapDock_->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
        mapDock_->setWidget(panel);
        panel->show();
        addDockWidget(Qt::RightDockWidgetArea, mapDock_);
    }
    for (auto dock = docks_.cbegin(); dock != docks_.cend(); ++dock) {
        if (!dock.value()->isHidden()) {
            besideMap_.push_back(dock.key());
            dock.value()->hide();
        }
    }
    mapDock_->show();
    resizeDocks({mapDock_}, {kMapWidth}, Qt::Horizontal);
    pages_->setCurrentWidget(&mapView());
}

}  // namespace planewright
