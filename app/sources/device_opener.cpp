// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/device_opener.h"

#include <algorithm>
#include <utility>

#include "core/types/angle.h"
#include "devices/board/board_speech.h"
#include "devices/board/board_tilt.h"
#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/dynamixel/servo_speech.h"
#include "devices/scip/scip_laser.h"
#include "devices/transport/dialogue_recorder.h"
#include "devices/transport/replayed_dialogue.h"
#include "devices/transport/replayed_talk.h"
#include "devices/transport/serial_line.h"
#include "devices/transport/tcp_link.h"
#include "devices/transport/usb_cdc.h"
#include "devices/transport/usb_ftdi.h"

namespace planewright {

namespace {

constexpr std::uint16_t kHokuyo = 0x15d1;

/// A laser is asked the same at each start, to the byte; of the others the meaning counts.
Result<std::unique_ptr<Transport>> playDialogue(const DeviceAddress& address, ReplayedDialogue::Pace pace,
                                                const Clock& clock)
{
    const auto asTransport = [](auto dialogue) { return std::unique_ptr<Transport>(std::move(dialogue)); };
    switch (address.unit) {
        case DeviceAddress::Unit::Dynamixel:
            return ReplayedTalk::open(address.name, pace, std::make_unique<ServoSpeech>(), clock).map(asTransport);
        case DeviceAddress::Unit::Board:
            return ReplayedTalk::open(address.name, pace, std::make_unique<BoardSpeech>(), clock).map(asTransport);
        case DeviceAddress::Unit::Laser:
            break;
    }
    return ReplayedDialogue::open(address.name, pace, clock).map(asTransport);
}

/// What people call a kind of device.
std::string nameOf(DeviceAddress::Unit unit)
{
    switch (unit) {
        case DeviceAddress::Unit::Laser:
            return "laser";
        case DeviceAddress::Unit::Dynamixel:
            return "servo adapter";
        case DeviceAddress::Unit::Board:
            break;
    }
    return "control board";
}

bool isOfUnit(const UsbDevice& device, DeviceAddress::Unit unit)
{
    switch (unit) {
        case DeviceAddress::Unit::Laser:
            return isUsbLaser(device);
        case DeviceAddress::Unit::Dynamixel:
            return device.kind == UsbKind::Ftdi;
        case DeviceAddress::Unit::Board:
            break;
    }
    return device.kind == UsbKind::CdcAcm && !isUsbLaser(device);
}

/// "00903971, 00903972", or "none".
std::string listOf(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + (name.empty() ? "one without a number" : name);
    return text.empty() ? "none" : text;
}

template <class Driver, class Base>
Result<std::unique_ptr<Base>> connected(std::unique_ptr<Driver> driver, const std::stop_token& stop)
{
    if (const Result<void> done = driver->connect(stop); !done)
        return tl::unexpected{done.error()};
    return std::unique_ptr<Base>(std::move(driver));
}

}  // namespace

bool isUsbLaser(const UsbDevice& device)
{
    return device.kind == UsbKind::CdcAcm && device.vendor == kHokuyo;
}

TiltMounting mountingOf(const DeviceAddress& address)
{
    TiltMounting mounting;
    mounting.zeroPitch = address.zeroPitch.value_or(degrees(90.0));
    mounting.sign = address.sign;
    mounting.scale = address.scale;
    mounting.lowest = degrees(0.0);
    mounting.highest = degrees(180.0);
    mounting.fastest = degrees(120.0);
    return mounting;
}

DeviceOpener::DeviceOpener(const Clock& clock, DeviceOptions options) : clock_(clock), options_(std::move(options)) {}

void DeviceOpener::onUsbChange(std::function<void()> changed)
{
    const std::scoped_lock lock{mutex_};
    changed_ = std::move(changed);
}

Result<std::shared_ptr<UsbBus>> DeviceOpener::bus()
{
    const std::scoped_lock lock{mutex_};
    if (bus_)
        return bus_;
    Result<std::shared_ptr<UsbBus>> started = UsbBus::start(clock_, changed_);
    if (started)
        bus_ = *started;
    return started;
}

std::vector<UsbDevice> DeviceOpener::usbDevices()
{
    const auto usb = bus();
    return usb ? (*usb)->devices() : std::vector<UsbDevice>{};
}

Result<std::unique_ptr<Laser>> DeviceOpener::openLaser(const DeviceAddress& address, const std::stop_token& stop)
{
    if (address.unit != DeviceAddress::Unit::Laser)
        return fail(ErrorCode::Usage, "this is the address of a " + nameOf(address.unit) + ", not of a laser");
    if (address.link == DeviceAddress::Link::Usb)
        return openUsbLaser(address.name, stop);
    Result<std::unique_ptr<Transport>> link = openLink(address, stop);
    if (!link)
        return tl::unexpected{link.error()};
    return connectLaser(std::move(*link), stop);
}

Result<std::unique_ptr<Laser>> DeviceOpener::connectLaser(std::unique_ptr<Transport> link, const std::stop_token& stop)
{
    Result<std::unique_ptr<Transport>> line = recorded(std::move(link), "laser");
    if (!line)
        return tl::unexpected{line.error()};
    return connected<ScipLaser, Laser>(std::make_unique<ScipLaser>(std::move(*line), clock_, options_.progress), stop);
}

Result<std::unique_ptr<Laser>> DeviceOpener::openLaserOn(const UsbDevice& device, const std::stop_token& stop)
{
    const auto usb = bus();
    if (!usb)
        return tl::unexpected{usb.error()};
    Result<std::unique_ptr<Transport>> link = openUsbCdc(*usb, device, clock_);
    if (!link)
        return tl::unexpected{link.error()};
    return connectLaser(std::move(*link), stop);
}

/// USB has no names for lasers: each is asked. Of those that cannot be asked the reason is kept, since the one that is
/// looked for may be among them.
Result<std::unique_ptr<Laser>> DeviceOpener::openUsbLaser(const std::string& serial, const std::stop_token& stop)
{
    std::vector<UsbDevice> lasers = usbDevices();
    std::erase_if(lasers, [](const UsbDevice& device) { return !isUsbLaser(device); });
    if (lasers.empty())
        return fail(ErrorCode::NoDevice, "no laser is connected by USB; plug it in, and switch its supply on");
    if (serial.empty() && lasers.size() > 1)
        return fail(ErrorCode::NoDevice, std::to_string(lasers.size()) +
                                             " lasers are connected by USB; name one, as in "
                                             "usb:NUMBER (planewright-cli devices lists them)");
    std::vector<std::string> others;
    std::string troubles;
    for (const UsbDevice& device : lasers) {
        Result<std::unique_ptr<Laser>> laser = openLaserOn(device, stop);
        if (!laser && (serial.empty() || laser.error().code == ErrorCode::Interrupted))
            return laser;
        if (!laser) {
            troubles += "; " + laser.error().message;
            continue;
        }
        if (serial.empty() || (*laser)->identity().serial == serial)
            return laser;
        others.push_back((*laser)->identity().serial);
    }
    return fail(ErrorCode::NoDevice,
                "no laser of number " + serial + " is connected by USB; there are: " + listOf(others) + troubles);
}

Result<std::unique_ptr<TiltUnit>> DeviceOpener::openTiltUnit(const DeviceAddress& address, const std::stop_token& stop)
{
    if (address.unit == DeviceAddress::Unit::Laser)
        return fail(ErrorCode::Usage, "this is the address of a laser; a tilt unit's begins with dynamixel: or board:");
    Result<std::unique_ptr<Transport>> link = openLink(address, stop);
    if (link)
        link = recorded(std::move(*link), "tilt");
    if (!link)
        return tl::unexpected{link.error()};
    if (address.unit == DeviceAddress::Unit::Board) {
        BoardTiltOptions options;
        options.mounting = mountingOf(address);
        return connected<BoardTilt, TiltUnit>(std::make_unique<BoardTilt>(std::move(*link), clock_, options), stop);
    }
    DynamixelOptions options;
    options.mounting = mountingOf(address);
    options.id = static_cast<std::uint8_t>(address.id);
    options.baud = address.baud;
    options.dropEcho = address.hasEcho;
    return connected<DynamixelTilt, TiltUnit>(std::make_unique<DynamixelTilt>(std::move(*link), clock_, options), stop);
}

Result<std::unique_ptr<Transport>> DeviceOpener::openLink(const DeviceAddress& address, const std::stop_token& stop)
{
    switch (address.link) {
        case DeviceAddress::Link::Tcp:
            return openTcpLink(address.name, address.port, clock_, clock_.now() + kConnectTimeout, stop);
        case DeviceAddress::Link::Serial:
            return openSerialLine(address.name, address.baud, clock_);
        case DeviceAddress::Link::Dialogue: {
            const auto pace =
                address.isInTime ? ReplayedDialogue::Pace::Recorded : ReplayedDialogue::Pace::AsFastAsPossible;
            return playDialogue(address, pace, clock_);
        }
        case DeviceAddress::Link::Usb:
            break;
    }
    return openUsb(address);
}

Result<UsbDevice> DeviceOpener::findUsb(const DeviceAddress& address)
{
    const std::string kind = nameOf(address.unit);
    std::vector<UsbDevice> devices = usbDevices();
    std::erase_if(devices, [&](const UsbDevice& device) { return !isOfUnit(device, address.unit); });
    if (devices.empty())
        return fail(ErrorCode::NoDevice, "no " + kind + " is connected by USB; plug it in");
    std::vector<std::string> serials;
    for (const UsbDevice& device : devices)
        serials.push_back(device.serial);
    if (!address.name.empty())
        std::erase_if(devices, [&](const UsbDevice& device) { return device.serial != address.name; });
    if (devices.empty())
        return fail(ErrorCode::NoDevice, "no " + kind + " of number " + address.name +
                                             " is connected by USB; there are: " + listOf(serials));
    if (devices.size() > 1)
        return fail(ErrorCode::NoDevice, "several are connected by USB that could be this " + kind +
                                             "; name one by its number: " + listOf(serials));
    return devices.front();
}

Result<std::unique_ptr<Transport>> DeviceOpener::openUsb(const DeviceAddress& address)
{
    const auto device = findUsb(address);
    if (!device)
        return tl::unexpected{device.error()};
    const auto usb = bus();
    if (!usb)
        return tl::unexpected{usb.error()};
    if (device->kind == UsbKind::CdcAcm)
        return openUsbCdc(*usb, *device, clock_);
    auto adapter = UsbFtdi::open(*usb, *device, address.baud, clock_);
    if (!adapter)
        return tl::unexpected{adapter.error()};
    return std::unique_ptr<Transport>(std::move(*adapter));
}

Result<std::unique_ptr<Transport>> DeviceOpener::recorded(std::unique_ptr<Transport> link, const std::string& device)
{
    if (options_.dialogueFolder.empty())
        return link;
    int number = 0;
    {
        const std::scoped_lock lock{mutex_};
        number = ++dialogues_;
    }
    const std::string path = options_.dialogueFolder + "/" + device + "-" + std::to_string(number) + ".dialogue";
    auto writer = DialogueWriter::create(path, link->name());
    if (!writer)
        return tl::unexpected{writer.error()};
    return std::make_unique<DialogueRecorder>(std::move(link), std::move(*writer), clock_);
}

}  // namespace planewright
