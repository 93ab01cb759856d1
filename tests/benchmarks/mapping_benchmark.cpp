// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <span>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/mapping/map_builder.h"
#include "tests/benchmarks/heap.h"
#include "tests/core/mapping/simulated_floor.h"

using namespace planewright;

namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;
using SteadyClock = std::chrono::steady_clock;

/// Stops around a ring of corridors with rooms; after 20 of them the next ring, 60 m on: a campus.
std::vector<Stop> campus(int stops, int aRing)
{
    SightNoise noise;
    noise.rays = 1500;
    noise.pointsPerRay = 60.0;
    std::vector<Stop> seen;
    Pose last;
    for (int ring = 0; static_cast<int>(seen.size()) < stops; ++ring) {
        const auto seed = static_cast<std::uint64_t>(ring + 1);
        const int count = std::min(aRing, stops - ring * aRing);
        const std::vector<Pose> route = ringRoute(aRing, seed);
        auto there = seeFloor(ringFloor(seed), {route.begin(), route.begin() + count}, noise, seed);
        const Pose place{Eigen::Quaterniond::Identity(), {60.0 * (ring % 25), 60.0 * (ring / 25), 0.0}};
        if (ring > 0) {
            const Pose motion = last.inverse() * (place * there[0].truth);
            there[0].stop.odometry = Motion{motion, odometryCovariance(motion, {})};
        }
        last = place * there.back().truth;
        for (SimulatedStop& stop : there)
            seen.push_back(std::move(stop.stop));
    }
    return seen;
}

/// Times of all joins [ms]; gives up where a stop is refused.
std::vector<double> joinAll(MapBuilder& builder, const std::vector<Stop>& stops)
{
    std::vector<double> times;
    times.reserve(stops.size());
    for (const Stop& stop : stops) {
        const auto start = SteadyClock::now();
        if (!builder.join(stop))
            std::abort();
        times.push_back(Milliseconds(SteadyClock::now() - start).count());
    }
    return times;
}

double mean(std::span<const double> values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void joinTwentyStops(benchmark::State& state)
{
    const std::vector<Stop> stops = campus(20, 20);
    std::vector<double> best(stops.size(), INFINITY);
    for ([[maybe_unused]] const auto _ : state) {
        MapBuilder builder;
        const std::vector<double> times = joinAll(builder, stops);
        for (std::size_t i = 0; i < times.size(); ++i)
            best[i] = std::min(best[i], times[i]);
    }
    state.counters["stop_ms"] = mean(best);
    state.counters["slowest_stop_ms"] = *std::ranges::max_element(best);
}

void adjustSeventyStops(benchmark::State& state)
{
    const std::vector<Stop> stops = campus(70, 70);
    MapBuilder joined;
    joinAll(joined, stops);
    for ([[maybe_unused]] const auto _ : state) {
        state.PauseTiming();
        MapBuilder builder = joined;
        state.ResumeTiming();
        if (!builder.adjust())
            std::abort();
    }
    state.counters["planes"] = static_cast<double>(joined.map().planes.size());
}

/// What a stop costs in time and memory, the first thousand but ten against the last thousand.
void joinManyStops(benchmark::State& state)
{
    const std::vector<Stop> stops = campus(static_cast<int>(state.range(0)), 20);
    for ([[maybe_unused]] const auto _ : state) {
        MapBuilder builder;
        const std::size_t half = stops.size() / 2;
        const std::int64_t empty = heap.held;
        std::vector<double> times =
            joinAll(builder, {stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(half)});
        const std::int64_t atHalf = heap.held;
        const std::vector<double> later =
            joinAll(builder, {stops.begin() + static_cast<std::ptrdiff_t>(half), stops.end()});
        const std::int64_t atEnd = heap.held;
        times.insert(times.end(), later.begin(), later.end());
        const std::span<const double> told(times);
        const std::size_t some = std::min<std::size_t>(1000, half);
        const double first = mean(told.subspan(10, some - 10));
        const double last = mean(told.last(some));
        state.counters["first_stops_ms"] = first;
        state.counters["last_stops_ms"] = last;
        state.counters["time_ratio"] = last / first;
        state.counters["slowest_stop_ms"] = *std::ranges::max_element(times);
        state.counters["kB_a_stop"] = static_cast<double>(atEnd - empty) / 1024.0 / static_cast<double>(stops.size());
        state.counters["memory_ratio"] = static_cast<double>(atEnd - atHalf) / static_cast<double>(atHalf - empty);
    }
}

}  // namespace

BENCHMARK(joinTwentyStops)->Unit(benchmark::kMillisecond);
BENCHMARK(adjustSeventyStops)->Unit(benchmark::kMillisecond);
BENCHMARK(joinManyStops)->Arg(1000)->Arg(10000)->Iterations(1)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
