// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/output_files.h"

#include <algorithm>
#include <sys/stat.h>

#include "app/cli/temporary_files.h"

namespace planewright {

namespace {

bool areOneFile(const std::string& a, const std::string& b)
{
    struct stat statusA {};
    struct stat statusB {};
    return ::stat(a.c_str(), &statusA) == 0 && ::stat(b.c_str(), &statusB) == 0 && S_ISREG(statusA.st_mode) &&
           statusA.st_dev == statusB.st_dev && statusA.st_ino == statusB.st_ino;
}

}  // namespace

Result<OutputFile*> OutputFiles::open(const std::string& path)
{
    if (files_.size() == kMaxTemporaryFiles)
        return fail(ErrorCode::Usage, "more than " + std::to_string(kMaxTemporaryFiles) + " outputs; give fewer");
    for (const std::string& input : inputs_) {
        if (overwrite_ && areOneFile(input, path))
            return fail(ErrorCode::Usage, path + ": this is the input; give another name for the output");
    }
    Result<std::unique_ptr<OutputFile>> file = OutputFile::open(path, overwrite_);
    if (!file)
        return tl::unexpected{file.error()};
    const std::string identity = (*file)->identity();
    for (const auto& other : files_) {
        if (!identity.empty() && other->identity() == identity)
            return fail(ErrorCode::Usage,
                        path + ": two outputs go to this file (" + other->path() + "); give each its own name");
    }
    files_.push_back(std::move(*file));
    return files_.back().get();
}

Result<void> OutputFiles::publish()
{
    for (const auto& file : files_) {
        if (Result<void> finished = file->finish(); !finished)
            return finished;
    }
    const SignalsHeldBack heldBack;
    std::stable_partition(files_.begin(), files_.end(), [](const auto& file) { return !file->replaces(); });
    for (const auto& file : files_) {
        Result<void> published = file->publish();
        if (published)
            continue;
        for (const auto& other : files_)
            other->retract();
        return published;
    }
    return {};
}

}  // namespace planewright
