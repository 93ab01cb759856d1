// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <set>
#include <utility>

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

    /// Makes the row of a phase the current one and opens it.
    void showPhase(std::size_t number);

signals:
    /// The link of a row was clicked, or the row was chosen with a double click or Enter.
    void rowActivated(const QModelIndex& index);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    using PhaseKey = std::pair<int, QString>;

    PhaseKey keyOf(const InspectedPhase& phase) const;
    bool isOverLink(const QPoint& place) const;
    void keepOpen(const QModelIndex& index, bool open);
    void openAgain();

    DecisionsModel& model_;
    LineDelegate* delegate_;
    std::set<PhaseKey> open_;
    std::optional<PhaseKey> current_;
    bool opening_ = false;
};

}  // namespace planewright
