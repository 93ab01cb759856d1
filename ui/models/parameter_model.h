// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>

#include "core/params/parameters.h"
#include "core/params/registry.h"

namespace planewright {

/// The parameters of one phase of the method.
struct ParameterGroup {
    QString title;
    std::vector<const ParameterRow*> rows;
};

/// All parameters in the algorithm's order.
std::vector<ParameterGroup> parameterGroups();

/// "Split distance" for segments.split-distance.
QString parameterLabel(const ParameterRow& row);
/// "λ<sub>u</sub>" for lambda_u, as rich text; empty where it has none.
QString parameterSymbol(const ParameterRow& row);
/// "°" for angles, "m", or nothing.
QString parameterUnit(const ParameterRow& row);

/// The parameters of an extraction as they are being set, held against a preset. They are always valid.
class ParameterModel : public QObject {
    Q_OBJECT

public:
    explicit ParameterModel(QObject* parent = nullptr);

    const Parameters& parameters() const { return parameters_; }
    /// Takes over parameters from elsewhere, as from a recording; the preset stays.
    void setParameters(const Parameters& parameters);

    QString text(std::string_view key) const;
    /// Sets one parameter from what was typed; gives what is wrong with it, or nothing.
    QString setText(std::string_view key, const QString& text);
    /// What would be wrong with it.
    QString problemOf(std::string_view key, const QString& text) const;

    /// True where a parameter is not as the preset has it.
    bool isChanged(std::string_view key) const;
    bool isAnyChanged() const;
    void reset(std::string_view key);
    void resetAll();

    /// The presets of the method, then the user's.
    QStringList presetNames() const;
    QString presetMeaning(const QString& name) const;
    const QString& preset() const { return preset_; }
    void setPreset(const QString& name);
    /// Keeps parameters as a preset of the user's; one of that name is replaced. Gives what is wrong with the name, or
    /// nothing.
    QString addPreset(const QString& name, const Parameters& parameters);
    /// What is wrong with a name for a preset, or nothing.
    QString problemOfPresetName(const QString& name) const;

signals:
    void parametersChanged(const planewright::Parameters& parameters);
    void presetsChanged();
    void presetChanged();

private:
    void take(const Parameters& parameters);

    struct UserPreset {
        QString name;
        Parameters parameters;
    };

    Parameters parameters_;
    Parameters presetParameters_;
    QString preset_;
    std::vector<UserPreset> userPresets_;
};

}  // namespace planewright
