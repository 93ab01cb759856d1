// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/copy_rows.h"

#include <algorithm>

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>

namespace planewright {

CopyRows::CopyRows(QAbstractItemView* view, const QString& objectName,
                   std::function<QString(const QModelIndexList& rows)> textOf)
    : QAction(tr("Copy rows\tCtrl+C"), view), view_(view), textOf_(std::move(textOf))
{
    setObjectName(objectName);
    setIconText(tr("Copy rows"));
    view->addAction(this);
    view->setContextMenuPolicy(Qt::ActionsContextMenu);
    view->installEventFilter(this);
    connect(this, &QAction::triggered, this, &CopyRows::copy);
}

void CopyRows::copy()
{
    QModelIndexList rows = view_->selectionModel()->selectedRows();
    std::sort(rows.begin(), rows.end(), [this](const QModelIndex& a, const QModelIndex& b) {
        return view_->visualRect(a).top() < view_->visualRect(b).top();
    });
    QGuiApplication::clipboard()->setText(textOf_(rows));
}

bool CopyRows::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (QKeySequence(QKeySequence::Copy) == QKeySequence(key->keyCombination())) {
            event->accept();  // what is accepted here comes as a key and not as a shortcut of the window
            if (event->type() == QEvent::KeyPress)
                trigger();
            return true;
        }
    }
    return QAction::eventFilter(watched, event);
}

}  // namespace planewright
