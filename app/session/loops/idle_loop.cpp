// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/idle_loop.h"

#include <exception>
#include <string>
#include <utility>

namespace planewright {

namespace {

constexpr std::chrono::milliseconds kLookEvery{500};

/// An exception of a library below must not end the program.
Result<std::optional<double>> broughtHome(ScanSource& source, const std::stop_token& stop)
try {
    return source.goHome(stop);
} catch (const std::exception& exception) {
    return fail(ErrorCode::Internal, source.name() + ": internal error: " + exception.what());
}

}  // namespace

IdleLoop::IdleLoop(ScanSource& source, const Clock& clock, IdleEvents events)
    : source_(source), clock_(clock), events_(std::move(events))
{
}

void IdleLoop::run()
{
    while (!stop_.stop_requested()) {
        if (takeWish())
            events_.onHome(broughtHome(source_, stop_.get_token()));
        lookAfter();
        std::unique_lock lock{mutex_};
        const auto until = clock_.now() + kLookEvery;
        while (!goesHome_ && !stop_.stop_requested() && clock_.now() < until)
            clock_.wait(lock, asked_, stop_.get_token(), until);
    }
}

void IdleLoop::lookAfter()
{
    std::vector<FaultRecord> records;
    try {
        source_.lookAfter(stop_.get_token());
        records = source_.takeLog();
    } catch (const std::exception& exception) {
        records = {{clock_.now(), "internal", std::string{"internal error: "} + exception.what(), {}}};
    }
    if (!records.empty())
        events_.onRecords(records);
}

bool IdleLoop::takeWish()
{
    const std::scoped_lock lock{mutex_};
    return std::exchange(goesHome_, false);
}

void IdleLoop::goHome()
{
    const std::scoped_lock lock{mutex_};
    goesHome_ = true;
    asked_.notify_all();
}

void IdleLoop::finish()
{
    stop_.request_stop();
}

}  // namespace planewright
