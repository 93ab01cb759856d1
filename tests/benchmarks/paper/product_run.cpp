// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/benchmarks/paper/product_run.h"

#include <chrono>

#include "core/formats/labels.h"
#include "core/params/presets.h"
#include "core/pipeline/complete_labels.h"
#include "core/pipeline/plane_extractor.h"

namespace planewright {

Parameters presetParameters(std::string_view preset)
{
    Parameters parameters;
    apply(*findPreset(methodPresets(), preset), parameters);
    return parameters;
}

ProductRun runProduct(const Recording& recording, const Parameters& parameters, int repeats)
{
    using Clock = std::chrono::steady_clock;
    const SensorModel sensor = sensorOf(recording.description);
    ProductRun run;
    std::vector<double> times;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const auto start = Clock::now();
        PlaneExtractor extractor(sensor, parameters);
        for (const ScanSlice& slice : recording.slices)
            extractor.advance(slice);
        run.found = extractor.finish();
        times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    run.milliseconds = median(times);

    ExtractionOptions options;
    options.clock = [] { return std::chrono::nanoseconds(Clock::now().time_since_epoch()); };
    PlaneExtractor extractor(sensor, parameters, options);
    for (const ScanSlice& slice : recording.slices)
        run.reports.push_back(extractor.advance(slice));
    run.reports.push_back(extractor.conclude());
    return run;
}

Score judged(const ProductRun& run, const Recording& recording, const Parameters& parameters, const Judge& judge)
{
    Labels labels = labelsOf(*run.found, recording);
    completeLabels(labels, *run.found, recording, parameters);
    std::vector<ComparedPlane> planes;
    for (const auto& plane : run.found->planes)
        planes.push_back({plane->id, plane->normal, plane->distance});
    return judge.judge(labels, planes);
}

}  // namespace planewright
