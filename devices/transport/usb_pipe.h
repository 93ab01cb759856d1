// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "devices/clock.h"
#include "devices/transport/byte_queue.h"
#include "devices/transport/transport.h"
#include "devices/transport/usb_handle.h"

struct libusb_transfer;

namespace planewright {

/// The bulk endpoints of a USB device as a transport: what CDC-ACM and FTDI have in common.
///
/// Eight transfers wait for bytes at all times, so that none is late while another is handed on. Where a transfer ends
/// means nothing: one that has got bytes but no end of them, since a device sent whole packets and no empty one after
/// them, is fetched when the reader has waited for 50 ms; such bytes bear that time. An endpoint that stalls is freed
/// up to three times in a row; whatever tells first that the device is gone, a transfer or the system, ends the link,
/// once.
class UsbPipe : public Transport {
public:
    /// Sees the bytes of each transfer on the event thread, and gives how many are for the reader, moved to the front.
    using Filter = std::function<std::size_t(std::span<std::uint8_t> bytes, std::size_t packetSize)>;

    /// Opens and claims the device, lets `setUp` send it its settings, and then begins to receive. `setUp` gives a
    /// status of libusb.
    ///
    /// Errors (NoDevice): usbOpenError().
    static Result<std::unique_ptr<UsbPipe>> open(std::shared_ptr<UsbBus> bus, const UsbDevice& device,
                                                 const Clock& clock, const std::function<int(const UsbHandle&)>& setUp,
                                                 Filter filter = {});
    ~UsbPipe() override;

    std::string name() const override { return name_; }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override;
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override;
    /// Waits for every transfer to come back. Not on the bus's event thread.
    void close() override;

    /// Sends a setting while open. Errors (DeviceLost): gone, closed, or refused.
    Result<void> control(const UsbRequest& request);

private:
    struct Incoming {
        UsbPipe* pipe = nullptr;
        libusb_transfer* transfer = nullptr;
        std::vector<std::uint8_t> buffer;
        std::uint64_t number = 0;  ///< in the order in which they were submitted, and come back
        bool isInFlight = false;
    };
    /// How a transfer out came back.
    struct Sent {
        int status = 0;  ///< of libusb's transfers; negative: its error
        std::size_t count = 0;
    };
    class Callbacks;
    class Call;

    UsbPipe(std::string name, const Clock& clock, Filter filter);

    Result<void> receive();
    void submitAll();
    void cancelAll();
    void fetchOldest();
    void arrived(Incoming& incoming);
    void stalled(const char* what);
    void failed(int error);
    void mendStalls(const std::stop_token& stop);
    Sent send(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline);
    Error whyEnded() const;

    std::string name_;
    const Clock& clock_;
    Filter filter_;
    ByteQueue queue_;
    std::unique_ptr<UsbHandle> handle_;
    std::chrono::nanoseconds nextFetch_{0};  // of the reader

    std::mutex writing_;  ///< one transfer goes out at a time
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::array<Incoming, 8> incoming_;
    std::uint64_t submitted_ = 0;
    int inFlight_ = 0;
    int stallsInARow_ = 0;
    bool isStalled_ = false;  ///< transfers come home, and then the endpoint is freed
    libusb_transfer* outgoing_ = nullptr;
    std::vector<std::uint8_t> sending_;
    bool isSending_ = false;
    int calls_ = 0;  ///< that need the handle
    bool isClosing_ = false;
    bool isClosed_ = false;
    std::jthread mender_;
};

}  // namespace planewright
