// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <QString>
#include <QStringList>

#include "app/session/loops/snapshot_bridge.h"
#include "core/formats/pwscan_notes.h"
#include "core/types/edit.h"
#include "ui/models/playhead.h"

namespace planewright {

/// What the user has said of planes, in a line: "P03: named Door".
QString timelineLineOf(const Edit& edit);

/// What a slice says against itself, and what was lost between the step before, null for the first, and it. Steps count
/// from 1 there.
QStringList troublesOf(const ExtractedStep& step, const ExtractedStep* before);

/// What a recording tells of faults, and of going on after them, each with its step from 0, in a line of at most 200
/// letters. Events that name no step have no place in time and are left out.
std::vector<std::pair<int, QString>> troublesIn(std::span<const ScanEvent> events);

/// The place of a step at which something went wrong, or of the last one before it where it was lost; −1 where it has
/// not come yet. A scan that is over has no more steps.
int placeOfFault(const Playhead& playhead, int step, bool isOver);

/// Bookmarks as a `.pwscan` keeps them, JSON: the numbers of steps from 0, −1 for the forced last pass. A text that is
/// no such list gives none.
std::set<int> bookmarkedStepsOf(const std::string& text);
std::string textOfBookmarks(const std::set<int>& steps);

}  // namespace planewright
