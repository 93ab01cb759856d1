// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QWidget>

#include "ui/models/why_not_model.h"

class QComboBox;
class QLabel;
class QTableView;

namespace planewright {

/// Asks why two planes are not one, or a segment is not in a plane, and shows all conditions of the answer.
class WhyNotPanel : public QWidget {
    Q_OBJECT

public:
    explicit WhyNotPanel(QWidget* parent = nullptr);

    /// The planes that the boxes offer; segments are typed.
    void setPlanes(const std::vector<PlaneId>& planes);
    /// Puts two operands into the boxes; nobody is asked.
    void setOperands(const Operand& first, const Operand& second);
    /// What is in the boxes, where it is a plane or a segment.
    std::optional<Operand> first() const;
    std::optional<Operand> second() const;

    /// The answer, as things are at a step.
    void setAnswer(WhyNot answer, const QString& step);
    /// Why there is no answer.
    void setProblem(const QString& text);
    void setLengthStyle(const LengthStyle& lengths) { model_.setLengthStyle(lengths); }

    const WhyNotModel& model() const { return model_; }
    QTableView* table() const { return table_; }
    /// The sentence above the table.
    QString sentence() const;

signals:
    /// The panel has come into view.
    void shown();
    /// The boxes hold something else to be asked about.
    void asked();
    void parameterRequested(const QString& key);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void makeTable();

    WhyNotModel model_;
    std::array<QComboBox*, 2> boxes_;
    QLabel* sentence_;
    QTableView* table_;
};

}  // namespace planewright
