// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "app/session/loops/slice_recorder.h"
#include "core/formats/pwscan_writer.h"

namespace planewright {

/// The present moment as recordings hold it: "2026-03-01T14:05:09Z".
std::string utcNow();

/// Records a scan into a `.pwscan`.
class PwscanRecorder : public SliceRecorder {
public:
    enum class Target {
        NewFile,  ///< of a name that nothing has yet
        Append,   ///< one scan more in a recording that is there
    };
    PwscanRecorder(std::string path, Target target, std::string scanName);

    std::string path() const override { return path_; }
    /// Once it has succeeded, once more changes nothing: a caller can find out beforehand whether there will be a file.
    Result<void> begin(const ScanDescription& description, std::optional<int> plannedSlices) override;
    Result<void> write(const ScanSlice& slice) override { return writer_->write(slice); }
    Result<void> write(const ParametersFrom& parameters) override
    {
        return writer_->writeParameters(parameters.step, parameters.parameters);
    }
    Result<void> write(const ScanEvent& event) override { return writer_->write(event); }
    /// Of a scan without a slice nothing is left, nor of the file that was made for it.
    Result<void> close(ScanOutcome outcome) override;
    std::uint64_t bytes() const override;
    std::optional<std::uint64_t> freeBytes() const override;

private:
    std::string path_;
    Target target_;
    std::string scanName_;
    std::string startedUtc_;
    std::optional<PwscanWriter> writer_;
};

}  // namespace planewright
