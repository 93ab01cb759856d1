// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/timeline_bookmarks.h"

#include <algorithm>
#include <iterator>

#include "app/window/timeline_words.h"

namespace planewright {

namespace {

constexpr std::string_view kBookmarksKey = "bookmarks";

}  // namespace

void TimelineBookmarks::read()
{
    steps_.clear();
    if (PwscanProject* project = parts_.session.project()) {
        const auto text = project->setting(parts_.session.scanInProject(), kBookmarksKey);
        if (text && *text)
            steps_ = bookmarkedStepsOf(**text);
    }
    show();
}

void TimelineBookmarks::save()
{
    PwscanProject* project = parts_.session.project();
    if (project == nullptr || !project->readOnlyBecause().empty())
        return;
    const auto done = project->setSetting(parts_.session.scanInProject(), kBookmarksKey, textOfBookmarks(steps_));
    if (!done)
        parts_.log(LogSeverity::Warning, QObject::tr("bookmarks"), QString::fromStdString(done.error().message));
}

void TimelineBookmarks::show()
{
    std::set<int> wanted;
    for (const int step : steps_) {
        if (const int place = placeOfStep(parts_.playhead, step); place >= 0)
            wanted.insert(place);
    }
    const std::set<int> shown = parts_.playhead.bookmarks();
    std::set<int> changed;
    std::set_symmetric_difference(wanted.begin(), wanted.end(), shown.begin(), shown.end(),
                                  std::inserter(changed, changed.end()));
    for (const int place : changed)
        parts_.playhead.toggleBookmark(place);
}

void TimelineBookmarks::toggle(int place)
{
    const Playhead::History& history = parts_.playhead.history();
    if (place < 0 || place >= static_cast<int>(history.size()))
        return;
    const int step = history[static_cast<std::size_t>(place)]->report.step;
    if (steps_.erase(step) == 0)
        steps_.insert(step);
    parts_.playhead.toggleBookmark(place);
    save();
}

std::optional<int> TimelineBookmarks::next() const
{
    const std::set<int>& bookmarks = parts_.playhead.bookmarks();
    if (bookmarks.empty())
        return std::nullopt;
    const auto next = bookmarks.upper_bound(parts_.playhead.place());
    return next != bookmarks.end() ? *next : *bookmarks.begin();
}

}  // namespace planewright
