// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <set>
#include <utility>

#include <QAction>
#include <QTreeView>

#include "ui/models/decisions_model.h"

namespace planewright {

class LineDelegate;

/// The tree of a step's decisions: rows of as many lines as they need; which phases are open is kept from step to step.
class DecisionTree : public QTreeView {
    Q_OBJECT

public:
    /// The model must live as long as this.
    explicit DecisionTree(DecisionsModel& model, QWidget* parent = nullptr);

    /// "Copy rows", `actCopyDecisions`, Ctrl+C while the tree has the keyboard.
    QAction* copyAction() const { return copyAction_; }
    /// Makes the row of a phase the current one and opens it.
    void showPhase(std::size_t number);

signals:
    /// The link of a row was clicked, or the row was chosen with a double click or Enter.
    void rowActivated(const QModelIndex& index);

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    using PhaseKey = std::pair<int, QString>;

    PhaseKey keyOf(const InspectedPhase& phase) const;
    bool isOverLink(const QPoint& place) const;
    void keepOpen(const QModelIndex& index, bool open);
    void openAgain();
    void copy();

    DecisionsModel& model_;
    LineDelegate* delegate_;
    QAction* copyAction_;
    std::set<PhaseKey> open_;
    std::optional<PhaseKey> current_;
    bool opening_ = false;
};

}  // namespace planewright
