// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/extraction_run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "app/cli/progress.h"
#include "core/evaluation/data_access_ratio.h"
#include "core/formats/recording_csv.h"
#include "core/geometry/sensor_model.h"
#include "core/pipeline/plane_extractor.h"

namespace planewright {

namespace {

using std::chrono::nanoseconds;

nanoseconds now()
{
    return std::chrono::steady_clock::now().time_since_epoch();
}

/// The times of one run.
struct RunTimes {
    nanoseconds total{};
    std::array<nanoseconds, kPhases> phases{};
    std::vector<nanoseconds> steps;
};

/// The value that so much of all values do not exceed (nearest rank), share from 0 to 1.
nanoseconds percentile(std::vector<nanoseconds> values, double share)
{
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(std::max(0.0, share * static_cast<double>(values.size()) - 1e-9));
    return values[std::min(rank, values.size() - 1)];
}

template <class Pick>
nanoseconds medianOver(const std::vector<RunTimes>& runs, Pick pick)
{
    std::vector<nanoseconds> values;
    values.reserve(runs.size());
    for (const RunTimes& run : runs)
        values.push_back(pick(run));
    return percentile(std::move(values), 0.5);
}

void setTimes(Stats& stats, const std::vector<RunTimes>& runs)
{
    stats.repeats = static_cast<int>(runs.size());
    stats.total = medianOver(runs, [](const RunTimes& run) { return run.total; });
    for (std::size_t phase = 0; phase < kPhases; ++phase)
        stats.phases[phase] = medianOver(runs, [&](const RunTimes& run) { return run.phases[phase]; });
    std::vector<nanoseconds> steps(runs.front().steps.size());
    for (std::size_t step = 0; step < steps.size(); ++step)
        steps[step] = medianOver(runs, [&](const RunTimes& run) { return run.steps[step]; });
    stats.stepMedian = percentile(steps, 0.5);
    stats.step99 = percentile(steps, 0.99);
    stats.stepMax = percentile(steps, 1.0);
}

/// One run over all slices and the forced last pass.
class Run {
public:
    Run(const Recording& recording, std::span<const ParametersFrom> parameters, bool explain)
        : recording_(recording),
          later_(parameters.subspan(1)),
          extractor_(sensorOf(recording.description), parameters.front().parameters, {now, explain})
    {
    }

    template <class OnStep>
    Result<void> work(OnStep onStep)
    {
        for (const ScanSlice& slice : recording_.slices) {
            changeParametersUpTo(slice.step);
            const nanoseconds began = now();
            const StepReport report = extractor_.advance(slice);
            times_.steps.push_back(count(began, report));
            if (Result<void> heard = onStep(report); !heard)
                return heard;
        }
        changeParametersUpTo(kMaxStep);
        const nanoseconds began = now();
        snapshot_ = extractor_.finish();
        count(began, snapshot_->report);
        return onStep(snapshot_->report);
    }

    const std::shared_ptr<const Snapshot>& snapshot() const { return snapshot_; }
    RunTimes& times() { return times_; }

private:
    /// Parameters change between steps, and after the last one for the forced last pass.
    void changeParametersUpTo(int step)
    {
        for (; !later_.empty() && later_.front().step <= step; later_ = later_.subspan(1))
            extractor_.setParameters(later_.front().parameters);
    }

    /// Counts the time since then in; gives it.
    nanoseconds count(nanoseconds began, const StepReport& report)
    {
        const nanoseconds took = now() - began;
        times_.total += took;
        for (std::size_t phase = 0; phase < kPhases; ++phase)
            times_.phases[phase] += report.times[phase];
        return took;
    }

    const Recording& recording_;
    std::span<const ParametersFrom> later_;
    PlaneExtractor extractor_;
    std::shared_ptr<const Snapshot> snapshot_;
    RunTimes times_;
};

void setCounts(Stats& stats, const Recording& recording, const Snapshot& snapshot)
{
    for (const ScanSlice& slice : recording.slices)
        stats.points += static_cast<std::int64_t>(slice.ranges.size());
    stats.segments = static_cast<std::int64_t>(snapshot.segments.segmentCount());
    stats.fitted = snapshot.report.counts.fitted;
    stats.unfitted = snapshot.report.counts.unfitted;
    stats.planes = static_cast<std::int64_t>(snapshot.planes.size());
    stats.noise = snapshot.noise;
    stats.meanError = snapshot.report.counts.meanError;
    stats.dataAccessRatio =
        dataAccessRatio(static_cast<std::size_t>(stats.segments), static_cast<std::size_t>(stats.points));
}

}  // namespace

Result<ExtractionResult> runExtraction(const Recording& recording, std::span<const ParametersFrom> parameters,
                                       const ExtractionPlan& plan)
{
    ExtractionResult result;
    std::vector<RunTimes> runs;
    Progress progress("extracting, step");
    const std::size_t allSteps = recording.slices.size() * static_cast<std::size_t>(plan.repeats);
    std::size_t steps = 0;
    for (int repeat = 0; repeat < plan.repeats; ++repeat) {
        const bool explain = repeat == 0 && plan.onReport;
        Run run(recording, parameters, explain);
        const Result<void> worked = run.work([&](const StepReport& report) -> Result<void> {
            progress.show(std::min(++steps, allSteps), allSteps);
            if (repeat > 0)
                return {};
            result.stats.returns += report.counts.returns;
            result.stats.splits += report.counts.splits;
            result.stats.merges += report.counts.merges;
            return explain ? plan.onReport(report) : Result<void>{};
        });
        if (!worked)
            return tl::unexpected{worked.error()};
        if (repeat == 0)
            result.snapshot = run.snapshot();
        runs.push_back(std::move(run.times()));
    }
    setTimes(result.stats, runs);
    setCounts(result.stats, recording, *result.snapshot);
    return result;
}

}  // namespace planewright
