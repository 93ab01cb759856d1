// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_link.h"

#include <algorithm>
#include <utility>

namespace planewright {

EmulatedLink::EmulatedLink(std::shared_ptr<EmulatedDevice> device, std::shared_ptr<std::mutex> rig, const Clock& clock,
                           std::string name)
    : device_(std::move(device)), rig_(std::move(rig)), clock_(clock), name_(std::move(name))
{
}

Result<Transport::Arrival> EmulatedLink::read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                                              const std::stop_token& stop)
{
    std::unique_lock lock(*rig_);
    for (;;) {
        if (!isOpen_)
            return gone();
        const std::chrono::nanoseconds now = clock_.now();
        const bool isConnected = device_->isConnected(now);
        for (EmulatedOutput& output : device_->takeOutput(now)) {
            if (!output.bytes.empty())
                arrived_.push_back(std::move(output));
        }
        if (!arrived_.empty()) {
            EmulatedOutput& first = arrived_.front();
            const Arrival arrival{std::min(into.size(), first.bytes.size()), first.at};
            const auto end = first.bytes.begin() + static_cast<std::ptrdiff_t>(arrival.count);
            std::copy(first.bytes.begin(), end, into.begin());
            first.bytes.erase(first.bytes.begin(), end);
            if (first.bytes.empty())
                arrived_.pop_front();
            return arrival;
        }
        if (!isConnected)
            return gone();
        if (now >= deadline || stop.stop_requested())
            return Arrival{0, now};
        clock_.wait(lock, changed_, stop, std::min(deadline, device_->nextOutput().value_or(deadline)));
    }
}

Result<void> EmulatedLink::write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds /*deadline*/)
{
    const std::scoped_lock lock(*rig_);
    const std::chrono::nanoseconds now = clock_.now();
    if (!isOpen_ || !device_->isConnected(now))
        return gone();
    device_->receive(bytes, now);
    changed_.notify_all();
    return {};
}

void EmulatedLink::close()
{
    const std::scoped_lock lock(*rig_);
    isOpen_ = false;
    changed_.notify_all();
}

tl::unexpected<Error> EmulatedLink::gone() const
{
    return fail(ErrorCode::DeviceLost, name_ + ": the device is gone; plug it in again");
}

}  // namespace planewright
