// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_cdc.h"

#include <array>
#include <cstdint>
#include <libusb.h>

#include "devices/transport/usb_pipe.h"

namespace planewright {

namespace {

constexpr std::uint8_t kToInterface = 0x21;       // class request, host to interface
constexpr std::uint8_t kSetLineCoding = 0x20;     // PSTN 1.2 6.3.10
constexpr std::uint8_t kSetControlLines = 0x22;   // PSTN 1.2 6.3.12
constexpr std::uint16_t kReadyAndRequest = 0x03;  // DTR and RTS

/// 115200 baud, one stop bit, no parity, eight bits.
constexpr std::array<std::uint8_t, 7> kLineCoding{0x00, 0xC2, 0x01, 0x00, 0, 0, 8};

int setUpLine(const UsbHandle& handle)
{
    const std::uint16_t interface = handle.layout().controlInterface;
    for (const int status : {handle.control({kToInterface, kSetLineCoding, 0, interface}, kLineCoding),
                             handle.control({kToInterface, kSetControlLines, kReadyAndRequest, interface})}) {
        if (status != LIBUSB_SUCCESS && status != LIBUSB_ERROR_PIPE)
            return status;
    }
    return LIBUSB_SUCCESS;
}

}  // namespace

Result<std::unique_ptr<Transport>> openUsbCdc(std::shared_ptr<UsbBus> bus, const UsbDevice& device, const Clock& clock)
{
    auto pipe = UsbPipe::open(std::move(bus), device, clock, &setUpLine);
    if (!pipe)
        return tl::unexpected<Error>(pipe.error());
    return std::move(*pipe);
}

}  // namespace planewright
