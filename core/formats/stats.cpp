// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/stats.h"

#include <ostream>
#include <string>

#include "core/formats/json_text.h"
#include "core/formats/written.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

/// One JSON object as it grows.
class ObjectText {
public:
    void add(std::string_view key, std::string_view value)
    {
        text_ += text_.empty() ? "{\"" : ",\"";
        text_ += key;
        text_ += "\":";
        text_ += value;
    }
    void add(std::string_view key, std::int64_t value) { add(key, std::to_string(value)); }
    void add(std::string_view key, double value)
    {
        std::string number;
        appendJsonNumber(number, value);
        add(key, number);
    }
    void add(std::string_view key, std::chrono::nanoseconds time)
    {
        add(key, std::chrono::duration<double, std::milli>(time).count());
    }
    std::string text() const { return text_ + "}"; }

private:
    std::string text_;
};

}  // namespace

Result<void> writeStats(std::ostream& out, const Stats& stats)
{
    ObjectText times;
    times.add("total", stats.total);
    for (std::size_t phase = 0; phase < kPhases; ++phase)
        times.add(kPhaseNames[phase], stats.phases[phase]);
    ObjectText steps;
    steps.add("p50", stats.stepMedian);
    steps.add("p99", stats.step99);
    steps.add("max", stats.stepMax);

    ObjectText noise;
    noise.add("range_constant_m", stats.noise.rangeConstant);
    noise.add("range_proportional", stats.noise.rangeProportional);
    noise.add("pitch_deg", toDegrees(stats.noise.pitch));
    noise.add("estimated", std::string_view(stats.noise.estimated ? "true" : "false"));

    ObjectText all;
    all.add("format", R"("planewright-stats 1")");
    all.add("points", stats.points);
    all.add("returns", stats.returns);
    all.add("segments", stats.segments);
    all.add("fitted", stats.fitted);
    all.add("unfitted", stats.unfitted);
    all.add("planes", stats.planes);
    all.add("splits", stats.splits);
    all.add("merges", stats.merges);
    all.add("mean_error", stats.meanError);
    all.add("dar_percent", stats.dataAccessRatio);
    all.add("noise", noise.text());
    all.add("time_ms", times.text());
    all.add("step_ms", steps.text());
    all.add("repeats", std::int64_t{stats.repeats});
    out << all.text() << "\n";
    return written(out);
}

}  // namespace planewright
