// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/device_address.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/types/angle.h"
#include "devices/address_text.h"

namespace planewright {

namespace {

using Unit = DeviceAddress::Unit;
using Link = DeviceAddress::Link;

struct UnitWord {
    std::string_view word;
    Unit unit;
};
constexpr std::array<UnitWord, 2> kUnits{{{"dynamixel:", Unit::Dynamixel}, {"board:", Unit::Board}}};

struct LinkWord {
    std::string_view word;
    Link link;
};
constexpr std::array<LinkWord, 4> kLinks{
    {{"usb:", Link::Usb}, {"tcp:", Link::Tcp}, {"serial:", Link::Serial}, {"dialogue:", Link::Dialogue}}};

constexpr int kServoBaud = 57142;
constexpr int kSlowestBaud = 300;
constexpr int kFastestBaud = 4500000;
constexpr int kHighestId = 253;
constexpr double kMostAngle = 360.0;  // [degrees]
constexpr double kLeastSpeed = 1.0;   // [degrees/s]
constexpr double kMostSpeed = 720.0;  // [degrees/s]
constexpr double kLeastScale = 0.01;
constexpr double kMostScale = 100.0;

/// Takes the word that a text begins with off it; gives its row of a table, or null.
template <class Words>
const typename Words::value_type* takeWord(std::string_view& text, const Words& words)
{
    const auto found =
        std::find_if(words.begin(), words.end(), [&](const auto& w) { return text.starts_with(w.word); });
    if (found == words.end())
        return nullptr;
    text.remove_prefix(found->word.size());
    return &*found;
}

std::vector<std::string_view> knownKeys(const DeviceAddress& address)
{
    std::vector<std::string_view> keys;
    if (address.unit == Unit::Dynamixel)
        keys.insert(keys.end(), {"id", "echo"});
    // A servo is asked again where its answer is late, and how long an answer takes is a matter of its speed.
    if (address.link == Link::Serial || address.unit == Unit::Dynamixel)
        keys.emplace_back("baud");
    if (address.unit != Unit::Laser)
        keys.insert(keys.end(), {"zero", "sign", "scale", "lowest", "highest", "fastest"});
    if (address.link == Link::Dialogue)
        keys.emplace_back("speed");
    return keys;
}

std::string unknownKey(std::string_view key, const std::vector<std::string_view>& known)
{
    std::string text = "there is no option '" + std::string{key} + "'; ";
    if (known.empty())
        return text + "such an address has none";
    for (std::size_t i = 0; i < known.size(); ++i)
        text += (i == 0 ? "known: " : ", ") + std::string{known[i]};
    return text;
}

template <class Number>
bool readsWithin(std::string_view text, Number lowest, Number highest, Number& number)
{
    return readsNumber(text, number) && number >= lowest && number <= highest;
}

/// An angle of an option, given in degrees [rad]; empty where it is none.
std::optional<double> readAngle(std::string_view text)
{
    double angle = 0.0;
    return readsWithin(text, -kMostAngle, kMostAngle, angle) ? std::optional{degrees(angle)} : std::nullopt;
}

/// Sets what one option says; gives what is wrong with its value, or nothing.
std::string takeValue(std::string_view key, std::string_view value, DeviceAddress& address)
{
    const std::string given = std::string{key} + " '" + std::string{value} + "' is not ";
    if (key == "id" && !readsWithin(value, 0, kHighestId, address.id))
        return given + "a whole number from 0 to " + std::to_string(kHighestId);
    if (key == "baud" && !readsWithin(value, kSlowestBaud, kFastestBaud, address.baud))
        return given + "a whole number of bit/s from " + std::to_string(kSlowestBaud) + " to " +
               std::to_string(kFastestBaud);
    if (key == "scale" && !readsWithin(value, kLeastScale, kMostScale, address.scale))
        return given + "a number from 0.01 to 100";
    if (key == "sign" && value != "+" && value != "-")
        return given + "+ or -";
    if (key == "echo" && value != "yes" && value != "no")
        return given + "yes, the adapter sends back what is sent to it, or no";
    if (key == "speed" && value != "0" && value != "1")
        return given + "0, as fast as possible, or 1, real time";
    if (key == "zero" || key == "lowest" || key == "highest") {
        std::optional<double>& angle = key == "zero"     ? address.zeroPitch
                                       : key == "lowest" ? address.lowest
                                                         : address.highest;
        angle = readAngle(value);
        if (!angle)
            return given + "a number of degrees from -360 to 360";
    } else if (key == "fastest") {
        double speed = 0.0;
        if (!readsWithin(value, kLeastSpeed, kMostSpeed, speed))
            return given + "a number of degrees a second from 1 to 720";
        address.fastest = degrees(speed);
    } else if (key == "sign") {
        address.sign = value == "+" ? 1.0 : -1.0;
    } else if (key == "echo") {
        address.hasEcho = value == "yes";
    } else if (key == "speed") {
        address.isInTime = value == "1";
    }
    return {};
}

/// True for "1-4.2": the bus, and the plugs from there on.
bool isUsbPort(std::string_view text)
{
    const std::size_t dash = text.find('-');
    if (dash == std::string_view::npos || dash == 0)
        return false;
    const auto areNumbers = [](std::string_view numbers) {
        return !numbers.empty() && numbers.front() != '.' && numbers.back() != '.' &&
               numbers.find("..") == std::string_view::npos &&
               numbers.find_first_not_of("0123456789.") == std::string_view::npos;
    };
    return text.substr(0, dash).find('.') == std::string_view::npos && areNumbers(text.substr(0, dash)) &&
           areNumbers(text.substr(dash + 1));
}

/// Takes "SERIAL@PORT" apart; a serial number may have an '@' of its own.
std::string takeUsbName(std::string_view name, DeviceAddress& address)
{
    const std::size_t at = name.rfind('@');
    if (at != std::string_view::npos && isUsbPort(name.substr(at + 1))) {
        address.usbPort = name.substr(at + 1);
        name = name.substr(0, at);
    } else if (at == 0) {
        return "'" + std::string{name.substr(1)} +
               "' is no place where something is plugged in; give usb:@1-4 or, "
               "behind a hub, usb:@1-4.2";
    }
    address.name = name;
    return {};
}

/// Reads what stands between the link's word and the options; gives what is wrong with it, or nothing.
std::string takeName(std::string_view name, DeviceAddress& address)
{
    if (address.link == Link::Tcp)
        return readHostAndPort(name, 1, address.name, address.port);
    if (address.link == Link::Usb)
        return takeUsbName(name, address);
    address.name = name;
    if (address.name.empty() && address.link == Link::Serial)
        return "give a port, as in serial:/dev/ttyUSB0";
    if (address.name.empty() && address.link == Link::Dialogue)
        return "give the name of a file";
    return {};
}

}  // namespace

bool isDeviceAddress(const std::string& text)
{
    std::string_view rest = text;
    return takeWord(rest, kUnits) != nullptr || takeWord(rest, kLinks) != nullptr;
}

Result<DeviceAddress> parseDeviceAddress(const std::string& text)
{
    const auto refuse = [&](const std::string& why) { return fail(ErrorCode::Usage, "'" + text + "': " + why); };
    DeviceAddress address;
    std::string_view rest = text;
    const UnitWord* unit = takeWord(rest, kUnits);
    if (unit != nullptr)
        address.unit = unit->unit;
    const LinkWord* link = takeWord(rest, kLinks);
    if (link == nullptr)
        return refuse("give usb:SERIAL, tcp:HOST:PORT, serial:PATH or dialogue:FILE" +
                      std::string{unit != nullptr ? " behind " + std::string{unit->word}
                                                  : ", and for a tilt unit dynamixel: or board: before it"});
    address.link = link->link;
    if (address.unit == Unit::Dynamixel)
        address.baud = kServoBaud;
    const std::string_view options = takeOptions(rest);
    const std::vector<std::string_view> known = knownKeys(address);
    const std::string problem = readOptions(options, [&](std::string_view key, std::string_view value) {
        return std::find(known.begin(), known.end(), key) == known.end() ? unknownKey(key, known)
                                                                         : takeValue(key, value, address);
    });
    if (!problem.empty())
        return refuse(problem);
    if (const std::string trouble = takeName(rest, address); !trouble.empty())
        return refuse(trouble);
    if (!(address.lowest.value_or(kLowestPitch) < address.highest.value_or(kHighestPitch)))
        return refuse("lowest is not below highest; the head could not move between them");
    return address;
}

}  // namespace planewright
