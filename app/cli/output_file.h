// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <sys/types.h>
#include <utility>

#include "app/cli/descriptor_stream.h"
#include "core/types/error.h"

namespace planewright {

/// A file that appears only when it is complete.
///
/// What is written goes to a temporary file in the folder of the target; publish() gives it the target's name. Until
/// then, and if anything fails, what stood there before is untouched, and nothing is left behind. A symbolic link is
/// followed: the file it names is made or replaced, the link stays. Pipes, character devices (/dev/null, /dev/full) and
/// the open descriptors (/dev/stdout, /dev/fd/N) have nothing to replace and are written directly.
///
/// All errors are NotWritten and name the path as the user gave it.
class OutputFile {
public:
    /// Checks the target and prepares for writing. An existing file is an error without `overwrite`; so are a folder, a
    /// block device and a folder that is not there.
    static Result<std::unique_ptr<OutputFile>> open(const std::string& path, bool overwrite);

    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    /// Calls a writer of core/formats on the file; may be called again to write on.
    Result<void> write(const std::function<Result<void>(std::ostream&)>& writer);

    /// Brings everything to the disk and closes: the last place where a full disk shows.
    Result<void> finish();

    /// Gives the finished file its name. A file that has appeared there meanwhile is an error without `overwrite`.
    Result<void> publish();

    /// Takes a published file away again, where it has replaced nothing.
    void retract();

    bool replaces() const { return replaces_; }  ///< something will be gone after publish()
    const std::string& path() const { return path_; }

    /// What tells a target from every other: its folder and name. Empty for what is written directly.
    std::string identity() const;

    /// One file by itself: open, write, finish and publish.
    static Result<void> writeWhole(const std::string& path, bool overwrite,
                                   const std::function<Result<void>(std::ostream&)>& writer);

private:
    OutputFile(std::string path, bool overwrite) : path_(std::move(path)), overwrite_(overwrite) {}

    Result<void> openDirectly(int descriptor);
    Result<void> openBeside();
    tl::unexpected<Error> failure(int error) const;

    std::string path_;       ///< as the user gave it
    std::string target_;     ///< with symbolic links followed
    std::string temporary_;  ///< empty for what is written directly, and after publish()
    bool overwrite_ = false;
    bool replaces_ = false;
    bool published_ = false;
    int descriptor_ = -1;
    std::unique_ptr<DescriptorOutputBuffer> buffer_;
    std::unique_ptr<std::ostream> stream_;
};

}  // namespace planewright
