// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_patience.h"

#include <utility>

namespace planewright {

namespace {

using std::chrono::milliseconds;
using Time = ScipLink::Time;

constexpr milliseconds kResetReply{2'000};
constexpr milliseconds kSilence{150};  ///< without a byte: nothing more comes
constexpr milliseconds kLongestDrain{2'000};

}  // namespace

tl::unexpected<Error> scipInterrupted(const ScipLink& link)
{
    return fail(ErrorCode::Interrupted, link.name() + ": stopped while the laser was being connected");
}

void tellScipCountdown(const ScipLink& link, Time deadline, const ScipProgress& progress)
{
    const auto left = std::chrono::ceil<std::chrono::seconds>(deadline - link.now()).count();
    if (progress && left > 0)
        progress(link.name() + ": waiting for the laser to start, up to " + std::to_string(left) + " s more");
}

Result<ScipReply> askScipPatiently(ScipLink& link, std::string_view request, ScipVersion version,
                                   const ScipProgress& progress, const std::stop_token& stop)
{
    const std::string_view command = readScipEcho(request)->command;
    const Time deadline = link.now() + kScipBootTime;
    for (;;) {
        if (stop.stop_requested())
            return scipInterrupted(link);
        auto reply = link.ask(request, kScipReply, stop);
        if (!reply)
            return tl::unexpected{reply.error()};
        if (stop.stop_requested())
            return scipInterrupted(link);
        if (*reply && scipMeaning(command, (*reply)->status, version).verdict != ScipVerdict::NotNow)
            return std::move(**reply);
        if (link.now() >= deadline)
            break;
        tellScipCountdown(link, deadline, progress);
        if (!*reply)
            continue;
        if (const auto waited = link.discard(kScipReply, kScipReply, stop); !waited)
            return tl::unexpected{waited.error()};
    }
    return fail(ErrorCode::NoDevice, link.name() + ": the laser has not become ready within " +
                                         std::to_string(kScipBootTime.count()) +
                                         " s; switch its power off and on, then connect again");
}

Result<void> resetScip(ScipLink& link, const std::stop_token& stop)
{
    const auto reset = link.ask(kScipReset, kResetReply, stop);
    if (!reset)
        return tl::unexpected{reset.error()};
    const auto drained = link.discard(kSilence, kLongestDrain, stop);
    return drained ? Result<void>{} : tl::unexpected{drained.error()};
}

}  // namespace planewright
