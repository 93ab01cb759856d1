// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include "core/formats/pwscan_notes.h"
#include "core/formats/pwscan_scan.h"
#include "core/params/parameters.h"
#include "core/types/error.h"
#include "core/types/recording.h"

namespace planewright {

/// Records one scan into a `.pwscan` while it is taken. What a call has written when it returns is on the disk, and
/// stays there whatever happens to the program: after a kill at any moment the file opens with all of it.
///
/// For one thread at a time, any. A call that fails has written nothing, and what was written before is as it was; it
/// may be repeated later with the same slice, when there is room again or the disk is back. A call waits at most half a
/// second for another program that writes.
class PwscanWriter {
public:
    /// Makes a new file with this scan, whose state and id are not used. Errors (NotWritten): a file of this name with
    /// anything in it, and whatever keeps a file from being made.
    static Result<PwscanWriter> create(const std::string& path, const ScanRecord& scan);

    /// Adds this scan to a recording that is there. Errors: Unreadable where it is none, or of a newer format;
    /// NotWritten otherwise.
    static Result<PwscanWriter> append(const std::string& path, const ScanRecord& scan);

    PwscanWriter(PwscanWriter&&) noexcept;
    PwscanWriter& operator=(PwscanWriter&&) noexcept;
    /// Without close() the scan stays `running`, as after a crash; nothing is lost.
    ~PwscanWriter();

    /// Commits a slice; its step must exceed those before. A slice that a failed call brought to the disk after all is
    /// written already when it is given again. Errors: NotWritten, also beyond the limits of a recording; Internal for
    /// another number of beams, or a step that does not rise.
    Result<void> write(const ScanSlice& slice);

    /// Commits an event. Errors: NotWritten.
    Result<void> write(const ScanEvent& event);

    /// Commits that these parameters are in force from this step on; the first are to be written for step 0.
    Result<void> writeParameters(int step, const Parameters& parameters);

    /// Says what became of the scan and closes the file as one, without `-wal`, unless another program has it open.
    /// After that nothing can be written. Errors (NotWritten): the writer is still open, and may be closed again.
    Result<void> close(ScanState state);

    /// Ends a scan that has no slices by taking it out of the file again, which is removed where it was made for this
    /// scan alone. A scan that has slices is closed as partial. Errors as for close().
    Result<void> discard();

    int scan() const;    ///< the scan's number in the file
    int slices() const;  ///< that have been written
    const std::string& path() const;

private:
    struct State;
    explicit PwscanWriter(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace planewright
