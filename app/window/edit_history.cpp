// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/edit_history.h"

#include <utility>

namespace planewright {

void EditHistory::begin(PwscanProject* project, int scan, std::vector<StoredEdit> edits)
{
    EditLine::begin(project, std::move(edits));
    scan_ = scan;
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
    push(std::move(stored));
    return {};
}

void MapEditHistory::begin(PwscanProject* project)
{
    auto edits = project != nullptr ? project->mapEdits() : Result<std::vector<StoredMapEdit>>();
    EditLine::begin(project, edits ? std::move(*edits) : std::vector<StoredMapEdit>{});
}

Result<void> MapEditHistory::add(const MapEdit& edit)
{
    if (project_ == nullptr)
        return fail(ErrorCode::Usage, "There is no file that could hold edits of a map; open a .pwscan.");
    const auto seq = project_->append(edit);
    if (!seq)
        return tl::unexpected{seq.error()};
    push({*seq, edit, false});
    return {};
}

}  // namespace planewright
