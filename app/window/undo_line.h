// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <QObject>

#include "app/session/scan_session.h"
#include "app/window/edit_history.h"

namespace planewright {

/// What can be undone, in one line: the edits of a scan's planes and of the map of all scans, and re-runs between them.
class UndoLine : public QObject {
    Q_OBJECT

public:
    /// All must live as long as this.
    UndoLine(ScanSession& session, EditHistory& edits, MapEditHistory& mapEdits, QObject* parent = nullptr);

    /// Makes an edit; what was undone before can no longer be made again. Errors: as EditHistory::add().
    Result<void> add(const Edit& edit);
    Result<void> add(const MapEdit& edit);
    /// Takes back what was done last, or makes what was taken back last again. Errors: NotWritten; Usage while a re-run
    /// cannot be exchanged. Without any nothing happens.
    Result<void> undo();
    Result<void> redo();
    bool canUndo() const;
    bool canRedo() const;

    /// Something that was done: an edit, or a re-run.
    struct Entry {
        std::optional<Edit> edit;  ///< nothing of a re-run
        std::optional<MapEdit> mapEdit = {};
        bool isUndone = false;
    };
    /// All of them in their order.
    std::vector<Entry> entries() const;

signals:
    /// There is another thing to undo or redo.
    void changed();

private:
    /// How many edits of both kinds there were when a re-run was made.
    struct RerunPlace {
        std::size_t edits = 0;
        std::size_t mapEdits = 0;
    };

    bool undoesRerun() const;
    bool redoesRerun() const;
    bool undoesMapEdit() const;
    bool redoesMapEdit() const;
    void forgetUndone();

    ScanSession& session_;
    EditHistory& edits_;
    MapEditHistory& mapEdits_;
    std::vector<RerunPlace> reruns_;
    std::vector<RerunPlace> undone_;  ///< the one taken back last is last
};

}  // namespace planewright
