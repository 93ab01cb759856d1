// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <set>
#include <vector>

#include <QWidget>

#include "ui/models/decisions_model.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace planewright {

class DecisionTree;

/// How a step went: its numbers, then its phases with every decision.
class InspectorPanel : public QWidget {
    Q_OBJECT

public:
    explicit InspectorPanel(QWidget* parent = nullptr);

    /// Nothing where there is no step.
    void setStep(std::optional<InspectedStep> step);
    /// The phase that the 3D view shows, by its number among those that were due; none: all of the step.
    void setShownPhase(std::optional<std::size_t> number);
    void setLengthStyle(const LengthStyle& lengths) { model_.setLengthStyle(lengths); }

    const DecisionsModel& model() const { return model_; }
    DecisionTree* tree() const { return tree_; }
    /// What stands above the tree, as plain text.
    QString header() const;
    /// The text that stands in the tree's place, or nothing.
    QString shownInstead() const;

signals:
    /// The panel has come into view.
    void shown();
    /// What the chosen rows are about.
    void operandsChosen(const std::vector<planewright::Operand>& operands);
    void phaseRequested(std::size_t number);
    void parameterRequested(const QString& key);
    void playPhaseRequested();
    void whyNotRequested();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void tellChosen();
    void activate(const QModelIndex& index);

    DecisionsModel model_;
    QLabel* header_;
    QPushButton* play_;
    QStackedWidget* stack_;
    QLabel* instead_;
    DecisionTree* tree_;
};

}  // namespace planewright
