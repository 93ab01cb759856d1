// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QSettings>

#include "ui/common/preferences.h"

namespace planewright {

/// Reads preferences; what is missing or makes no sense has its default.
Preferences loadPreferences(const QSettings& settings);

/// Writes preferences; what is as it comes with the program is left out.
void savePreferences(const Preferences& preferences, QSettings& settings);

}  // namespace planewright
