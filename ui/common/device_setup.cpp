// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/common/device_setup.h"

#include <array>

#include "core/formats/number_text.h"

namespace planewright {

namespace {

struct Limit {
    const char* key;
    double DeviceSetup::*value;
};
constexpr std::array<Limit, 3> kLimits{
    {{"lowest=", &DeviceSetup::lowest}, {"highest=", &DeviceSetup::highest}, {"fastest=", &DeviceSetup::fastest}}};

}  // namespace

std::string tiltUnitAddress(const DeviceSetup& setup)
{
    std::string address = setup.tiltUnit;
    for (const Limit& limit : kLimits) {
        const double value = setup.*limit.value;
        const std::size_t options = address.rfind('?');
        const bool hasOptions = options != std::string::npos;
        const bool saysItself = hasOptions && address.find(limit.key, options) != std::string::npos;
        if (value == DeviceSetup{}.*limit.value || saysItself)
            continue;
        if (!hasOptions)
            address += '?';
        else if (address.back() != '?')
            address += '&';
        address += limit.key + exactNumber(value);
    }
    return address;
}

}  // namespace planewright
