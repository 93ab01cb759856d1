// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/byte_queue.h"

#include <algorithm>
#include <utility>

namespace planewright {

ByteQueue::ByteQueue(const Clock& clock, std::string name, std::size_t mostUnread)
    : clock_(clock), name_(std::move(name)), mostUnread_(mostUnread)
{
}

bool ByteQueue::push(std::span<const std::uint8_t> bytes)
{
    const std::scoped_lock lock(mutex_);
    if (ended_)
        return false;
    if (bytes.empty())
        return true;
    if (bytes_.size() + bytes.size() + (arrivals_.size() + 1) * sizeof(Mark) > mostUnread_) {
        ended_ = Error{ErrorCode::DeviceLost,
                       name_ + ": the device sent more than was read and the link was closed; connect it again"};
        changed_.notify_all();
        return false;
    }
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    arrivals_.push_back({bytes.size(), clock_.now()});
    changed_.notify_all();
    return true;
}

void ByteQueue::end(Error reason)
{
    const std::scoped_lock lock(mutex_);
    if (!ended_)
        ended_ = std::move(reason);
    changed_.notify_all();
}

std::optional<Error> ByteQueue::ended() const
{
    const std::scoped_lock lock(mutex_);
    return ended_;
}

Result<Transport::Arrival> ByteQueue::read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                                           const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    for (;;) {
        if (!arrivals_.empty())
            return take(into);
        if (ended_)
            return tl::unexpected<Error>(*ended_);
        const std::chrono::nanoseconds now = clock_.now();
        if (now >= deadline || stop.stop_requested())
            return Transport::Arrival{0, now};
        clock_.wait(lock, changed_, stop, deadline);
    }
}

Transport::Arrival ByteQueue::take(std::span<std::uint8_t> into)
{
    Mark& first = arrivals_.front();
    const Transport::Arrival arrival{std::min(into.size(), first.count), first.at};
    const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(arrival.count);
    std::copy(bytes_.begin(), end, into.begin());
    bytes_.erase(bytes_.begin(), end);
    first.count -= arrival.count;
    if (first.count == 0)
        arrivals_.pop_front();
    return arrival;
}

}  // namespace planewright
