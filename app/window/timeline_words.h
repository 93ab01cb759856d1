// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <set>
#include <string>

#include <QString>
#include <QStringList>

#include "app/session/loops/snapshot_bridge.h"
#include "core/types/edit.h"

namespace planewright {

/// What the user has said of planes, in a line: "P03: named Door".
QString timelineLineOf(const Edit& edit);

/// What a slice says against itself, and what was lost between the step before, null for the first, and it. Steps count
/// from 1 there.
QStringList troublesOf(const ExtractedStep& step, const ExtractedStep* before);

/// Bookmarks as a `.pwscan` keeps them, JSON: the numbers of steps from 0, −1 for the forced last pass. A text that is
/// no such list gives none.
std::set<int> bookmarkedStepsOf(const std::string& text);
std::string textOfBookmarks(const std::set<int>& steps);

}  // namespace planewright
