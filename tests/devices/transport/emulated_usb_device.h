// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/devices/transport/usb_models.h"

struct usbdevfs_urb;

namespace planewright {

/// A USB device as Linux shows it to programs: it answers the requests that a program makes on its node
/// (linux/usbdevice_fs.h), and has a far end that a test moves. Any thread may call all of it.
class EmulatedUsbDevice {
public:
    using Bytes = std::vector<std::uint8_t>;

    explicit EmulatedUsbDevice(UsbModel model) : model_(std::move(model)), drivers_(model_.drivers) {}

    const UsbModel& model() const { return model_; }

    // --- the far end -----------------------------------------------------------------------------------------------

    /// Called with what the host sends, before the host hears that it was taken. May call all that is below.
    void onReceive(std::function<void(std::span<const std::uint8_t>)> receive);

    /// Sends bytes in packets. Where the last is a full one, the host cannot know that nothing follows unless an empty
    /// packet is sent after it.
    void send(std::span<const std::uint8_t> bytes, bool withEmptyPacket = false);
    /// Sends one packet, of any size.
    void sendPacket(Bytes packet);

    /// The endpoint to the host, or from it, says so many times that it is stalled; each time until the host frees it.
    void stallIn(int times);
    void stallOut(int times);
    /// What the host sends waits from now on, after so many bytes were taken; or is taken again.
    void blockOut(std::size_t after = 0);
    void unblockOut();

    /// A setting that a host sent, with its data.
    struct Setting {
        std::uint8_t type;
        std::uint8_t request;
        std::uint16_t value;
        std::uint16_t index;
        Bytes data;
        bool operator==(const Setting&) const = default;
    };
    std::vector<Setting> settings() const;
    /// The device stalls on a request, or leaves all of them without an answer.
    void refuse(std::uint8_t request);
    void leaveSettingsUnanswered();

    /// The kernel's driver does not give up an interface from now on.
    void keep(int interface);
    /// The kernel's drivers are gone from all interfaces: what a program leaves that is killed.
    void loseDrivers();

    // --- what a test can see of the host ---------------------------------------------------------------------------

    int transfersIn() const;     ///< transfers for bytes to the host that are under way
    int transfersOut() const;    ///< and from the host
    int freedIn() const;         ///< how often the host has freed the endpoint to it
    int closedInFlight() const;  ///< how often it was closed with transfers under way, which is a fault
    std::size_t unread() const;  ///< packets that the host has not fetched
    bool isClaimed(int interface) const;
    /// Interfaces in the order in which they were given back.
    std::vector<int> released() const;
    std::string driver(int interface) const;  ///< kernel driver that has an interface now

    // --- the cable and the system ----------------------------------------------------------------------------------

    /// What a program waits on: called with true when there is something to fetch, with false when there is not.
    void plugIn(std::function<void(bool)> gate);
    /// Whoever waits is told of an error by `hangUp`, and all transfers come back as those of a device that is gone.
    void pullOut(const std::function<void()>& hangUp);

    /// A request of a program on the node that it has opened: what the call gives, and errno.
    struct Answer {
        int result = 0;
        int error = 0;
    };
    Answer ioctl(const void* opener, unsigned long request, void* argument);
    void closed(const void* opener);

private:
    /// A transfer of a program.
    struct Transfer {
        const void* opener;
        usbdevfs_urb* urb;
        std::size_t done = 0;
    };

    Answer submit(const void* opener, usbdevfs_urb* urb);
    Answer submitControl(const void* opener, usbdevfs_urb* urb);
    Answer submitOut(const void* opener, usbdevfs_urb* urb);
    Answer reap(const void* opener, usbdevfs_urb** urb);
    Answer discard(usbdevfs_urb* urb);
    Answer claim(const void* opener, int interface, bool withDriver);
    Answer release(const void* opener, int interface);
    Answer clearHalt(unsigned endpoint);
    bool answerString(const Transfer& transfer);
    void finish(const Transfer& transfer, int status);
    void moveIn();
    void updateGate();
    bool has(int interface) const;

    UsbModel model_;
    mutable std::mutex mutex_;
    std::function<void(std::span<const std::uint8_t>)> receive_;
    std::function<void(bool)> gate_;
    bool isThere_ = false;

    std::deque<Bytes> packets_;
    std::deque<Transfer> waitingIn_;
    std::deque<Transfer> waitingOut_;
    std::deque<Transfer> waitingControl_;
    std::map<const void*, std::deque<usbdevfs_urb*>> finished_;

    int stallsIn_ = 0;
    int stallsOut_ = 0;
    bool isHaltedIn_ = false;
    bool isHaltedOut_ = false;
    bool blocksOut_ = false;
    std::size_t takesBeforeBlock_ = 0;
    std::set<std::uint8_t> refused_;
    bool answersSettings_ = true;
    std::vector<Setting> settings_;

    std::vector<std::string> drivers_;
    std::set<int> kept_;
    std::map<int, const void*> claims_;
    std::vector<int> released_;
    int freedIn_ = 0;
    int closedInFlight_ = 0;
};

}  // namespace planewright
