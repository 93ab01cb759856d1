// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_bus.h"

#include <algorithm>
#include <cassert>
#include <libusb.h>
#include <span>
#include <string>

#include "devices/transport/usb_error.h"
#include "devices/transport/usb_probe.h"

namespace planewright {

namespace {

constexpr std::chrono::nanoseconds kLongestWait = std::chrono::seconds{1};
constexpr std::chrono::nanoseconds kPollPeriod = std::chrono::seconds{1};
constexpr std::chrono::nanoseconds kPauseAfterError = std::chrono::milliseconds{100};

std::pair<std::uint8_t, std::uint8_t> placeOf(libusb_device* device)
{
    return {libusb_get_bus_number(device), libusb_get_device_address(device)};
}

}  // namespace

/// What libusb calls. It may do so for a device twice, or when it goes though it never came.
class UsbBus::Hotplug {
public:
    static int LIBUSB_CALL happened(libusb_context* /*context*/, libusb_device* device, libusb_hotplug_event event,
                                    void* bus)
    {
        auto& self = *static_cast<UsbBus*>(bus);
        const std::scoped_lock lock(self.mutex_);
        self.events_.push_back({libusb_ref_device(device), event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED});
        return 0;
    }
};

Result<std::shared_ptr<UsbBus>> UsbBus::start(const Clock& clock, std::function<void()> onChange, UsbWatch watch)
{
    libusb_context* context = nullptr;
    if (const int status = libusb_init(&context); status != LIBUSB_SUCCESS)
        return fail(ErrorCode::NoDevice, std::string{"USB cannot be used here ("} + libusb_error_name(status) +
                                             "); connect the device by a serial port or a network instead");
    std::shared_ptr<UsbBus> bus{new UsbBus(clock, std::move(onChange), context)};
    if (watch == UsbWatch::Polling || !bus->watchHotplug())
        bus->poll();
    bus->takeEvents();
    bus->changes_ = {};  // what was there from the beginning has not changed
    bus->thread_ = std::jthread{[self = bus.get()](const std::stop_token& stop) { self->run(stop); }};
    return bus;
}

UsbBus::UsbBus(const Clock& clock, std::function<void()> onChange, libusb_context* context)
    : clock_(clock), onChange_(std::move(onChange)), context_(context)
{
}

UsbBus::~UsbBus()
{
    assert(std::this_thread::get_id() != thread_.get_id());
    if (hotplug_)
        libusb_hotplug_deregister_callback(context_, *hotplug_);
    if (thread_.joinable()) {
        thread_.request_stop();
        libusb_interrupt_event_handler(context_);
        thread_.join();
    }
    for (const Event& event : events_)
        libusb_unref_device(event.device);
    while (!known_.empty())
        forget(known_.begin());
    libusb_exit(context_);
}

std::vector<UsbDevice> UsbBus::devices() const
{
    assert(std::this_thread::get_id() != thread_.get_id());
    std::vector<Known> known;
    {
        const std::scoped_lock lock(mutex_);
        for (const auto& [place, each] : known_) {
            known.push_back(each);
            libusb_ref_device(each.device);
        }
    }
    std::vector<UsbDevice> entries;
    for (Known& each : known) {
        each.entry.access = each.isLent ? UsbAccess::Busy : UsbAccess::Openable;
        if (probeUsbDevice(each.device, each.layout, each.entry))
            entries.push_back(std::move(each.entry));
        libusb_unref_device(each.device);
    }
    return entries;
}

Result<UsbBus::Loan> UsbBus::lend(const UsbDevice& device, std::function<void()> onGone)
{
    const std::scoped_lock lock(mutex_);
    const auto known = known_.find({device.bus, device.address});
    // An address may have gone to another device meanwhile.
    if (known == known_.end() || known->second.entry.vendor != device.vendor ||
        known->second.entry.product != device.product)
        return tl::unexpected<Error>(usbOpenError(device, LIBUSB_ERROR_NO_DEVICE));
    if (known->second.isLent)
        return fail(ErrorCode::NoDevice, device.name() + ": the device is in use here already; disconnect it first");
    known->second.isLent = true;
    known->second.onGone = std::move(onGone);
    return Loan{libusb_ref_device(known->second.device), known->second.layout};
}

void UsbBus::giveBack(libusb_device* device)
{
    const std::scoped_lock lock(mutex_);
    for (auto& [place, known] : known_) {
        if (known.device == device) {
            known.isLent = false;
            known.onGone = {};
        }
    }
}

bool UsbBus::watchHotplug()
{
    if (libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) == 0)
        return false;
    int handle = 0;
    const int status = libusb_hotplug_register_callback(
        context_, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, LIBUSB_HOTPLUG_ENUMERATE,
        LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, &Hotplug::happened, this,
        &handle);
    if (status != LIBUSB_SUCCESS)
        return false;
    hotplug_ = handle;
    return true;
}

void UsbBus::run(const std::stop_token& stop)
{
    while (!stop.stop_requested()) {
        handleEvents(stop);
        if (!hotplug_ && clock_.now() >= nextPoll_)
            poll();
        takeEvents();
        if (changes_.take(clock_.now()) && onChange_)
            onChange_();
    }
}

void UsbBus::handleEvents(const std::stop_token& stop)
{
    std::chrono::nanoseconds wait = kLongestWait;
    if (!hotplug_)
        wait = std::min(wait, nextPoll_ - clock_.now());
    if (const auto due = changes_.due())
        wait = std::min(wait, *due - clock_.now());
    const auto micros = std::chrono::duration_cast<std::chrono::microseconds>(std::max(wait, {})).count() + 1;
    timeval time{.tv_sec = micros / 1'000'000, .tv_usec = micros % 1'000'000};
    const int status = libusb_handle_events_timeout_completed(context_, &time, nullptr);
    if (status == LIBUSB_SUCCESS || status == LIBUSB_ERROR_INTERRUPTED)
        return;
    std::unique_lock lock(mutex_);  // an error that stays must not take the processor
    clock_.wait(lock, never_, stop, clock_.now() + kPauseAfterError);
}

void UsbBus::poll()
{
    nextPoll_ = clock_.now() + kPollPeriod;
    libusb_device** list = nullptr;
    const ssize_t count = libusb_get_device_list(context_, &list);
    if (count < 0)
        return;
    const std::scoped_lock lock(mutex_);
    const std::span devices{list, static_cast<std::size_t>(count)};
    for (const auto& [place, known] : known_) {
        if (std::find(devices.begin(), devices.end(), known.device) == devices.end())
            events_.push_back({libusb_ref_device(known.device), false});
    }
    for (libusb_device* device : devices)
        events_.push_back({libusb_ref_device(device), true});
    libusb_free_device_list(list, 1);
}

void UsbBus::takeEvents()
{
    const std::scoped_lock lock(mutex_);
    for (const Event& event : std::exchange(events_, {})) {
        if (event.hasArrived ? arrived(event.device) : left(event.device))
            changes_.note(clock_.now());
        libusb_unref_device(event.device);
    }
}

bool UsbBus::arrived(libusb_device* device)
{
    const Place place = placeOf(device);
    const auto there = known_.find(place);
    if (there != known_.end() && there->second.device == device)
        return false;
    const bool hasReplaced = there != known_.end();  // its going was not told
    if (hasReplaced)
        forget(there);
    const auto found = identifyUsbDevice(device);
    if (!found)
        return hasReplaced;
    known_.emplace(place, Known{libusb_ref_device(device), found->entry, found->layout, false, {}});
    return true;
}

bool UsbBus::left(libusb_device* device)
{
    const auto there = known_.find(placeOf(device));
    if (there == known_.end() || there->second.device != device)
        return false;
    forget(there);
    return true;
}

void UsbBus::forget(std::map<Place, Known>::iterator known)
{
    if (known->second.onGone)
        known->second.onGone();
    libusb_unref_device(known->second.device);
    known_.erase(known);
}

}  // namespace planewright
