// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <utility>

#include <QStringList>
#include <QWidget>

#include "ui/models/compare_model.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace planewright {

class FilteredTable;

/// Which parameters a scan is held against, how far that is, and how both maps differ.
class ComparePanel : public QWidget {
    Q_OBJECT

public:
    /// The model must live as long as this.
    explicit ComparePanel(CompareModel& model, QWidget* parent = nullptr);

    /// What B may be, each with a sentence about it; the choice stays where it is still there.
    void setChoices(const QStringList& names, const QStringList& meanings);
    int choice() const;
    void setChoice(int choice);

    /// How A and B are called, as "precise".
    void setNames(const QString& a, const QString& b);
    /// B is worked out: so many steps of them all.
    void setProgress(int steps, int all);
    /// Nothing is worked out; with a branch it can be closed.
    void setIdle(bool hasBranch);
    /// The totals of both maps at the step that is looked at; null for none.
    void setTotals(const Snapshot* a, const Snapshot* b);

    FilteredTable* table() const { return table_; }

signals:
    void runRequested(int choice);
    /// Ends what is worked out, or takes the second view away.
    void closeRequested();
    /// A row was chosen: the planes of A and B, kNoPlane where there is none.
    void planesChosen(planewright::PlaneId a, planewright::PlaneId b);

private:
    void choose();
    void updateFooter();

    CompareModel& model_;
    QComboBox* choice_;
    QPushButton* run_;
    QPushButton* close_;
    QProgressBar* progress_;
    QLabel* meaning_;
    QLabel* totals_;
    FilteredTable* table_;
    QStringList meanings_;
    QString nameA_;
    QString nameB_;
};

}  // namespace planewright
