// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/parameters_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/panels/parameter_field.h"
#include "ui/panels/parameter_group_box.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/problem_label.h"

namespace planewright {

ParametersPanel::ParametersPanel(ParameterModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      preset_(new QuietComboBox(this)),
      meaning_(new QLabel(this)),
      resetAll_(new QPushButton(tr("Reset all"), this)),
      saveName_(new QLineEdit(this)),
      saveProblem_(new ProblemLabel(this))
{
    setObjectName(QStringLiteral("parametersPanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(makePresetBox());
    saveBox_ = makeSaveBox();
    layout->addWidget(saveBox_);

    auto* content = new QWidget(this);
    auto* groups = new QVBoxLayout(content);
    groups->setContentsMargins(0, 0, 4, 8);
    groups->setSpacing(4);
    for (const ParameterGroup& group : parameterGroups()) {
        groups_.push_back(new ParameterGroupBox(model, group, content));
        groups->addWidget(groups_.back());
    }
    groups->addStretch();
    area_ = scrolling(content, this);
    layout->addWidget(area_, 1);

    connect(&model_, &ParameterModel::parametersChanged, this, [this](const Parameters& parameters) {
        refresh();
        emit parametersChanged(parameters);
    });
    connect(&model_, &ParameterModel::presetChanged, this, &ParametersPanel::refresh);
    connect(&model_, &ParameterModel::presetsChanged, this, &ParametersPanel::fillPresets);
    fillPresets();
    refresh();
}

QWidget* ParametersPanel::makePresetBox()
{
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 8, 0);
    layout->setSpacing(4);
    auto* label = new QLabel(tr("P&reset"), box);
    label->setBuddy(preset_);
    preset_->setObjectName(QStringLiteral("preset"));
    preset_->setAccessibleName(tr("Preset"));
    auto* top = new QHBoxLayout;
    top->addWidget(label);
    top->addWidget(preset_, 1);
    layout->addLayout(top);
    meaning_->setObjectName(QStringLiteral("presetMeaning"));
    meaning_->setWordWrap(true);
    layout->addWidget(meaning_);
    auto* saveAs = new QPushButton(tr("Save as…"), box);
    saveAs->setObjectName(QStringLiteral("savePreset"));
    saveAs->setAccessibleName(tr("Save these parameters as a preset"));
    resetAll_->setObjectName(QStringLiteral("resetAll"));
    resetAll_->setAccessibleName(tr("Reset all parameters to the preset"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(saveAs);
    buttons->addWidget(resetAll_);
    buttons->addStretch();
    layout->addLayout(buttons);
    connect(preset_, &QComboBox::textActivated, &model_, &ParameterModel::setPreset);
    connect(saveAs, &QPushButton::clicked, this, &ParametersPanel::beginSave);
    connect(resetAll_, &QPushButton::clicked, &model_, &ParameterModel::resetAll);
    return box;
}

QWidget* ParametersPanel::makeSaveBox()
{
    auto* box = new QWidget(this);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 8, 0);
    layout->setSpacing(4);
    saveName_->setObjectName(QStringLiteral("presetName"));
    saveName_->setAccessibleName(tr("Name of the preset"));
    saveName_->setPlaceholderText(tr("Name of the preset"));
    auto* save = new QPushButton(tr("Save"), box);
    save->setObjectName(QStringLiteral("confirmSavePreset"));
    auto* cancel = new QPushButton(tr("Cancel"), box);
    cancel->setObjectName(QStringLiteral("cancelSavePreset"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(save);
    buttons->addWidget(cancel);
    buttons->addStretch();
    layout->addWidget(saveName_);
    layout->addWidget(saveProblem_);
    layout->addLayout(buttons);
    box->hide();
    connect(save, &QPushButton::clicked, this, &ParametersPanel::save);
    connect(saveName_, &QLineEdit::returnPressed, this, &ParametersPanel::save);
    connect(cancel, &QPushButton::clicked, box, &QWidget::hide);
    return box;
}

void ParametersPanel::fillPresets()
{
    const QSignalBlocker quiet(preset_);
    preset_->clear();
    preset_->addItems(model_.presetNames());
    preset_->setCurrentText(model_.preset());
}

void ParametersPanel::refresh()
{
    preset_->setCurrentText(model_.preset());
    meaning_->setText(model_.presetMeaning(model_.preset()));
    resetAll_->setEnabled(model_.isAnyChanged());
    for (ParameterGroupBox* group : groups_)
        group->refresh();
}

void ParametersPanel::setScanning(bool scanning)
{
    for (const ParameterGroupBox* group : groups_) {
        for (ParameterField* field : group->fields()) {
            if (field->key() == "method.estimator" || field->key().starts_with("sensor."))
                field->setEnabled(!scanning);
        }
    }
}

void ParametersPanel::showParameter(std::string_view key)
{
    for (ParameterGroupBox* group : groups_) {
        for (ParameterField* field : group->fields()) {
            if (field->key() != key)
                continue;
            group->setOpen(true);
            group->adjustSize();
            area_->ensureWidgetVisible(field);
            field->focusField();
        }
    }
}

void ParametersPanel::beginSave()
{
    saveProblem_->tell({});
    saveBox_->show();
    saveName_->setFocus();
    saveName_->selectAll();
}

void ParametersPanel::save()
{
    const QString name = saveName_->text().trimmed();
    QString problem = model_.problemOfPresetName(name);
    if (problem.isEmpty() && keeper_)
        problem = keeper_(name, model_.parameters());
    saveProblem_->tell(problem);
    if (!problem.isEmpty())
        return;
    model_.addPreset(name, model_.parameters());
    model_.setPreset(name);
    saveBox_->hide();
    preset_->setFocus();
}

}  // namespace planewright
