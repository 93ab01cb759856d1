// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/output_file.h"

namespace planewright {

/// The outputs of a command: they appear together when all are complete, or none does.
class OutputFiles {
public:
    explicit OutputFiles(bool overwrite) : overwrite_(overwrite) {}

    /// Notes an input, which no output may replace.
    void protect(const std::string& input) { inputs_.push_back(input); }

    /// Opens one more output; the pointer lives as long as this object. Errors: NotWritten as OutputFile::open; Usage
    /// where two outputs are one file, or where an output is an input.
    Result<OutputFile*> open(const std::string& path);

    /// Brings all to the disk, then gives all their names. If one fails, those that have replaced nothing are taken
    /// away again; those that replace come last, when little can fail. Not to be interrupted half-way.
    Result<void> publish();

    bool empty() const { return files_.empty(); }

private:
    bool overwrite_;
    std::vector<std::string> inputs_;
    std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace planewright
