// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "core/formats/parameter_events.h"
#include "core/formats/plane_result.h"
#include "core/formats/planes_csv.h"
#include "core/formats/recorded_slice.h"
#include "core/geometry/correct_recording.h"
#include "core/pipeline/plane_extractor.h"

namespace planewright {

/// The planes of a snapshot, as files have them.
inline std::string planesText(const Snapshot& snapshot)
{
    std::ostringstream text;
    [[maybe_unused]] const auto written = writePlanesCsv(text, planeResults(snapshot));
    return text.str();
}

/// The planes of a recording, extracted in one go as the command line does it.
inline std::string batchPlanes(Recording recording, const std::vector<ParametersFrom>& parameters)
{
    std::erase_if(recording.slices, [](const ScanSlice& slice) { return slice.angleSuspect; });
    correctRecording(recording, parameters.front().parameters.sensor);
    PlaneExtractor extractor{sensorOf(recording.description), parameters.front().parameters};
    std::size_t next = 1;
    for (const ScanSlice& slice : recording.slices) {
        for (; next < parameters.size() && parameters[next].step <= slice.step; ++next)
            extractor.setParameters(parameters[next].parameters);
        extractor.step(slice);
    }
    for (; next < parameters.size(); ++next)
        extractor.setParameters(parameters[next].parameters);
    return planesText(*extractor.finish());
}

/// A scan as its recording gives it back.
inline Recording asRecorded(Recording recording)
{
    recording.description = asRecorded(std::move(recording.description));
    for (ScanSlice& slice : recording.slices)
        slice = asRecorded(std::move(slice));
    return recording;
}

}  // namespace planewright
