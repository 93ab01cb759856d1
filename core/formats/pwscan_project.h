// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/map_edit.h"
#include "core/formats/pwscan_notes.h"
#include "core/formats/pwscan_scan.h"
#include "core/params/parameters.h"
#include "core/types/edit.h"
#include "core/types/error.h"

namespace planewright {

/// What keeps a recording from being changed.
enum class ReadOnlyCause { None, NewerVersion, HeldElsewhere, NotWritable };

/// A `.pwscan` whose planes are being looked at and edited: its edits and settings, each on the disk when the call
/// returns. Slices are read with readRecordingPwscan, and recorded with PwscanWriter, which may have the same file
/// open.
///
/// For one thread at a time. A recording on media that cannot be written, of a newer version, or held by another
/// program opens read-only and says why; what would change it is then a NotWritten error. After any error the file is
/// as it was before the call.
class PwscanProject {
public:
    /// Errors (Unreadable): no recording, damaged, or held so that not even reading it is possible.
    static Result<PwscanProject> open(const std::string& path);

    PwscanProject(PwscanProject&&) noexcept;
    PwscanProject& operator=(PwscanProject&&) noexcept;
    ~PwscanProject();

    /// Why nothing can be changed, and what to do, for people; empty where it can.
    const std::string& readOnlyBecause() const;
    ReadOnlyCause readOnlyCause() const;

    /// The scans that can be used, in order of id.
    Result<std::vector<ScanRecord>> scans() const;

    /// Adds an edit of a scan's planes and gives its seq. Its text is stored as cleanName makes it.
    Result<int> append(int scan, const Edit& edit);
    /// Adds an edit of the map of all scans and gives its seq.
    Result<int> append(const MapEdit& edit);
    /// Marks an edit undone, or redone.
    Result<void> setUndone(int seq, bool undone);
    /// The edits of a scan in their order, undone ones too; those that cannot be read are left out.
    Result<std::vector<StoredEdit>> edits(int scan) const;

    /// The edits of the map of all scans in their order, undone ones too; those that cannot be read are left out.
    Result<std::vector<StoredMapEdit>> mapEdits() const;

    /// What happened during a scan, in its order; what cannot be read is left out.
    Result<std::vector<ScanEvent>> events(int scan) const;

    /// Adds that a scan is extracted with these parameters, from a step on, whatever was in force there before.
    Result<void> appendParameters(int scan, const Parameters& parameters, int fromStep = 0);

    /// What is kept of a scan, or without one of the file: view, selection, layers. Texts of at most 1 MiB, keys of at
    /// most 200 bytes.
    Result<std::optional<std::string>> setting(std::optional<int> scan, std::string_view key) const;
    Result<void> setSetting(std::optional<int> scan, std::string_view key, std::string_view value);

    const std::string& path() const;

private:
    struct State;
    explicit PwscanProject(std::unique_ptr<State> state);
    Result<void> checkWritable() const;
    Result<void> checkWritable(int scan) const;

    std::unique_ptr<State> state_;
};

}  // namespace planewright
