// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/recording_file.h"

#include "app/cli/console.h"
#include "app/cli/number_option.h"
#include "core/formats/recording_csv.h"

namespace planewright {

void addScanOption(CLI::App& command, int& scan)
{
    addWholeNumber(command, "--scan", scan, 0, kMaxStep,
                   "number of the scan in a .pwscan, .ptx or folder of .3d (default: the last that has slices)");
}

RecordingChoice chosenScan(int scan)
{
    return {scan < 0 ? std::nullopt : std::optional{scan}, false};
}

Result<RecordingFile> readRecordingFile(const std::string& path, const RecordingChoice& choice)
{
    Result<RecordingFile> file = loadRecordingFile(path, choice);
    if (file) {
        for (const std::string& warning : file->warnings)
            printWarning(warning);
    }
    return file;
}

}  // namespace planewright
