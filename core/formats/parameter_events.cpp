// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/parameter_events.h"

#include <sstream>
#include <utility>

#include "core/formats/preset_file.h"

namespace planewright {

ScanEvent parametersEvent(int step, const Parameters& parameters)
{
    std::ostringstream payload;
    [[maybe_unused]] const auto written = writePresetFile(payload, parameters);  // a text in memory takes all
    return {ScanEvent::Kind::Parameters, step, std::nullopt, payload.str()};
}

Result<std::vector<ParametersFrom>> readParameterEvents(const std::vector<ScanEvent>& events,
                                                        const std::string& fileName)
{
    std::vector<ParametersFrom> all;
    for (const ScanEvent& event : events) {
        if (event.kind != ScanEvent::Kind::Parameters)
            continue;
        const int step = event.step.value_or(0);
        const std::string place = fileName + ": the parameters stored for step " + std::to_string(step);
        ParametersFrom from{step, {}};
        std::istringstream payload{event.payload};
        if (const auto read = readPresetFile(payload, place, from.parameters); !read)
            return fail(ErrorCode::Unreadable, read.error().message + ", or give --preset");
        // What was said before of this step and of those behind it holds no more: the scan was extracted once more.
        std::erase_if(all, [&](const ParametersFrom& before) { return before.step >= step; });
        all.push_back(std::move(from));
    }
    return all;
}

}  // namespace planewright
