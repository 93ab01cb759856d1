// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QWidget>

#include "ui/models/parameter_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace planewright {

class ProblemLabel;

/// One parameter: its name and symbol, the field with its unit, and an arrow back to the preset where it is changed.
/// What is wrong with an input is said below the field, and is not taken over.
class ParameterField : public QWidget {
    Q_OBJECT

public:
    /// The model must live as long as this.
    ParameterField(ParameterModel& model, const ParameterRow& row, QWidget* parent = nullptr);

    std::string_view key() const { return row_.key; }
    QString problem() const;

    /// Shows the model's value.
    void refresh();
    void focusField();

private:
    QWidget* makeField();
    void take(const QString& text);
    void check(const QString& text);

    ParameterModel& model_;
    const ParameterRow& row_;
    QLineEdit* edit_ = nullptr;     // of numbers
    QComboBox* choices_ = nullptr;  // of choices
    QCheckBox* toggle_ = nullptr;   // of switches
    QString shown_;                 // the model's value as it was shown last
    QToolButton* reset_;
    ProblemLabel* problem_;
};

}  // namespace planewright
