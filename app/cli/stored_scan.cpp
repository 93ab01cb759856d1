// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/stored_scan.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "app/cli/console.h"
#include "core/pipeline/apply_edits.h"

namespace planewright {

Result<std::vector<ParametersFrom>> parametersOverSteps(const RecordingFile& input, const std::string& scanner,
                                                        const std::string& path, int until,
                                                        const ParameterOptions& options)
{
    std::vector<ParametersFrom> stored;
    if (input.notes && options.preset.empty()) {
        auto read = readParameterEvents(input.notes->events, path);
        if (!read)
            return read;
        stored = std::move(*read);
        // As if the scan had ended there; the first set is in force from the beginning, whatever its step.
        if (until >= 0 && !stored.empty())
            stored.erase(std::find_if(stored.begin() + 1, stored.end(),
                                      [&](const ParametersFrom& from) { return from.step > until; }),
                         stored.end());
    }
    return parametersInForce(options, scanner, std::move(stored));
}

void applyStoredEdits(ScanResults& extraction, const RecordingFile& input, bool noEdits, const std::string& path)
{
    const std::vector<Edit> edits = input.notes && !noEdits ? editsInForce(input.notes->edits) : std::vector<Edit>{};
    const EditedPlanes edited =
        applyEdits(*extraction.snapshot, edits, extraction.recording.description, extraction.parameters);
    const std::string place = path + ": ";
    for (const std::string& problem : edited.problems)
        printWarning(place + problem);
    extraction.snapshot = std::make_shared<const Snapshot>(withPlanes(*extraction.snapshot, edited));
    extraction.planes = planeResults(edited.planes, extraction.snapshot->segments);
}

}  // namespace planewright
