// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/transport/ftdi_wire.h"
#include "devices/transport/transport.h"
#include "devices/transport/usb_pipe.h"

namespace planewright {

/// A serial line behind a converter of FTDI, without the kernel's driver: 8N1, no flow control. Answers come after 1 ms
/// instead of the chip's 16 ms, which needs no setting of the system.
class UsbFtdi : public Transport {
public:
    /// Opens a converter at a baud rate [1/s].
    ///
    /// Errors (NoDevice): no right, another program, gone, no answer; Usage: no such rate.
    static Result<std::unique_ptr<UsbFtdi>> open(std::shared_ptr<UsbBus> bus, const UsbDevice& device, int rate,
                                                 const Clock& clock);

    std::string name() const override { return pipe_->name(); }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override;
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override;
    void close() override { pipe_->close(); }
    TransportHealth health() const override { return {overruns(), {}}; }

    /// Another baud rate from now on. Errors (Usage): no such rate; DeviceLost: gone or closed.
    Result<void> setRate(int rate);

    /// How often the chip has told that it lost bytes, because they were not fetched in time.
    std::uint64_t overruns() const { return overruns_; }

private:
    explicit UsbFtdi(FtdiChip chip) : chip_(chip) {}

    FtdiChip chip_;
    std::atomic<std::uint64_t> overruns_{0};
    std::unique_ptr<UsbPipe> pipe_;  ///< last, since what it receives is counted above
};

}  // namespace planewright
