// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "app/window/edit_line.h"
#include "core/formats/map_edit.h"
#include "core/formats/pwscan_project.h"
#include "core/types/edit.h"
#include "core/types/error.h"

namespace planewright {

/// The edits of a scan's planes, with undo and redo. With a project each of them is in its file when the call returns;
/// without one they last as long as the scan is open.
class EditHistory : public EditLine<StoredEdit> {
public:
    /// Begins with the edits that a file holds; `project` may be null, and must outlive its use.
    void begin(PwscanProject* project, int scan, std::vector<StoredEdit> edits);

    /// Writes the edits made so far into the file that the scan has now, and goes on there. Errors: NotWritten; those
    /// that are not in the file then last as long as the scan is open, and so do all that follow.
    Result<void> moveInto(PwscanProject* project, int scan);

    /// Makes an edit; what was undone before can no longer be made again. Errors: NotWritten, and nothing is changed.
    Result<void> add(const Edit& edit);

private:
    int scan_ = 0;
};

/// The edits of the map of all scans of a file, in the same way.
class MapEditHistory : public EditLine<StoredMapEdit> {
public:
    /// Begins with the edits that the project's file holds; null: there is none, and nothing can be added.
    void begin(PwscanProject* project);

    /// Makes an edit. Errors: NotWritten; Usage without a project.
    Result<void> add(const MapEdit& edit);
};

}  // namespace planewright
