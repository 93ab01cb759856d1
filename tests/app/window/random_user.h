// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <random>

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <QWidget>

#include "tests/app/window/shown_window.h"

namespace planewright {

/// Somebody who presses whatever there is: actions, buttons, keys, cells, the view, docks and dialogs, in an order that
/// follows from the seed. Files are read and written in one folder only.
class RandomUser : public QObject {
public:
    RandomUser(ShownWindow& shown, QString folder, unsigned seed);

    /// One event, and what it leads to.
    void act();
    /// What was done last, the newest at the end.
    const QStringList& deeds() const { return deeds_; }

private:
    int below(int count);
    bool chance(int percent) { return below(100) < percent; }
    void note(const QString& deed);
    QWidget* anyOf(const QList<QWidget*>& widgets);
    QString anyFile();

    void triggerAction();
    void useMouseInView();
    void pressKey(QWidget* target);
    void useWidget(QWidget* within);
    void useTable(QWidget* within);
    void arrange();
    /// A dialog or a menu holds the program until it is answered.
    void answerDialog();

    ShownWindow& shown_;
    QString folder_;
    std::mt19937 random_;
    QTimer dialogs_;
    int patience_ = 0;
    QStringList deeds_;
};

}  // namespace planewright
