// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "core/formats/pwscan_project.h"
#include "core/types/edit.h"
#include "core/types/error.h"

namespace planewright {

/// The edits of a scan's planes, with undo and redo. With a project each of them is in its file when the call returns;
/// without one they last as long as the scan is open.
class EditHistory {
public:
    /// Begins with the edits that a file holds; `project` may be null, and must outlive its use.
    void begin(PwscanProject* project, int scan, std::vector<StoredEdit> edits);

    /// Writes the edits made so far into the file that the scan has now, and goes on there. Errors: NotWritten; those
    /// that are not in the file then last as long as the scan is open, and so do all that follow.
    Result<void> moveInto(PwscanProject* project, int scan);

    /// Makes an edit; what was undone before can no longer be made again. Errors: NotWritten, and nothing is changed.
    Result<void> add(const Edit& edit);
    /// Takes the last edit back, or makes the one taken back last again. Errors: NotWritten. Without any nothing
    /// happens.
    Result<void> undo();
    Result<void> redo();

    bool canUndo() const { return lastDone().has_value(); }
    bool canRedo() const { return !redo_.empty(); }
    /// The places in all() of what undo() takes back and redo() makes again; nothing where there is none.
    std::optional<std::size_t> lastDone() const;
    std::optional<std::size_t> nextRedone() const;
    /// What is undone can no longer be made again.
    void forgetUndone() { redo_.clear(); }
    /// All of them, undone ones too.
    const std::vector<StoredEdit>& all() const { return edits_; }
    std::vector<Edit> inForce() const { return editsInForce(edits_); }

private:
    Result<void> setUndone(std::size_t place, bool undone);

    PwscanProject* project_ = nullptr;
    int scan_ = 0;
    std::vector<StoredEdit> edits_;
    std::vector<std::size_t> redo_;  // places of edits taken back since the last new one
};

}  // namespace planewright
