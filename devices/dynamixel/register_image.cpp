// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/dynamixel/register_image.h"

#include <algorithm>

#include "devices/dynamixel/requests.h"

namespace planewright {

void RegisterImage::store(std::uint16_t first, std::span<const std::uint8_t> bytes)
{
    const std::size_t begin = std::min<std::size_t>(first, kBytes);
    const std::span<const std::uint8_t> fitting = bytes.first(std::min(bytes.size(), kBytes - begin));
    std::copy(fitting.begin(), fitting.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(begin));
}

std::span<const std::uint8_t> RegisterImage::bytes(std::uint16_t first, std::size_t count) const
{
    const std::size_t begin = std::min<std::size_t>(first, kBytes);
    return std::span{bytes_}.subspan(begin, std::min(count, kBytes - begin));
}

std::uint32_t RegisterImage::value(const ServoRegister& place) const
{
    return fromLittleEndian(bytes(place.address, place.size));
}

std::int32_t RegisterImage::signedValue(const ServoRegister& place) const
{
    const std::uint32_t value = this->value(place);
    if (place.size == 0 || place.size >= 4)
        return static_cast<std::int32_t>(value);
    const std::uint32_t sign = 1U << (8 * place.size - 1);
    return static_cast<std::int32_t>(value ^ sign) - static_cast<std::int32_t>(sign);
}

}  // namespace planewright
