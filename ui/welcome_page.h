// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QListWidget>
#include <QPushButton>
#include <QWidget>

class QBoxLayout;
class QGridLayout;
class QLabel;
class QVBoxLayout;

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

protected:
    /// What is shown is as wide as the view of it.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addCards(QVBoxLayout* page);
    void addRooms(QVBoxLayout* page);
    void arrange(int width);

    QBoxLayout* cards_;
    QGridLayout* rooms_;
    std::vector<QLabel*> lines_;  ///< texts that are wrapped
    QLabel* small_;
    QListWidget* recent_;
};

}  // namespace planewright
