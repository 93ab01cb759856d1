// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/undo_line.h"

#include <algorithm>

namespace planewright {

UndoLine::UndoLine(ScanSession& session, EditHistory& edits, QObject* parent)
    : QObject(parent), session_(session), edits_(edits)
{
    connect(&session_, &ScanSession::rerunMade, this, [this] {
        reruns_.push_back(edits_.all().size());
        while (reruns_.size() > session_.rerunsToUndo())
            reruns_.erase(reruns_.begin());
        undone_.clear();
        edits_.forgetUndone();
        emit changed();
    });
    connect(&session_, &ScanSession::historyChanged, this, [this](int steps) {
        if (steps > 0)
            return;
        reruns_.clear();
        undone_.clear();
        emit changed();
    });
    connect(&session_, &ScanSession::stateChanged, this, &UndoLine::changed);
}

Result<void> UndoLine::add(const Edit& edit)
{
    Result<void> added = edits_.add(edit);
    if (added)
        undone_.clear();
    emit changed();
    return added;
}

/// A re-run came after the edits that there were.
bool UndoLine::undoesRerun() const
{
    const std::optional<std::size_t> edit = edits_.lastDone();
    return !reruns_.empty() && (!edit || reruns_.back() > *edit);
}

bool UndoLine::redoesRerun() const
{
    const std::optional<std::size_t> edit = edits_.nextRedone();
    return !undone_.empty() && (!edit || undone_.back() <= *edit);
}

bool UndoLine::canUndo() const
{
    return undoesRerun() ? session_.refusal(SessionRequest::Rerun).isEmpty() : edits_.canUndo();
}

bool UndoLine::canRedo() const
{
    return redoesRerun() ? session_.refusal(SessionRequest::Rerun).isEmpty() : edits_.canRedo();
}

Result<void> UndoLine::undo()
{
    Result<void> done;
    if (!undoesRerun()) {
        done = edits_.undo();
    } else if (done = session_.undoRerun(); done) {
        undone_.push_back(reruns_.back());
        reruns_.pop_back();
    }
    emit changed();
    return done;
}

Result<void> UndoLine::redo()
{
    Result<void> done;
    if (!redoesRerun()) {
        done = edits_.redo();
    } else if (done = session_.redoRerun(); done) {
        reruns_.push_back(undone_.back());
        undone_.pop_back();
    }
    emit changed();
    return done;
}

std::vector<UndoLine::Entry> UndoLine::entries() const
{
    // Of each re-run: after how many edits.
    std::vector<std::pair<std::size_t, bool>> reruns;
    for (const std::size_t edits : reruns_)
        reruns.emplace_back(edits, false);
    for (auto edits = undone_.rbegin(); edits != undone_.rend(); ++edits)
        reruns.emplace_back(*edits, true);
    std::vector<Entry> entries;
    auto rerun = reruns.begin();
    for (std::size_t i = 0; i <= edits_.all().size(); ++i) {
        for (; rerun != reruns.end() && rerun->first == i; ++rerun)
            entries.push_back({std::nullopt, rerun->second});
        if (i < edits_.all().size())
            entries.push_back({edits_.all()[i].edit, edits_.all()[i].undone});
    }
    return entries;
}

}  // namespace planewright
