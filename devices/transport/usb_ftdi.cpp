// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_ftdi.h"

#include <libusb.h>

#include "devices/transport/usb_layout.h"

namespace planewright {

namespace {

constexpr std::uint8_t kToDevice = 0x40;  // vendor request, host to device

UsbRequest rateRequest(const FtdiDivisor& divisor)
{
    return {kToDevice, 3, divisor.value, divisor.index};
}

int setUpChip(const UsbHandle& handle, const FtdiDivisor& divisor)
{
    for (const UsbRequest& request : {UsbRequest{kToDevice, 0, 0, 0},  // reset
                                      UsbRequest{kToDevice, 0, 1, 0},  // drop what it has received
                                      UsbRequest{kToDevice, 0, 2, 0},  // and what it has to send
                                      rateRequest(divisor), UsbRequest{kToDevice, 4, 8, 0},  // 8N1
                                      UsbRequest{kToDevice, 2, 0, 0},                        // no flow control
                                      UsbRequest{kToDevice, 9, 1, 0}}) {                     // latency timer [ms]
        if (const int status = handle.control(request); status != LIBUSB_SUCCESS)
            return status;
    }
    return LIBUSB_SUCCESS;
}

}  // namespace

Result<std::unique_ptr<UsbFtdi>> UsbFtdi::open(std::shared_ptr<UsbBus> bus, const UsbDevice& device, int rate,
                                               const Clock& clock)
{
    const FtdiChip chip = device.product == kFt232h ? FtdiChip::Ft232h : FtdiChip::Ft232r;
    const auto divisor = ftdiDivisor(chip, rate);
    if (!divisor)
        return tl::unexpected<Error>(divisor.error());
    std::unique_ptr<UsbFtdi> self{new UsbFtdi(chip)};
    auto pipe = UsbPipe::open(
        std::move(bus), device, clock, [&](const UsbHandle& handle) { return setUpChip(handle, *divisor); },
        [ftdi = self.get()](std::span<std::uint8_t> bytes, std::size_t packetSize) {
            const FtdiPayload payload = stripFtdiStatus(bytes, packetSize);
            ftdi->overruns_ += payload.overruns;
            return payload.count;
        });
    if (!pipe)
        return tl::unexpected<Error>(pipe.error());
    self->pipe_ = std::move(*pipe);
    return self;
}

Result<Transport::Arrival> UsbFtdi::read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                                         const std::stop_token& stop)
{
    return pipe_->read(into, deadline, stop);
}

Result<void> UsbFtdi::write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline)
{
    return pipe_->write(bytes, deadline);
}

Result<void> UsbFtdi::setRate(int rate)
{
    const auto divisor = ftdiDivisor(chip_, rate);
    if (!divisor)
        return tl::unexpected<Error>(divisor.error());
    return pipe_->control(rateRequest(*divisor));
}

}  // namespace planewright
