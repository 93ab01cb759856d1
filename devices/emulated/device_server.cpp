// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/device_server.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

/// A device does not tell beforehand when its plug is pulled out: so one looks.
constexpr std::chrono::milliseconds kLongestWait{50};

}  // namespace

Result<std::string> DeviceServer::add(EmulatedDevice& device, const std::string& where)
{
    Result<std::unique_ptr<ServedLine>> line = ServedLine::open(where);
    if (!line)
        return tl::unexpected<Error>(line.error());
    all_.push_back({device, std::move(*line)});
    return all_.back().line->address();
}

Result<void> DeviceServer::run(const std::stop_token& stop)
{
    const WakeEvent stopped;
    if (!stopped.isOpen())
        return fail(ErrorCode::Internal, "the system has no files left; end other programs and try again");
    const std::stop_callback raise{stop, [&] { stopped.raise(); }};
    while (!stop.stop_requested()) {
        std::chrono::nanoseconds next = clock_.now() + kLongestWait;
        for (Served& served : all_)
            next = std::min(next, serve(served));
        waitUntil(next, stopped);
    }
    return {};
}

std::chrono::nanoseconds DeviceServer::serve(Served& served)
{
    const std::chrono::nanoseconds now = clock_.now();
    served.line->setPluggedIn(served.device.isConnected(now));
    const std::vector<std::uint8_t> received = served.line->serve();
    if (!received.empty())
        served.device.receive(received, now);
    for (const EmulatedOutput& output : served.device.takeOutput(now))
        served.line->send(output.bytes);
    const auto never = now + kLongestWait;
    const auto lookAgain = served.line->patience();
    return std::min(served.device.nextOutput().value_or(never), lookAgain ? now + *lookAgain : never);
}

void DeviceServer::waitUntil(std::chrono::nanoseconds moment, const WakeEvent& stopped)
{
    watched_.clear();
    for (const Served& served : all_)
        served.line->watch(watched_);
    waitUntilAnyReady(watched_, stopped, moment - clock_.now());
}

}  // namespace planewright
