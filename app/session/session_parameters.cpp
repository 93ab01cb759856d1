// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/session_parameters.h"

#include "core/params/presets.h"

namespace planewright {

std::vector<ParametersFrom> defaultParameters(const std::string& scanner, std::vector<ParametersFrom> stored)
{
    if (!stored.empty())
        return stored;
    Parameters parameters;
    apply(methodPresets().front(), parameters);
    if (const Preset* sensor = sensorOfScanner(scanner))
        apply(*sensor, parameters);
    return {{0, parameters}};
}

std::vector<ParametersFrom> parametersOf(const ScanHistory& history)
{
    std::vector<ParametersFrom> all;
    const Parameters* before = nullptr;
    int next = 0;
    for (const ExtractedStep& step : history.steps()) {
        const int number = step.measured ? step.measured->step : next;
        next = number + 1;
        if (step.parameters.get() == before)
            continue;
        before = step.parameters.get();
        all.push_back({all.empty() ? 0 : number, *step.parameters});
    }
    return all;
}

}  // namespace planewright
