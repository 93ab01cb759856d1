// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/transport/change_limiter.h"
#include "devices/transport/usb_device.h"
#include "devices/transport/usb_layout.h"

struct libusb_context;
struct libusb_device;

namespace planewright {

/// How the bus learns of devices that come and go.
enum class UsbWatch {
    Hotplug,  ///< the system tells; where it does not, the bus asks
    Polling,  ///< the bus asks once a second
};

/// The USB devices of this machine that a transport can be opened on, and the one thread on which all that comes from
/// USB arrives.
///
/// Transports share it and keep it alive; it ends with the last of them, which must not be let go on its own thread.
class UsbBus {
public:
    /// `onChange` is called on the event thread when a device has come or gone, at most twice a second while many do.
    /// It only takes note of that for others: on that thread nothing of USB may be waited for, opened or closed.
    ///
    /// Errors (NoDevice): this machine has no USB that programs may use.
    static Result<std::shared_ptr<UsbBus>> start(const Clock& clock, std::function<void()> onChange = {},
                                                 UsbWatch watch = UsbWatch::Hotplug);
    ~UsbBus();
    UsbBus(const UsbBus&) = delete;
    UsbBus& operator=(const UsbBus&) = delete;

    /// The devices that are there now, by bus and address. Opens each for a moment, to see whether it may be opened, so
    /// a device that is ill can take seconds: not for a thread that people wait for.
    std::vector<UsbDevice> devices() const;

    /// A device that was lent to one transport, with a reference to it that the taker gives back to libusb.
    struct Loan {
        libusb_device* device = nullptr;
        UsbLayout layout;
    };

    /// Lends a device until giveBack(). `onGone` is called on the event thread when it is pulled out, never after
    /// giveBack(), and does no more than `onChange` does.
    ///
    /// Errors (NoDevice): it is not there, or lent already.
    Result<Loan> lend(const UsbDevice& device, std::function<void()> onGone);
    void giveBack(libusb_device* device);

private:
    UsbBus(const Clock& clock, std::function<void()> onChange, libusb_context* context);

    /// By bus and address, under which no two devices are at one time.
    using Place = std::pair<std::uint8_t, std::uint8_t>;
    struct Known {
        libusb_device* device;  ///< with a reference
        UsbDevice entry;
        UsbLayout layout;
        bool isLent;
        std::function<void()> onGone;
    };
    struct Event {
        libusb_device* device;  ///< with a reference
        bool hasArrived;
    };
    class Hotplug;

    bool watchHotplug();
    void run(const std::stop_token& stop);
    void handleEvents(const std::stop_token& stop);
    void poll();
    void takeEvents();
    bool arrived(libusb_device* device);
    bool left(libusb_device* device);
    void forget(std::map<Place, Known>::iterator known);

    const Clock& clock_;
    std::function<void()> onChange_;
    libusb_context* context_;
    std::optional<int> hotplug_;  ///< libusb's handle of the callback; empty: the bus polls
    std::chrono::nanoseconds nextPoll_{0};
    ChangeLimiter changes_;  // of the event thread

    mutable std::mutex mutex_;
    std::condition_variable_any never_;
    std::vector<Event> events_;
    std::map<Place, Known> known_;
    std::jthread thread_;
};

}  // namespace planewright
