// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/board/board_message.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace planewright::board {

namespace {

/// The number that a field is on the wire, as an unsigned one of its width.
template <class T>
constexpr auto toWire(T value)
{
    if constexpr (std::is_enum_v<T>)
        return static_cast<std::make_unsigned_t<std::underlying_type_t<T>>>(value);
    else
        return static_cast<std::make_unsigned_t<T>>(value);
}

struct Writer {
    std::vector<std::uint8_t>& bytes;

    template <class T>
    void operator()(std::string_view /*name*/, T value)
    {
        const std::uint64_t number = toWire(value);
        for (std::size_t byte = 0; byte < sizeof(T); ++byte)
            bytes.push_back(static_cast<std::uint8_t>((number >> (8 * byte)) & 0xFF));
    }
    template <std::size_t N>
    void operator()(std::string_view /*name*/, const std::array<std::uint8_t, N>& value)
    {
        bytes.insert(bytes.end(), value.begin(), value.end());
    }
};

/// Reads what has been found to be long enough.
struct Reader {
    std::span<const std::uint8_t> bytes;

    template <class T>
    void operator()(std::string_view /*name*/, T& value)
    {
        std::uint64_t number = 0;
        for (std::size_t byte = 0; byte < sizeof(T); ++byte)
            number |= static_cast<std::uint64_t>(bytes[byte]) << (8 * byte);
        value = static_cast<T>(static_cast<decltype(toWire(value))>(number));
        bytes = bytes.subspan(sizeof(T));
    }
    template <std::size_t N>
    void operator()(std::string_view /*name*/, std::array<std::uint8_t, N>& value)
    {
        std::copy_n(bytes.begin(), N, value.begin());
        bytes = bytes.subspan(N);
    }
};

struct Measurer {
    std::size_t length = 0;

    template <class T>
    void operator()(std::string_view /*name*/, const T& /*value*/)
    {
        length += sizeof(T);
    }
};

struct Printer {
    std::string& text;

    template <class T>
    void operator()(std::string_view name, T value)
    {
        begin(name);
        if constexpr (std::is_enum_v<T>)
            text += std::to_string(toWire(value));
        else
            text += std::to_string(value);
    }
    template <std::size_t N>
    void operator()(std::string_view name, const std::array<std::uint8_t, N>& value)
    {
        begin(name);
        for (const char digit : toHex(value)) {
            if (digit != ' ')
                text += digit;
        }
    }
    void begin(std::string_view name)
    {
        text += ' ';
        text += name;
        text += '=';
    }
};

template <class T>
std::size_t lengthOf()
{
    Measurer measurer;
    const T message{};
    T::fields(message, measurer);
    return measurer.length;
}

/// Calls `found` with a message of the type that has this number; false where there is none.
template <class Found>
bool withMessageOf(std::uint8_t type, Found&& found)
{
    return [&]<std::size_t... I>(std::index_sequence<I...>)
    {
        const auto tryOne = [&]<class T>(T message) {
            if (T::kType != type)
                return false;
            found(std::move(message));
            return true;
        };
        return (tryOne(std::variant_alternative_t<I, Message>{}) || ...);
    }
    (std::make_index_sequence<std::variant_size_v<Message>>{});
}

std::string fourDigits(std::uint16_t number)
{
    const std::array<std::uint8_t, 2> bytes{static_cast<std::uint8_t>(number >> 8),
                                            static_cast<std::uint8_t>(number & 0xFF)};
    std::string text = toHex(bytes);
    text.erase(2, 1);
    return text;
}

}  // namespace

Frame toFrame(std::uint16_t seq, const Message& message)
{
    Frame frame;
    frame.seq = seq;
    std::visit(
        [&frame]<class T>(const T& known) {
            frame.type = T::kType;
            T::fields(known, Writer{frame.payload});
        },
        message);
    assert(frame.payload.size() <= kMaxPayload);
    return frame;
}

tl::expected<Message, NakCode> toMessage(const Frame& frame)
{
    tl::expected<Message, NakCode> result = tl::unexpected(NakCode::UnknownType);
    withMessageOf(frame.type, [&]<class T>(T message) {
        if (frame.payload.size() != lengthOf<T>()) {
            result = tl::unexpected(NakCode::Length);
            return;
        }
        T::fields(message, Reader{frame.payload});
        result = message;
    });
    return result;
}

std::optional<std::size_t> payloadLength(std::uint8_t type)
{
    std::optional<std::size_t> length;
    withMessageOf(type, [&]<class T>(const T&) { length = lengthOf<T>(); });
    return length;
}

std::string toText(const Frame& frame)
{
    const std::string seq = " seq=" + fourDigits(frame.seq);
    const auto message = toMessage(frame);
    if (!message)
        return "type=" + std::to_string(frame.type) + seq + " payload=" + toHex(frame.payload);
    return std::visit(
        [&]<class T>(const T& known) {
            std::string text = std::string{T::kName} + seq;
            T::fields(known, Printer{text});
            return text;
        },
        *message);
}

}  // namespace planewright::board
