// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "core/simulation/random.h"
#include "devices/board/board_frame.h"
#include "devices/board/board_message.h"
#include "devices/clock.h"
#include "devices/transport/transport.h"

namespace planewright {

/// What goes wrong on a cable, from one moment to another.
struct LinkFault {
    enum class Kind { Unplug, Garbage, Delay, Loss, Duplicates, WrongAngle };
    Kind kind = Kind::Garbage;
    std::chrono::nanoseconds from{0};
    std::chrono::nanoseconds to{0};
    double rate = 0.0;                  ///< of bytes lost, doubled or joined by random ones
    std::chrono::nanoseconds delay{0};  ///< of what comes from the device
    int counts = 0;                     ///< that angles are too high by
};

/// The answers of a Dynamixel servo (protocol 1.0) to reads of its state, from address 36 on, with other positions.
inline std::vector<std::uint8_t> withOtherServoPositions(std::vector<std::uint8_t> bytes, int counts)
{
    constexpr std::size_t kHead = 4;      // FF FF number length
    constexpr std::uint8_t kLength = 13;  // error, 11 bytes, checksum
    for (std::size_t i = 0; i + kHead + kLength <= bytes.size(); ++i) {
        std::uint8_t* const packet = bytes.data() + i;
        if (packet[0] != 0xFF || packet[1] != 0xFF || packet[2] == 0xFF || packet[3] != kLength)
            continue;
        const int position = std::clamp(packet[5] + 256 * packet[6] + counts, 0, 1023);
        packet[5] = static_cast<std::uint8_t>(position % 256);
        packet[6] = static_cast<std::uint8_t>(position / 256);
        unsigned sum = 0;
        for (std::size_t k = 2; k + 1 < kHead + kLength; ++k)
            sum += packet[k];
        packet[kHead + kLength - 1] = static_cast<std::uint8_t>(~sum);
    }
    return bytes;
}

/// The POSITION events of a control board with other positions; what is no whole frame stays as it is.
inline std::vector<std::uint8_t> withOtherBoardPositions(const std::vector<std::uint8_t>& bytes, int counts)
{
    std::vector<std::uint8_t> changed;
    for (auto from = bytes.begin(); from != bytes.end();) {
        const auto zero = std::find(from, bytes.end(), std::uint8_t{0});
        const auto end = zero == bytes.end() ? zero : std::next(zero);
        const std::vector<std::uint8_t> stuffed(from, zero);
        auto frame = zero == bytes.end() ? tl::unexpected{board::Damage::Length} : board::decodeFrame(stuffed);
        if (frame && frame->type == board::PositionEvent::kType) {
            auto event = std::get<board::PositionEvent>(*board::toMessage(*frame));
            event.pos = static_cast<std::uint16_t>(std::clamp(event.pos + counts, 0, 1023));
            const auto other = board::encodeFrame(board::toFrame(frame->seq, event));
            changed.insert(changed.end(), other.begin(), other.end());
        } else {
            changed.insert(changed.end(), from, end);
        }
        from = end;
    }
    return changed;
}

/// A link with a fault on its cable. All links of a device share the fault and the draws.
class FaultyLink : public Transport {
public:
    FaultyLink(std::unique_ptr<Transport> link, const LinkFault& fault, std::shared_ptr<Random> random,
               const Clock& clock)
        : link_(std::move(link)), fault_(fault), random_(std::move(random)), clock_(clock)
    {
    }

    std::string name() const override { return link_->name(); }

    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override
    {
        for (;;) {
            if (isUnplugged())
                return gone();
            if (!waiting_.empty() && waiting_.front().at <= clock_.now())
                return give(into);
            const auto until = waiting_.empty() ? deadline : std::min(deadline, waiting_.front().at);
            std::vector<std::uint8_t> raw(into.size());
            const Result<Arrival> arrival = link_->read(raw, until, stop);
            if (!arrival)
                return arrival;
            raw.resize(arrival->count);
            take(raw, arrival->at);
            if (arrival->count == 0 && (until == deadline || stop.stop_requested()))
                return *arrival;
        }
    }

    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override
    {
        if (isUnplugged())
            return gone();
        std::vector<std::uint8_t> changed;
        for (const std::uint8_t byte : bytes)
            change(byte, clock_.now(), changed);
        return link_->write(changed, deadline);
    }

    void close() override { link_->close(); }

private:
    struct Chunk {
        std::chrono::nanoseconds at;
        std::vector<std::uint8_t> bytes;
    };

    bool isOn(std::chrono::nanoseconds at) const { return at >= fault_.from && at < fault_.to; }

    /// A link that was pulled out once stays so: a new one has to be opened.
    bool isUnplugged()
    {
        wasUnplugged_ = wasUnplugged_ || (fault_.kind == LinkFault::Kind::Unplug && isOn(clock_.now()));
        return wasUnplugged_;
    }

    static tl::unexpected<Error> gone() { return fail(ErrorCode::DeviceLost, "the cable is pulled out"); }

    void change(std::uint8_t byte, std::chrono::nanoseconds at, std::vector<std::uint8_t>& out)
    {
        const bool isOfBytes = fault_.kind == LinkFault::Kind::Garbage || fault_.kind == LinkFault::Kind::Loss ||
                               fault_.kind == LinkFault::Kind::Duplicates;
        if (!isOfBytes || !isOn(at) || random_->uniform() >= fault_.rate) {
            out.push_back(byte);
            return;
        }
        if (fault_.kind == LinkFault::Kind::Garbage)
            out.insert(out.end(), {static_cast<std::uint8_t>(random_->integer(0, 255)), byte});
        if (fault_.kind == LinkFault::Kind::Duplicates)
            out.insert(out.end(), {byte, byte});
    }

    void take(const std::vector<std::uint8_t>& raw, std::chrono::nanoseconds at)
    {
        Chunk chunk{at, {}};
        if (fault_.kind == LinkFault::Kind::WrongAngle && isOn(at)) {
            chunk.bytes = withOtherServoPositions(raw, fault_.counts);
            chunk.bytes = withOtherBoardPositions(chunk.bytes, fault_.counts);
        } else {
            for (const std::uint8_t byte : raw)
                change(byte, at, chunk.bytes);
        }
        if (fault_.kind == LinkFault::Kind::Delay && isOn(at))
            chunk.at += fault_.delay;
        if (!waiting_.empty())
            chunk.at = std::max(chunk.at, waiting_.back().at);  // a line keeps its order
        if (!chunk.bytes.empty())
            waiting_.push_back(std::move(chunk));
    }

    Arrival give(std::span<std::uint8_t> into)
    {
        Chunk& first = waiting_.front();
        const Arrival arrival{std::min(into.size(), first.bytes.size()), first.at};
        const auto end = first.bytes.begin() + static_cast<std::ptrdiff_t>(arrival.count);
        std::copy(first.bytes.begin(), end, into.begin());
        first.bytes.erase(first.bytes.begin(), end);
        if (first.bytes.empty())
            waiting_.pop_front();
        return arrival;
    }

    std::unique_ptr<Transport> link_;
    LinkFault fault_;
    std::shared_ptr<Random> random_;
    const Clock& clock_;
    std::deque<Chunk> waiting_;
    bool wasUnplugged_ = false;
};

}  // namespace planewright
