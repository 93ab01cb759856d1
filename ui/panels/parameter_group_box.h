// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QWidget>

#include "ui/models/parameter_model.h"

class QToolButton;

namespace planewright {

class ParameterField;

/// The parameters of a phase under their title, which folds them away.
class ParameterGroupBox : public QWidget {
    Q_OBJECT

public:
    ParameterGroupBox(ParameterModel& model, const ParameterGroup& group, QWidget* parent = nullptr);

    const std::vector<ParameterField*>& fields() const { return fields_; }
    void setOpen(bool open);
    /// Shows the model's values, and in the title how many are changed.
    void refresh();

private:
    ParameterModel& model_;
    QString title_;
    QToolButton* header_;
    QWidget* body_;
    std::vector<ParameterField*> fields_;
};

}  // namespace planewright
