// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <QAbstractItemModel>

#include "ui/models/decision_text.h"
#include "ui/models/inspected_step.h"

namespace planewright {

/// A step as a tree: its phases, their decisions, and the conditions of each. Words are made where they are seen; with
/// their tones they come by kLineRole.
class DecisionsModel : public QAbstractItemModel {
    Q_OBJECT

public:
    using QAbstractItemModel::QAbstractItemModel;

    /// Nothing where there is no step.
    void setStep(std::optional<InspectedStep> step);
    const std::optional<InspectedStep>& step() const { return step_; }
    const std::vector<InspectedPhase>& phases() const { return phases_; }
    void setLengthStyle(const LengthStyle& lengths);

    /// The phase that the 3D view shows, by its number among those that were due; none: all of the step.
    void setShownPhase(std::optional<std::size_t> number);
    std::optional<std::size_t> shownPhase() const { return shown_; }
    QModelIndex indexOfPhase(std::size_t number) const;

    /// The phase that a row is of, or below which it is.
    const InspectedPhase* phaseAt(const QModelIndex& index) const;
    /// The decision that a row is of, or below which it is; null of a phase.
    const Decision* decisionAt(const QModelIndex& index) const;
    const Test* testAt(const QModelIndex& index) const;
    /// The parameter that sets the limit of a condition; empty of other rows and where there is none.
    std::string_view parameterAt(const QModelIndex& index) const;

    /// Rows as tab-separated text with headings: a line for each condition of a decision, and one of a phase.
    QString rowsAsText(const QModelIndexList& rows) const;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    TextLine lineAt(const QModelIndex& index) const;
    TextLine phaseLine(const InspectedPhase& phase) const;
    DecisionContext contextOf(const InspectedPhase& phase, std::size_t decision) const;
    QString tipAt(const QModelIndex& index) const;

    std::optional<InspectedStep> step_;
    std::vector<InspectedPhase> phases_;
    std::optional<std::size_t> shown_;
    LengthStyle lengths_;
};

}  // namespace planewright
