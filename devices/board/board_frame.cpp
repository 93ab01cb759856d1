// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_frame.h"

#include <algorithm>
#include <cassert>

#include "devices/board/cobs.h"

namespace planewright::board {

namespace {

constexpr std::size_t kHeader = 5;
constexpr std::size_t kChecksum = 2;

std::uint16_t littleEndian(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return static_cast<std::uint16_t>(bytes[at] | (bytes[at + 1] << 8));
}

void append(std::vector<std::uint8_t>& bytes, std::uint16_t value)
{
    bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}

}  // namespace

std::vector<std::uint8_t> encodeFrame(const Frame& frame)
{
    assert(frame.payload.size() <= kMaxPayload);
    std::vector<std::uint8_t> raw{kVersion, static_cast<std::uint8_t>(frame.payload.size())};
    append(raw, frame.seq);
    raw.push_back(frame.type);
    raw.insert(raw.end(), frame.payload.begin(), frame.payload.end());
    append(raw, crc16(raw));

    std::vector<std::uint8_t> wire = encodeCobs(raw);
    wire.push_back(0);
    return wire;
}

tl::expected<Frame, Damage> decodeFrame(std::span<const std::uint8_t> bytes)
{
    if (bytes.size() > kMaxFrame)
        return tl::unexpected(Damage::Length);
    const auto raw = decodeCobs(bytes);
    if (!raw)
        return tl::unexpected(Damage::Cobs);
    if (raw->size() < kHeader + kChecksum || raw->size() != kHeader + (*raw)[1] + kChecksum || (*raw)[1] > kMaxPayload)
        return tl::unexpected(Damage::Length);
    const std::span<const std::uint8_t> content{raw->data(), raw->size() - kChecksum};
    if (crc16(content) != littleEndian(*raw, content.size()))
        return tl::unexpected(Damage::Crc);
    if (content[0] != kVersion)
        return tl::unexpected(Damage::Version);
    return Frame{littleEndian(content, 2), content[4], {content.begin() + kHeader, content.end()}};
}

std::uint16_t crc16(std::span<const std::uint8_t> bytes)
{
    unsigned crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
        crc ^= static_cast<unsigned>(byte) << 8;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc << 1) ^ ((crc & 0x8000) != 0 ? 0x1021U : 0U);
        crc &= 0xFFFF;
    }
    return static_cast<std::uint16_t>(crc);
}

std::string toHex(std::span<const std::uint8_t> bytes)
{
    constexpr char kDigits[] = "0123456789ABCDEF";
    std::string text;
    for (const std::uint8_t byte : bytes) {
        if (!text.empty())
            text += ' ';
        text += kDigits[byte >> 4];
        text += kDigits[byte & 0xF];
    }
    return text;
}

}  // namespace planewright::board
