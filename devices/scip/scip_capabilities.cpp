// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_capabilities.h"

#include <array>
#include <charconv>
#include <string_view>

#include "core/types/angle.h"
#include "devices/scip/scip_status.h"

namespace planewright {

namespace {

using Version = std::array<int, 3>;

/// The numbers of "1.16.02(19/Jan./2010)" or "P.1.05(17/Apr./2009)"; those that are not there are 0.
Version firmwareVersion(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_of("0123456789"), text.size()));
    Version version{};
    for (int& part : version) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), part);
        if (error != std::errc{})
            break;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (!text.starts_with('.'))
            break;
        text.remove_prefix(1);
    }
    return version;
}

/// The clock of this firmware is wrong in time mode: drivers take its scans by their arrival.
constexpr Version kWrongClock{1, 16, 2};
/// This one survives twice the angle that the others of its time do.
constexpr Version kHalfCured{1, 16, 1};
constexpr Version kCured{1, 17, 0};

}  // namespace

ScipCapabilities scipCapabilities(const LaserIdentity& identity)
{
    const auto isA = [&](std::string_view name) {
        return identity.product.find(name) != std::string::npos || identity.model.find(name) != std::string::npos;
    };
    const bool isNew = scipVersionOf(identity.protocol) == ScipVersion::V2_2 || isA("UST-") || isA("UTM-30LX-EW");
    const bool isFirstUtm = isA("UTM-30LX") && !isNew;
    const bool isShortRange = isA("04LX");
    const Version firmware = firmwareVersion(identity.firmware);

    ScipCapabilities able;
    if (isFirstUtm && firmware < kCured)
        able.widestIntensity = degrees(firmware == kHalfCured ? 190.0 : 95.0);
    able.timeMode = identity.protocol.find("SCIP") != std::string::npos && !(isFirstUtm && firmware == kWrongClock);
    able.lineSpeed = isShortRange && !isA("UG01");
    able.motorSpeed = isShortRange;
    able.reboot = isNew;
    able.multiEcho = isNew || isA("UXM-");
    return able;
}

}  // namespace planewright
