// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include <QAbstractItemView>
#include <QAction>

namespace planewright {

/// "Copy rows" of a view, in its context menu and by Ctrl+C while it has the keyboard, whatever that means in the
/// window: shortcuts of both would be ambiguous, and neither would be done.
class CopyRows : public QAction {
    Q_OBJECT

public:
    /// `textOf` makes the text of the chosen rows, in the order in which they stand. Belongs to the view.
    CopyRows(QAbstractItemView* view, const QString& objectName,
             std::function<QString(const QModelIndexList& rows)> textOf);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void copy();

    QAbstractItemView* view_;
    std::function<QString(const QModelIndexList& rows)> textOf_;
};

}  // namespace planewright
