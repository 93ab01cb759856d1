// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QListWidget>
#include <QPushButton>
#include <QWidget>

namespace planewright {

/// What is shown before there is a scan: see it work, open something, connect a scanner, or try another room.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(QWidget* parent = nullptr);

    /// Files that were opened lately, the last first; those that are gone are left out.
    void setRecent(const QStringList& files);

signals:
    /// Somebody wants to see it work: the sample corridor.
    void sampleRequested();
    void openDialogRequested();
    /// Somebody has a scanner.
    void connectRequested();
    /// A file, or an address of a simulated room.
    void openRequested(const QString& fileOrAddress);

private:
    QListWidget* recent_;
};

}  // namespace planewright
