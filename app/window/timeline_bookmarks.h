// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <set>

#include "app/window/window_parts.h"

namespace planewright {

/// The bookmarks of a scan: steps, the playhead's where there are such steps by now, and a setting of the `.pwscan`.
class TimelineBookmarks {
public:
    explicit TimelineBookmarks(WindowParts& parts) : parts_(parts) {}

    /// Begins with those of the file that is open.
    void read();
    /// Writes them into it, where it takes any.
    void save();
    /// Gives the playhead those of steps that there are.
    void show();
    /// Marks the step at a place, or takes its mark away. Nothing happens where there is no such place.
    void toggle(int place);
    /// The place of the one after the step that is looked at, or else of the first; nothing without any.
    std::optional<int> next() const;

private:
    WindowParts& parts_;
    std::set<int> steps_;
};

}  // namespace planewright
