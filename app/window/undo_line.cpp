// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/undo_line.h"

#include <algorithm>
#include <utility>

namespace planewright {

UndoLine::UndoLine(ScanSession& session, EditHistory& edits, MapEditHistory& mapEdits, QObject* parent)
    : QObject(parent), session_(session), edits_(edits), mapEdits_(mapEdits)
{
    connect(&session_, &ScanSession::rerunMade, this, [this] {
        reruns_.push_back({edits_.all().size(), mapEdits_.all().size()});
        while (reruns_.size() > session_.rerunsToUndo())
            reruns_.erase(reruns_.begin());
        forgetUndone();
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

void UndoLine::forgetUndone()
{
    undone_.clear();
    edits_.forgetUndone();
    mapEdits_.forgetUndone();
}

Result<void> UndoLine::add(const Edit& edit)
{
    Result<void> added = edits_.add(edit);
    if (added)
        forgetUndone();
    emit changed();
    return added;
}

Result<void> UndoLine::add(const MapEdit& edit)
{
    Result<void> added = mapEdits_.add(edit);
    if (added)
        forgetUndone();
    emit changed();
    return added;
}

/// A re-run came after the edits that there were.
bool UndoLine::undoesRerun() const
{
    if (reruns_.empty())
        return false;
    const std::optional<std::size_t> edit = edits_.lastDone();
    const std::optional<std::size_t> mapEdit = mapEdits_.lastDone();
    return (!edit || reruns_.back().edits > *edit) && (!mapEdit || reruns_.back().mapEdits > *mapEdit);
}

bool UndoLine::redoesRerun() const
{
    if (undone_.empty())
        return false;
    const std::optional<std::size_t> edit = edits_.nextRedone();
    const std::optional<std::size_t> mapEdit = mapEdits_.nextRedone();
    return (!edit || undone_.back().edits <= *edit) && (!mapEdit || undone_.back().mapEdits <= *mapEdit);
}

/// Edits of both kinds have one count in their file.
bool UndoLine::undoesMapEdit() const
{
    const std::optional<std::size_t> edit = edits_.lastDone();
    const std::optional<std::size_t> mapEdit = mapEdits_.lastDone();
    return mapEdit && (!edit || mapEdits_.all()[*mapEdit].seq > edits_.all()[*edit].seq);
}

bool UndoLine::redoesMapEdit() const
{
    const std::optional<std::size_t> edit = edits_.nextRedone();
    const std::optional<std::size_t> mapEdit = mapEdits_.nextRedone();
    return mapEdit && (!edit || mapEdits_.all()[*mapEdit].seq < edits_.all()[*edit].seq);
}

bool UndoLine::canUndo() const
{
    return undoesRerun() ? session_.refusal(SessionRequest::Rerun).isEmpty() : edits_.canUndo() || mapEdits_.canUndo();
}

bool UndoLine::canRedo() const
{
    return redoesRerun() ? session_.refusal(SessionRequest::Rerun).isEmpty() : edits_.canRedo() || mapEdits_.canRedo();
}

Result<void> UndoLine::undo()
{
    Result<void> done;
    if (!undoesRerun()) {
        done = undoesMapEdit() ? mapEdits_.undo() : edits_.undo();
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
        done = redoesMapEdit() ? mapEdits_.redo() : edits_.redo();
    } else if (done = session_.redoRerun(); done) {
        reruns_.push_back(undone_.back());
        undone_.pop_back();
    }
    emit changed();
    return done;
}

std::vector<UndoLine::Entry> UndoLine::entries() const
{
    std::vector<std::pair<RerunPlace, bool>> reruns;
    for (const RerunPlace& place : reruns_)
        reruns.emplace_back(place, false);
    for (auto place = undone_.rbegin(); place != undone_.rend(); ++place)
        reruns.emplace_back(*place, true);
    std::vector<Entry> entries;
    auto rerun = reruns.begin();
    std::size_t edit = 0;
    std::size_t mapEdit = 0;
    for (;;) {
        for (; rerun != reruns.end() && rerun->first.edits <= edit && rerun->first.mapEdits <= mapEdit; ++rerun)
            entries.push_back({std::nullopt, std::nullopt, rerun->second});
        const bool hasEdit = edit < edits_.all().size();
        const bool hasMapEdit = mapEdit < mapEdits_.all().size();
        if (!hasEdit && !hasMapEdit)
            return entries;
        if (hasEdit && (!hasMapEdit || edits_.all()[edit].seq < mapEdits_.all()[mapEdit].seq)) {
            entries.push_back({edits_.all()[edit].edit, std::nullopt, edits_.all()[edit].undone});
            ++edit;
        } else {
            entries.push_back({std::nullopt, mapEdits_.all()[mapEdit].edit, mapEdits_.all()[mapEdit].undone});
            ++mapEdit;
        }
    }
}

}  // namespace planewright
