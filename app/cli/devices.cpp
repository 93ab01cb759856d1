// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/json_text.h"
#include "app/cli/signal_watch.h"
#include "app/sources/found_devices.h"

namespace planewright {

namespace {

/// Asking takes a second for each laser; a signal ends it.
std::vector<FoundDevice> findWatched(const SignalWatch& signals, std::optional<int>& interrupted)
{
    constexpr std::chrono::milliseconds kLookEvery{50};
    std::vector<FoundDevice> found;
    std::atomic<bool> isDone{false};
    std::jthread asking([&](const std::stop_token& stop) {
        DeviceOpener opener(steadyClock());
        found = findDevices(opener, true, stop);
        isDone = true;
    });
    while (!isDone) {
        if (const auto signal = signals.wait(kLookEvery)) {
            interrupted = signal;
            asking.request_stop();
        }
    }
    asking.join();
    return found;
}

std::string asText(const std::vector<FoundDevice>& devices)
{
    if (devices.empty())
        return "Nothing is connected by USB or at a serial port. A laser with a network plug is tcp:HOST:PORT, as in "
               "tcp:192.168.0.10:10940.\n";
    std::string text;
    for (const FoundDevice& device : devices) {
        text +=
            device.address + "\n    " + nameOf(device.kind) + (device.name.empty() ? "" : ": " + device.name) + "\n";
        if (!device.problem.empty())
            text += "    " + device.problem + "\n";
    }
    return text;
}

std::string asJson(const std::vector<FoundDevice>& devices)
{
    Json list = Json::array();
    for (const FoundDevice& device : devices)
        list.push_back({{"address", device.address},
                        {"kind", nameOf(device.kind)},
                        {"name", device.name},
                        {"problem", device.problem.empty() ? Json() : Json(device.problem)}});
    return jsonText(list);
}

Result<ExitCode> listDevices(bool json)
{
    const SignalWatch signals;
    std::optional<int> interrupted;
    const std::vector<FoundDevice> devices = findWatched(signals, interrupted);
    if (interrupted)
        return static_cast<ExitCode>(128 + *interrupted);
    const Result<void> printed = print(json ? asJson(devices) : asText(devices));
    if (!printed)
        return tl::unexpected{printed.error()};
    return ExitCode::Done;
}

}  // namespace

void addDevicesCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand("devices", "what is connected, and the address of each");
    auto json = std::make_shared<bool>(false);
    command.add_flag("--json", *json, "as JSON");
    command.callback([json, &chosen] { chosen = [json] { return listDevices(*json); }; });
}

}  // namespace planewright
