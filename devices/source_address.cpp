// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/source_address.h"

#include <string_view>
#include <utility>

#include "devices/address_text.h"
#include "devices/pacer.h"

namespace planewright {

namespace {

constexpr std::string_view kSimulation = "sim:";
constexpr std::string_view kReplay = "replay:";

/// Sets what one KEY=VALUE says; gives what is wrong with it, or nothing.
std::string takeOption(std::string_view key, std::string_view value, SourceAddress& address)
{
    const std::string given = std::string{key} + " '" + std::string{value} + "' is not ";
    if (key == "seed" && address.kind == SourceAddress::Kind::Simulation) {
        if (!readsNumber(value, address.seed))
            return given + "a whole number from 0 to 18446744073709551615";
    } else if (key == "speed") {
        if (!readsNumber(value, address.speed) || !isReplaySpeed(address.speed))
            return given + "0, as fast as possible, or a number from 0.01 to 1000";
    } else {
        return "there is no option '" + std::string{key} +
               "'; known: " + (address.kind == SourceAddress::Kind::Simulation ? "seed, speed" : "speed");
    }
    return {};
}

Result<SourceAddress> laserAt(const std::string& text)
{
    Result<DeviceAddress> device = parseDeviceAddress(text);
    if (!device)
        return tl::unexpected<Error>(device.error());
    if (device->unit != DeviceAddress::Unit::Laser)
        return fail(ErrorCode::Usage, "'" + text +
                                          "': is a tilt unit; the scanner is its laser, as in usb:, "
                                          "tcp:192.168.0.10:10940 or serial:/dev/ttyACM0");
    SourceAddress address;
    address.kind = SourceAddress::Kind::Laser;
    address.name = text;
    address.laser = std::move(*device);
    return address;
}

}  // namespace

Result<SourceAddress> parseSourceAddress(const std::string& text)
{
    const auto refuse = [&](const std::string& why) { return fail(ErrorCode::Usage, "'" + text + "': " + why); };
    if (isDeviceAddress(text))
        return laserAt(text);
    SourceAddress address;
    std::string_view rest = text;
    if (rest.starts_with(kSimulation)) {
        address.kind = SourceAddress::Kind::Simulation;
        rest.remove_prefix(kSimulation.size());
    } else if (rest.starts_with(kReplay)) {
        address.kind = SourceAddress::Kind::Replay;
        rest.remove_prefix(kReplay.size());
    }
    if (address.kind != SourceAddress::Kind::File) {
        const std::string problem = readOptions(takeOptions(rest), [&](std::string_view key, std::string_view value) {
            return takeOption(key, value, address);
        });
        if (!problem.empty())
            return refuse(problem);
    }
    if (rest.empty())
        return refuse(address.kind == SourceAddress::Kind::Simulation ? "give a scene, as in sim:corridor"
                                                                      : "give the name of a file");
    address.name = rest;
    return address;
}

}  // namespace planewright
