// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/formats/pwscan_project.h"
#include "core/types/error.h"

namespace planewright {

/// Edits of one kind in their order, with undo and redo; `Stored` is how a file holds one. With a project each change
/// is in its file when the call returns.
template <class Stored>
class EditLine {
public:
    /// Takes the last edit back, or makes the one taken back last again. Errors: NotWritten. Without any nothing
    /// happens.
    Result<void> undo()
    {
        const std::optional<std::size_t> last = lastDone();
        if (!last)
            return {};
        if (auto done = setUndone(*last, true); !done)
            return done;
        redo_.push_back(*last);
        return {};
    }

    Result<void> redo()
    {
        if (redo_.empty())
            return {};
        if (auto done = setUndone(redo_.back(), false); !done)
            return done;
        redo_.pop_back();
        return {};
    }

    bool canUndo() const { return lastDone().has_value(); }
    bool canRedo() const { return !redo_.empty(); }

    /// The places in all() of what undo() takes back and redo() makes again; nothing where there is none.
    std::optional<std::size_t> lastDone() const
    {
        const auto last = std::find_if(edits_.rbegin(), edits_.rend(), [](const Stored& edit) { return !edit.undone; });
        if (last == edits_.rend())
            return std::nullopt;
        return static_cast<std::size_t>(edits_.rend() - last) - 1;
    }

    std::optional<std::size_t> nextRedone() const { return redo_.empty() ? std::nullopt : std::optional{redo_.back()}; }

    /// What is undone can no longer be made again.
    void forgetUndone() { redo_.clear(); }
    /// All of them, undone ones too.
    const std::vector<Stored>& all() const { return edits_; }
    auto inForce() const { return editsInForce(edits_); }

protected:
    /// What a file holds as undone at its end can be made again.
    void begin(PwscanProject* project, std::vector<Stored> edits)
    {
        project_ = project;
        edits_ = std::move(edits);
        redo_.clear();
        for (std::size_t i = edits_.size(); i > 0 && edits_[i - 1].undone; --i)
            redo_.push_back(i - 1);
    }

    /// A new edit: what was undone before can no longer be made again.
    void push(Stored stored)
    {
        edits_.push_back(std::move(stored));
        redo_.clear();
    }

    PwscanProject* project_ = nullptr;
    std::vector<Stored> edits_;

private:
    Result<void> setUndone(std::size_t place, bool undone)
    {
        if (project_ != nullptr) {
            if (auto written = project_->setUndone(edits_[place].seq, undone); !written)
                return written;
        }
        edits_[place].undone = undone;
        return {};
    }

    std::vector<std::size_t> redo_;  // places of edits taken back since the last new one
};

}  // namespace planewright
