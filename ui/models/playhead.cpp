// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/playhead.h"

#include <algorithm>
#include <iterator>

namespace planewright {

Playhead::Playhead(QObject* parent) : QObject(parent) {}

void Playhead::setHistory(History history, int planned)
{
    const bool goesOn = !history_.empty() && history.size() >= history_.size() && history.front() == history_.front();
    history_ = std::move(history);
    planned_ = planned;
    const int newest = static_cast<int>(history_.size()) - 1;
    if (!goesOn) {
        place_ = newest;
        followsNewest_ = true;
        setLoop({});
        if (!bookmarks_.empty()) {
            bookmarks_.clear();
            emit bookmarksChanged();
        }
    }
    emit historyChanged();
    if (!goesOn) {
        showPhase({});
        emit placeChanged(newest);
    } else if (followsNewest_) {
        look(newest, true);
    }
}

std::shared_ptr<const Snapshot> Playhead::snapshot() const
{
    return place_ < 0 ? nullptr : history_[static_cast<std::size_t>(place_)];
}

int Playhead::placeOf(int step) const
{
    // The forced last pass comes after all steps and has no number of its own.
    const auto end = !history_.empty() && history_.back()->report.step < 0 ? std::prev(history_.end()) : history_.end();
    const auto next = std::upper_bound(history_.begin(), end, step,
                                       [](int limit, const auto& snapshot) { return limit < snapshot->report.step; });
    return static_cast<int>(std::distance(history_.begin(), next)) - 1;
}

void Playhead::goTo(int place)
{
    if (!history_.empty())
        look(std::clamp(place, 0, static_cast<int>(history_.size()) - 1), false);
}

void Playhead::follow()
{
    look(static_cast<int>(history_.size()) - 1, true);
}

void Playhead::look(int place, bool followsNewest)
{
    showPhase({});
    if (place == place_ && followsNewest == followsNewest_)
        return;
    place_ = place;
    followsNewest_ = followsNewest;
    emit placeChanged(place);
}

void Playhead::showPhase(std::optional<std::size_t> phase)
{
    if (phase == phase_)
        return;
    phase_ = phase;
    emit phaseChanged();
}

void Playhead::setLoop(std::optional<std::pair<int, int>> loop)
{
    if (loop && loop->first > loop->second)
        std::swap(loop->first, loop->second);
    if (loop == loop_)
        return;
    loop_ = loop;
    emit loopChanged();
}

void Playhead::toggleBookmark(int place)
{
    if (bookmarks_.erase(place) == 0)
        bookmarks_.insert(place);
    emit bookmarksChanged();
}

}  // namespace planewright
