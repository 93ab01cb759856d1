// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/parameter_model.h"

#include <algorithm>
#include <cassert>

#include "core/params/presets.h"

namespace planewright {

namespace {

QString text(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

const ParameterRow& rowOf(std::string_view key)
{
    const auto& rows = parameterRows();
    const auto row = std::find_if(rows.begin(), rows.end(), [key](const ParameterRow& r) { return r.key == key; });
    assert(row != rows.end());
    return *row;
}

Parameters parametersOf(const Preset& preset)
{
    Parameters parameters;
    apply(preset, parameters);
    return parameters;
}

}  // namespace

ParameterModel::ParameterModel(QObject* parent)
    : QObject(parent),
      parameters_(parametersOf(methodPresets().front())),
      presetParameters_(parameters_),
      preset_(planewright::text(methodPresets().front().name))
{
}

void ParameterModel::take(const Parameters& parameters)
{
    const auto& rows = parameterRows();
    const bool isSame = std::all_of(rows.begin(), rows.end(), [&](const ParameterRow& row) {
        return printParameter(parameters, row.key) == printParameter(parameters_, row.key);
    });
    parameters_ = parameters;
    if (!isSame)
        emit parametersChanged(parameters_);
}

void ParameterModel::setParameters(const Parameters& parameters)
{
    take(parameters);
}

QString ParameterModel::text(std::string_view key) const
{
    return QString::fromStdString(printParameter(parameters_, key));
}

QString ParameterModel::setText(std::string_view key, const QString& text)
{
    Parameters changed = parameters_;
    if (!setParameter(changed, key, text.trimmed().toStdString()))
        return QStringLiteral("Give %1.").arg(QString::fromStdString(allowedValues(rowOf(key))));
    take(changed);
    return {};
}

QString ParameterModel::problemOf(std::string_view key, const QString& text) const
{
    Parameters changed = parameters_;
    if (setParameter(changed, key, text.trimmed().toStdString()))
        return {};
    return QStringLiteral("Give %1.").arg(QString::fromStdString(allowedValues(rowOf(key))));
}

bool ParameterModel::isChanged(std::string_view key) const
{
    return printParameter(parameters_, key) != printParameter(presetParameters_, key);
}

bool ParameterModel::isAnyChanged() const
{
    const auto& rows = parameterRows();
    return std::any_of(rows.begin(), rows.end(), [this](const ParameterRow& row) { return isChanged(row.key); });
}

void ParameterModel::reset(std::string_view key)
{
    setText(key, QString::fromStdString(printParameter(presetParameters_, key)));
}

void ParameterModel::resetAll()
{
    take(presetParameters_);
}

QStringList ParameterModel::presetNames() const
{
    QStringList names;
    for (const Preset& preset : methodPresets())
        names << planewright::text(preset.name);
    for (const UserPreset& preset : userPresets_)
        names << preset.name;
    return names;
}

QString ParameterModel::presetMeaning(const QString& name) const
{
    const Preset* preset = findPreset(methodPresets(), name.toStdString());
    if (preset == nullptr)
        return QStringLiteral("Your own preset");
    QString meaning = planewright::text(preset->meaning);
    meaning[0] = meaning[0].toUpper();
    return meaning;
}

void ParameterModel::setPreset(const QString& name)
{
    if (const Preset* preset = findPreset(methodPresets(), name.toStdString())) {
        presetParameters_ = parametersOf(*preset);
    } else {
        const auto own = std::find_if(userPresets_.begin(), userPresets_.end(),
                                      [&](const UserPreset& user) { return user.name == name; });
        if (own == userPresets_.end())
            return;
        presetParameters_ = own->parameters;
    }
    preset_ = name;
    take(presetParameters_);
    emit presetChanged();
}

QString ParameterModel::problemOfPresetName(const QString& name) const
{
    constexpr int kLongest = 60;
    if (name.trimmed().isEmpty())
        return QStringLiteral("Give the preset a name.");
    if (findPreset(methodPresets(), name.trimmed().toStdString()) != nullptr)
        return QStringLiteral("“%1” comes with the program. Choose another name.").arg(name.trimmed());
    if (name.contains('/') || name.startsWith('.') || name.size() > kLongest)
        return QStringLiteral("A name has at most 60 characters, no / and no . at its beginning.");
    return {};
}

QString ParameterModel::addPreset(const QString& name, const Parameters& parameters)
{
    QString problem = problemOfPresetName(name);
    if (!problem.isEmpty())
        return problem;
    const QString trimmed = name.trimmed();
    const auto own = std::find_if(userPresets_.begin(), userPresets_.end(),
                                  [&](const UserPreset& user) { return user.name == trimmed; });
    if (own == userPresets_.end())
        userPresets_.push_back({trimmed, parameters});
    else
        own->parameters = parameters;
    emit presetsChanged();
    return {};
}

}  // namespace planewright
