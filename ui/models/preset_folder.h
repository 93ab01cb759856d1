// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <QDir>
#include <QString>
#include <QStringList>

#include "core/params/parameters.h"
#include "core/types/error.h"

namespace planewright {

class ParameterModel;

/// The user's presets as files of a folder: NAME.json, in the format that --preset reads.
class PresetFolder {
public:
    /// The folder need not be there yet.
    explicit PresetFolder(const QString& path) : folder_(path) {}

    /// Gives a model all presets of the folder; what is wrong with the others, a line each.
    QStringList load(ParameterModel& model) const;

    /// Writes a preset, or leaves the folder as it was. Errors: NotWritten.
    Result<void> save(const QString& name, const Parameters& parameters) const;

private:
    QDir folder_;
};

}  // namespace planewright
