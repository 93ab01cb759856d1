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
#include "core/simulation/building.h"
#include "tests/benchmarks/heap.h"
#include "tests/benchmarks/scanned_floor.h"
#include "tests/core/mapping/simulated_floor.h"

using namespace planewright;

namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;
using SteadyClock = std::chrono::steady_clock;

/// A floor as it is seen, its planes drawn about the true ones: stops around a ring of corridors with rooms.
std::vector<SimulatedStop> drawnFloor(int aRing, std::uint64_t seed)
{
    SightNoise noise;
    noise.rays = 1500;
    noise.pointsPerRay = 60.0;
    return seeFloor(ringFloor(seed), ringRoute(aRing, seed), noise, seed);
}

/// A floor of another building as it is scanned, its planes extracted.
std::vector<SimulatedStop> scannedFloor(int aRing, std::uint64_t seed)
{
    const SimulatedBuilding building(1, seed);
    return scanFloor(building, building.route(aRing), seed).stops;
}

/// Stops on one floor; after so many of them the next, 60 m on: a campus.
template <class SeenFloor>
std::vector<Stop> campus(int stops, int aRing, SeenFloor seenFloor)
{
    std::vector<Stop> seen;
    Pose last;
    for (int ring = 0; static_cast<int>(seen.size()) < stops; ++ring) {
        auto there = seenFloor(aRing, static_cast<std::uint64_t>(ring + 1));
        const int count = std::min(aRing, stops - ring * aRing);
        there.resize(static_cast<std::size_t>(count));
        const Pose place{Eigen::Quaterniond::Identity(), {60.0 * (ring % 25), 60.0 * (ring / 25), 0.0}};
        if (ring > 0) {
            const Pose motion = last.inverse() * (place * there[0].truth);
            there[0].stop.odometry = Motion{motion, odometryCovariance(motion, {})};
        }
        last = place * there.back().truth;
        for (SimulatedStop& stop : there) {
            stop.stop.id = static_cast<int>(seen.size());
            seen.push_back(std::move(stop.stop));
        }
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
    const std::vector<Stop> stops = campus(20, 20, drawnFloor);
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
    const std::vector<Stop> stops = campus(70, 70, drawnFloor);
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
template <class SeenFloor>
void joinManyStops(benchmark::State& state, SeenFloor seenFloor)
{
    const std::vector<Stop> stops = campus(static_cast<int>(state.range(0)), 20, seenFloor);
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
BENCHMARK_CAPTURE(joinManyStops, drawn, drawnFloor)
    ->Arg(1000)
    ->Arg(10000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(joinManyStops, scanned, scannedFloor)
    ->Arg(1000)
    ->Arg(10000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
