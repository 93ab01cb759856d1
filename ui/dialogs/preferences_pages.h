// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "ui/dialogs/preferences_dialog.h"
#include "ui/dialogs/preferences_page.h"

namespace planewright {

// The pages of the preferences; the keys of actions have one of their own, ShortcutsPage.
PreferencesPage* makeGeneralPage(QWidget* parent);
PreferencesPage* makeViewPage(QWidget* parent);
PreferencesPage* makeScanPage(const QStringList& presets, QWidget* parent);
PreferencesPage* makeAdvancedPage(const QList<QAction*>& actions, QWidget* parent);

}  // namespace planewright
