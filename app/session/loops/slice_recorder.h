// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/session/loops/scan_item.h"
#include "core/types/error.h"
#include "core/types/recording.h"

namespace planewright {

/// Puts one scan on disk while it is taken. Used by one thread.
///
/// A call that fails has written nothing and may be repeated with the same argument when the disk is back. Errors
/// (NotWritten) name the file and what to do.
class SliceRecorder {
public:
    virtual ~SliceRecorder() = default;

    /// Where it records to.
    virtual std::string path() const = 0;

    /// Makes the file, or the scan in it. Called before all that follows, until it succeeds.
    virtual Result<void> begin(const ScanDescription& description, std::optional<int> plannedSlices) = 0;

    /// Returns when the slice is on the disk. Steps rise.
    virtual Result<void> write(const ScanSlice& slice) = 0;
    virtual Result<void> write(const ParametersFrom& parameters) = 0;
    virtual Result<void> write(const ScanEvent& event) = 0;

    /// Ends the scan; nothing is written afterwards.
    virtual Result<void> close(ScanOutcome outcome) = 0;

    /// What is on the disk [bytes], and what there is still room for, where that is known.
    virtual std::uint64_t bytes() const = 0;
    virtual std::optional<std::uint64_t> freeBytes() const = 0;
};

}  // namespace planewright
