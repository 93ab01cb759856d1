// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/json_text.h"
#include "app/cli/signal_watch.h"
#include "app/sources/device_opener.h"
#include "app/sources/found_devices.h"
#include "app/sources/unit_tasks.h"

namespace planewright {

namespace {

struct DevicesOptions {
    bool json = false;
    std::string home;     ///< address of a unit to bring to level
    std::string recover;  ///< address of a unit to release
};

/// Does on a thread of its own what takes its time: a signal ends it, and holds at once what moves.
template <class Value>
Value doWatched(const SignalWatch& signals, std::optional<int>& interrupted,
                const std::function<Value(const std::stop_token&)>& work)
{
    constexpr std::chrono::milliseconds kLookEvery{50};
    std::optional<Value> value;
    std::atomic<bool> isDone{false};
    std::jthread working([&](const std::stop_token& stop) {
        value.emplace(work(stop));
        isDone = true;
    });
    while (!isDone) {
        if (const auto signal = signals.wait(kLookEvery)) {
            interrupted = signal;
            working.request_stop();
        }
    }
    working.join();
    return std::move(*value);
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
    // Asking takes a second for each laser.
    const auto found = doWatched<FoundDevices>(signals, interrupted, [](const std::stop_token& stop) {
        DeviceOpener opener(steadyClock());
        return findDevices(opener, true, {}, stop);
    });
    if (interrupted)
        return static_cast<ExitCode>(128 + *interrupted);
    if (!found.usbProblem.empty())
        printWarning(found.usbProblem);
    const Result<void> printed = print(json ? asJson(found.devices) : asText(found.devices));
    if (!printed)
        return tl::unexpected{printed.error()};
    return ExitCode::Done;
}

Result<std::string> home(const DeviceAddress& unit, const std::stop_token& stop)
{
    DeviceOpener opener(steadyClock());
    return bringUnitHome(opener, unit, steadyClock(), stop);
}

Result<std::string> recover(const DeviceAddress& unit, const std::stop_token& stop)
{
    DeviceOpener opener(steadyClock());
    return releaseUnit(opener, unit, stop);
}

/// What one unit is to do, of an address that an option gives.
Result<ExitCode> withUnit(const std::string& option, const std::string& text,
                          Result<std::string> (*act)(const DeviceAddress&, const std::stop_token&))
{
    const auto address = parseDeviceAddress(text);
    if (!address)
        return fail(address.error().code, option + ": " + address.error().message);
    const SignalWatch signals;
    std::optional<int> interrupted;
    const auto done = doWatched<Result<std::string>>(signals, interrupted,
                                                     [&](const std::stop_token& stop) { return act(*address, stop); });
    if (!done && interrupted && done.error().code == ErrorCode::Interrupted) {
        printError(done.error().message);
        return static_cast<ExitCode>(128 + *interrupted);
    }
    if (!done)
        return tl::unexpected{done.error()};
    if (const Result<void> printed = print(*done + "\n"); !printed)
        return tl::unexpected{printed.error()};
    return interrupted ? static_cast<ExitCode>(128 + *interrupted) : ExitCode::Done;
}

Result<ExitCode> runDevices(const DevicesOptions& options)
{
    if (options.home.empty() && options.recover.empty())
        return listDevices(options.json);
    if (options.json)
        return fail(ErrorCode::Usage, "--json is for the list of devices; leave it out");
    if (!options.home.empty() && !options.recover.empty())
        return fail(ErrorCode::Usage, "--home, --recover: give one of them; look at the head before it moves again");
    if (!options.recover.empty())
        return withUnit("--recover", options.recover, recover);
    return withUnit("--home", options.home, home);
}

}  // namespace

void addDevicesCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand("devices", "what is connected, and the address of each");
    auto options = std::make_shared<DevicesOptions>();
    command.add_flag("--json", options->json, "as JSON");
    command
        .add_option("--home", options->home,
                    "bring the head of this tilt unit to level, slowly, and hold it there; Ctrl-C holds it at once")
        ->type_name("ADDRESS");
    command
        .add_option(
            "--recover", options->recover,
            "release this tilt unit, which has turned itself off or was stopped in an emergency, after you have "
            "seen to the cause; moves nothing")
        ->type_name("ADDRESS");
    command.callback([options, &chosen] { chosen = [options] { return runDevices(*options); }; });
}

}  // namespace planewright
