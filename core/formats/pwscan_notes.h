// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/problem_list.h"
#include "core/types/edit.h"
#include "core/types/error.h"

namespace planewright {

/// Something that happened during a scan.
struct ScanEvent {
    enum class Kind { Parameters, Fault, Recovered, Pause, Resume, Mark, Note };
    Kind kind = Kind::Note;
    std::optional<int> step;  ///< from which it holds, or at which it happened
    std::optional<std::chrono::microseconds> time;
    std::string payload;  ///< of Parameters a preset file, of the others JSON or plain text
};
std::string_view name(ScanEvent::Kind kind);

/// An edit as a file holds it.
struct StoredEdit {
    int seq = 0;  ///< rises with every edit of the file
    Edit edit;
    bool undone = false;
};

class SqlDatabase;

Result<void> insertEvent(SqlDatabase& database, int scan, const ScanEvent& event);
/// Gives the edit's seq.
Result<int> insertEdit(SqlDatabase& database, int scan, const Edit& edit, bool undone);

/// The events of one scan, and the edits of its planes, in their order. What cannot be used is left out: a bad row is
/// told to `problems`, an event of a kind that is not known to `warnings`.
Result<std::vector<ScanEvent>> readEvents(SqlDatabase& database, int scan, ProblemList& problems,
                                          std::vector<std::string>& warnings);
Result<std::vector<StoredEdit>> readEdits(SqlDatabase& database, int scan, ProblemList& problems);

/// The edits that are not undone, in their order.
std::vector<Edit> editsInForce(const std::vector<StoredEdit>& edits);

}  // namespace planewright
