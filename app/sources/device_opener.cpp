// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/sources/device_opener.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
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

constexpr int kMostDialogues = 9999;

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

std::string listOf(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
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

TiltMounting mountingOf(const DeviceAddress& address)
{
    TiltMounting mounting;
    mounting.zeroPitch = address.zeroPitch.value_or(degrees(90.0));
    mounting.sign = address.sign;
    mounting.scale = address.scale;
    mounting.lowest = address.lowest.value_or(kLowestPitch);
    mounting.highest = address.highest.value_or(kHighestPitch);
    mounting.fastest = address.fastest.value_or(kFastestTilt);
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

Result<std::vector<UsbDevice>> DeviceOpener::usbDevices()
{
    const auto usb = bus();
    if (!usb)
        return tl::unexpected{usb.error()};
    return (*usb)->devices();
}

Result<std::unique_ptr<Laser>> DeviceOpener::openLaser(const DeviceAddress& address, const std::stop_token& stop)
{
    if (address.unit != DeviceAddress::Unit::Laser)
        return fail(ErrorCode::Usage, "this is the address of a " + nameOf(address.unit) + ", not of a laser");
    if (address.link == DeviceAddress::Link::Usb)
        return openUsbLaser(address, stop);
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

/// The lasers that an address may mean, the likeliest first: the one where it was plugged in the last time.
Result<std::vector<UsbDevice>> DeviceOpener::lasersOf(const DeviceAddress& address)
{
    const auto devices = usbDevices();
    if (!devices)
        return tl::unexpected{devices.error()};
    std::vector<UsbDevice> lasers = usbDevicesOf(address, *devices);
    if (lasers.empty() && address.name.empty() && !address.usbPort.empty())
        return fail(ErrorCode::NoDevice,
                    "no laser is plugged in at usb " + address.usbPort +
                        "; plug it in there, or choose another (planewright-cli devices lists them)");
    if (lasers.empty())
        return fail(ErrorCode::NoDevice, "no laser is connected by USB; plug it in, and switch its supply on");
    if (address.name.empty() && lasers.size() > 1)
        return fail(ErrorCode::NoDevice, std::to_string(lasers.size()) +
                                             " lasers are connected by USB; name one, as in usb:NUMBER "
                                             "(planewright-cli devices lists them)");
    std::string last = address.usbPort;
    {
        const std::scoped_lock lock{mutex_};
        if (const auto known = lastPorts_.find(address.name); known != lastPorts_.end())
            last = known->second;
    }
    std::stable_partition(lasers.begin(), lasers.end(), [&](const UsbDevice& device) { return device.port == last; });
    return lasers;
}

/// USB has no names for lasers: each is asked. Of those that cannot be asked the reason is kept, since the one that is
/// looked for may be among them.
Result<std::unique_ptr<Laser>> DeviceOpener::openUsbLaser(const DeviceAddress& address, const std::stop_token& stop)
{
    const auto lasers = lasersOf(address);
    if (!lasers)
        return tl::unexpected{lasers.error()};
    std::vector<std::string> others;
    std::string troubles;
    for (const UsbDevice& device : *lasers) {
        Result<std::unique_ptr<Laser>> laser = openLaserOn(device, stop);
        if (!laser && (address.name.empty() || laser.error().code == ErrorCode::Interrupted))
            return laser;
        if (!laser) {
            troubles += "; " + laser.error().message;
            continue;
        }
        const std::string& serial = (*laser)->identity().serial;
        if (address.name.empty() || serial == address.name) {
            const std::scoped_lock lock{mutex_};
            lastPorts_[serial] = device.port;
            return laser;
        }
        others.push_back(serial);
    }
    return fail(ErrorCode::NoDevice,
                "no laser of number " + address.name + " is connected by USB; there are: " + listOf(others) + troubles);
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
            return openTcp(address, stop);
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

/// Where something has answered before, it is not another program that keeps the port.
Result<std::unique_ptr<Transport>> DeviceOpener::openTcp(const DeviceAddress& address, const std::stop_token& stop)
{
    const std::pair place{address.name, address.port};
    const auto wasThere = [&] {
        const std::scoped_lock lock{mutex_};
        return answered_.contains(place);
    };
    auto link = openTcpLink(address.name, address.port, clock_, clock_.now() + kConnectTimeout, stop, wasThere());
    if (link) {
        const std::scoped_lock lock{mutex_};
        answered_.insert(place);
    }
    return link;
}

Result<UsbDevice> DeviceOpener::findUsb(const DeviceAddress& address)
{
    const std::string kind = nameOf(address.unit);
    const auto devices = usbDevices();
    if (!devices)
        return tl::unexpected{devices.error()};
    DeviceAddress any = address;
    any.name.clear();
    any.usbPort.clear();
    const std::vector<UsbDevice> there = usbDevicesOf(any, *devices);
    const std::vector<UsbDevice> meant = usbDevicesOf(address, *devices);
    if (there.empty())
        return fail(ErrorCode::NoDevice, "no " + kind + " is connected by USB; plug it in");
    if (meant.empty())
        return fail(ErrorCode::NoDevice, "no " + kind +
                                             (address.name.empty() ? std::string{} : " of number " + address.name) +
                                             (address.usbPort.empty() ? "" : " at usb " + address.usbPort) +
                                             " is connected; there are: " + listOf(usbNamesOf(there)));
    if (meant.size() > 1)
        return fail(ErrorCode::NoDevice, "several are connected by USB that could be this " + kind +
                                             "; name one behind usb:, of these: " + listOf(usbNamesOf(meant)));
    return meant.front();
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
    std::error_code unused;
    std::filesystem::create_directories(options_.dialogueFolder, unused);  // what is wrong shows below
    const std::scoped_lock lock{mutex_};
    for (int number = 1; number <= kMostDialogues; ++number) {
        const std::string path = options_.dialogueFolder + "/" + device + "-" + std::to_string(number) + ".dialogue";
        if (std::filesystem::exists(path, unused))
            continue;
        auto writer = DialogueWriter::create(
            path, link->name(),
            [log = log_, &clock = clock_](const std::string& text) { log->add(clock.now(), "dialogue-ended", text); });
        if (!writer)
            return tl::unexpected{writer.error()};
        return std::make_unique<DialogueRecorder>(std::move(link), std::move(*writer), clock_);
    }
    return fail(ErrorCode::NotWritten, options_.dialogueFolder + ": is full of dialogues; give another folder");
}

}  // namespace planewright
