// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/recording_file.h"

#include "app/cli/console.h"
#include "app/cli/file_kind.h"
#include "app/cli/input_file.h"

namespace planewright {

Result<ReadRecording> readRecordingFile(const std::string& path)
{
    if (const auto known = checkRecordingNames({path}); !known)
        return tl::unexpected{known.error()};
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    Result<ReadRecording> read = readRecordingCsv(**input, path);
    if (read) {
        for (const std::string& warning : read->warnings)
            printWarning(warning);
    }
    return read;
}

Result<void> checkRecordingNames(const std::vector<std::string>& paths)
{
    for (const std::string& path : paths) {
        if (const auto suffix = suffixOf(path, kRecordingSuffixes, "a recording"); !suffix)
            return tl::unexpected{suffix.error()};
    }
    return {};
}

}  // namespace planewright
