// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/devices/transport/usb_rig.h"

#include <array>
#include <condition_variable>
#include <mutex>
#include <random>
#include <stdexcept>

namespace planewright {

namespace {

constexpr std::chrono::seconds kPatience{10};
constexpr std::chrono::milliseconds kLook{2};

}  // namespace

UsbRig::UsbRig(UsbWatch watch)
{
    auto started = UsbBus::start(
        steadyClock(), [this] { ++changes; }, watch);
    if (!started)
        throw std::runtime_error(started.error().message);
    bus = std::move(*started);
}

std::vector<UsbDevice> UsbRig::devices(std::size_t count) const
{
    std::vector<UsbDevice> found;
    comesTrue([&] {
        found = bus->devices();
        return found.size() == count;
    });
    return found;
}

bool comesTrue(const std::function<bool()>& what)
{
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    const auto until = in(kPatience);
    while (!what()) {
        if (steadyClock().now() > until)
            return false;
        steadyClock().wait(lock, never, {}, in(kLook));
    }
    return true;
}

std::vector<std::uint8_t> readBytes(Transport& transport, std::size_t count)
{
    std::vector<std::uint8_t> all;
    std::array<std::uint8_t, 4096> into{};
    const auto until = in(kPatience);
    while (all.size() < count && steadyClock().now() < until) {
        const auto arrival = transport.read(into, until, {});
        if (!arrival)
            break;
        all.insert(all.end(), into.begin(), into.begin() + static_cast<std::ptrdiff_t>(arrival->count));
    }
    return all;
}

std::optional<Error> readToTheEnd(Transport& transport)
{
    std::array<std::uint8_t, 4096> into{};
    const auto until = in(kPatience);
    while (steadyClock().now() < until) {
        if (const auto arrival = transport.read(into, until, {}); !arrival)
            return arrival.error();
    }
    return std::nullopt;
}

std::vector<std::uint8_t> pattern(std::size_t count, std::uint32_t seed)
{
    std::mt19937 engine{seed};
    std::vector<std::uint8_t> bytes(count);
    for (std::uint8_t& byte : bytes)
        byte = static_cast<std::uint8_t>(engine());
    return bytes;
}

std::chrono::nanoseconds in(std::chrono::nanoseconds time)
{
    return steadyClock().now() + time;
}

}  // namespace planewright
