// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/edit_history.h"

#include <algorithm>
#include <utility>

namespace planewright {

void EditHistory::begin(PwscanProject* project, int scan, std::vector<StoredEdit> edits)
{
    project_ = project;
    scan_ = scan;
    edits_ = std::move(edits);
    redo_.clear();
    // What a file holds as undone at its end can be made again.
    for (std::size_t i = edits_.size(); i > 0 && edits_[i - 1].undone; --i)
        redo_.push_back(i - 1);
}

Result<void> EditHistory::moveInto(PwscanProject* project, int scan)
{
    for (StoredEdit& stored : edits_) {
        const auto seq = project->append(scan, stored.edit);
        if (!seq)
            return tl::unexpected{seq.error()};
        stored.seq = *seq;
        if (stored.undone) {
            if (auto marked = project->setUndone(*seq, true); !marked)
                return marked;
        }
    }
    project_ = project;
    scan_ = scan;
    return {};
}

Result<void> EditHistory::add(const Edit& edit)
{
    StoredEdit stored{edits_.empty() ? 1 : edits_.back().seq + 1, edit, false};
    if (project_ != nullptr) {
        const auto seq = project_->append(scan_, edit);
        if (!seq)
            return tl::unexpected{seq.error()};
        stored.seq = *seq;
    }
    edits_.push_back(std::move(stored));
    redo_.clear();
    return {};
}

std::optional<std::size_t> EditHistory::lastDone() const
{
    const auto last = std::find_if(edits_.rbegin(), edits_.rend(), [](const StoredEdit& edit) { return !edit.undone; });
    if (last == edits_.rend())
        return std::nullopt;
    return static_cast<std::size_t>(edits_.rend() - last) - 1;
}

std::optional<std::size_t> EditHistory::nextRedone() const
{
    return redo_.empty() ? std::nullopt : std::optional{redo_.back()};
}

Result<void> EditHistory::setUndone(std::size_t place, bool undone)
{
    if (project_ != nullptr) {
        if (auto written = project_->setUndone(edits_[place].seq, undone); !written)
            return written;
    }
    edits_[place].undone = undone;
    return {};
}

Result<void> EditHistory::undo()
{
    const std::optional<std::size_t> last = lastDone();
    if (!last)
        return {};
    if (auto done = setUndone(*last, true); !done)
        return done;
    redo_.push_back(*last);
    return {};
}

Result<void> EditHistory::redo()
{
    if (redo_.empty())
        return {};
    if (auto done = setUndone(redo_.back(), false); !done)
        return done;
    redo_.pop_back();
    return {};
}

}  // namespace planewright
