// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <vector>

#include <QWidget>

#include "ui/models/parameter_model.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace planewright {

class ParameterGroupBox;
class ProblemLabel;

/// All parameters, group by group in the algorithm's order, under the preset that they are held against.
class ParametersPanel : public QWidget {
    Q_OBJECT

public:
    /// Keeps a preset for the next start; gives what went wrong, or nothing.
    using Keeper = std::function<QString(const QString& name, const Parameters& parameters)>;

    /// The model must live as long as this.
    explicit ParametersPanel(ParameterModel& model, QWidget* parent = nullptr);

    void setPresetKeeper(Keeper keeper) { keeper_ = std::move(keeper); }

    /// While slices come, what cannot change meanwhile is greyed out: the estimator, and what slices are corrected by.
    void setScanning(bool scanning);

    /// Opens the group of a parameter and gives its field the keyboard.
    void showParameter(std::string_view key);

signals:
    /// A change that was made here or elsewhere.
    void parametersChanged(const planewright::Parameters& parameters);

private:
    QWidget* makePresetBox();
    QWidget* makeSaveBox();
    void refresh();
    void fillPresets();
    void beginSave();
    void save();

    ParameterModel& model_;
    Keeper keeper_;
    QComboBox* preset_;
    QLabel* meaning_;
    QPushButton* resetAll_;
    QWidget* saveBox_;
    QLineEdit* saveName_;
    ProblemLabel* saveProblem_;
    QScrollArea* area_;
    std::vector<ParameterGroupBox*> groups_;
};

}  // namespace planewright
