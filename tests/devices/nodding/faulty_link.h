// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "core/simulation/random.h"
#include "devices/clock.h"
#include "devices/transport/transport.h"

namespace planewright {

/// What goes wrong on a cable, from one moment to another.
struct LinkFault {
    enum class Kind { Unplug, Garbage, Delay, Loss, Duplicates };
    Kind kind = Kind::Garbage;
    std::chrono::nanoseconds from{0};
    std::chrono::nanoseconds to{0};
    double rate = 0.0;                  ///< of bytes lost, doubled or joined by random ones
    std::chrono::nanoseconds delay{0};  ///< of what comes from the device
};

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
        if (!isOn(at) || random_->uniform() >= fault_.rate) {
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
        for (const std::uint8_t byte : raw)
            change(byte, at, chunk.bytes);
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
