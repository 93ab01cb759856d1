// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/descriptor_link.h"

#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <system_error>
#include <utility>
#include <vector>

namespace planewright {

namespace {

bool isSocket(const Descriptor& descriptor)
{
    struct stat status = {};
    return ::fstat(descriptor.number(), &status) == 0 && S_ISSOCK(status.st_mode);
}

bool meansLater(int error)
{
    return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

/// Takes what has come and nobody will read: the system would break off the connection because of it, and throw away
/// what was sent last.
void endInOrder(const Descriptor& socket)
{
    // Not without end: a laser goes on scanning meanwhile.
    constexpr int kMostReads = 64;
    std::vector<std::uint8_t> unread(std::size_t{1} << 16);
    ssize_t count = 1;
    for (int reads = 0; reads < kMostReads && count > 0; ++reads)
        count = ::read(socket.number(), unread.data(), unread.size());
    ::shutdown(socket.number(), SHUT_WR);
}

}  // namespace

Result<std::unique_ptr<Transport>> DescriptorLink::open(Descriptor descriptor, std::string name, LinkEndText endText,
                                                        const Clock& clock)
{
    const int flags = ::fcntl(descriptor.number(), F_GETFL);
    std::unique_ptr<DescriptorLink> link{
        new DescriptorLink(std::move(descriptor), std::move(name), std::move(endText), clock)};
    const auto refuse = [&] {
        return fail(ErrorCode::NoDevice,
                    link->name_ + ": the system has no threads or files left; end other programs and try again");
    };
    if (!link->over_.isOpen() || flags < 0 || ::fcntl(link->descriptor_.number(), F_SETFL, flags | O_NONBLOCK) < 0)
        return refuse();
    try {
        link->receiver_ = std::thread{[receiving = link.get()] { receiving->receive(); }};
    } catch (const std::system_error&) {
        return refuse();
    }
    return link;
}

DescriptorLink::DescriptorLink(Descriptor descriptor, std::string name, LinkEndText endText, const Clock& clock)
    : name_(std::move(name)),
      endText_(std::move(endText)),
      clock_(clock),
      isSocket_(isSocket(descriptor)),
      received_(clock, name_),
      descriptor_(std::move(descriptor))
{
}

DescriptorLink::~DescriptorLink()
{
    DescriptorLink::close();
}

Result<Transport::Arrival> DescriptorLink::read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                                                const std::stop_token& stop)
{
    return received_.read(into, deadline, stop);
}

Result<void> DescriptorLink::write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline)
{
    const std::scoped_lock lock(writing_);
    while (!bytes.empty()) {
        const Result<std::size_t> sent = sendSome(bytes);
        if (!sent)
            return tl::unexpected<Error>(sent.error());
        bytes = bytes.subspan(*sent);
        if (bytes.empty())
            break;
        const Readiness ready = waitUntilReady(descriptor_.number(), POLLOUT, over_, deadline - clock_.now());
        // Half a command has gone, and nobody knows which half: what follows would not be understood.
        if (!ready.woken && ready.events == 0)
            end("did not take what was sent to it in time; check its power and its cable, then connect it again");
    }
    if (const auto over = received_.ended())
        return tl::unexpected<Error>(*over);
    return {};
}

Result<std::size_t> DescriptorLink::sendSome(std::span<const std::uint8_t> bytes)
{
    if (const auto over = received_.ended())
        return tl::unexpected<Error>(*over);
    const int number = descriptor_.number();
    // A socket whose other end is gone would end the whole program by a signal.
    const ssize_t sent = isSocket_ ? ::send(number, bytes.data(), bytes.size(), MSG_NOSIGNAL)
                                   : ::write(number, bytes.data(), bytes.size());
    if (sent >= 0)
        return static_cast<std::size_t>(sent);
    const int error = errno;
    if (meansLater(error))
        return std::size_t{0};
    end(endText_(error, anythingCame_));
    return tl::unexpected<Error>(*received_.ended());
}

void DescriptorLink::receive()
{
    std::vector<std::uint8_t> buffer(std::size_t{1} << 16);
    for (;;) {
        const Readiness ready = waitUntilReady(descriptor_.number(), POLLIN, over_, std::nullopt);
        if (ready.woken || !receiveOnce(buffer, ready.events))
            break;
    }
    over_.raise();
    giveBack();
}

bool DescriptorLink::receiveOnce(std::span<std::uint8_t> buffer, short events)
{
    const ssize_t count = ::read(descriptor_.number(), buffer.data(), buffer.size());
    if (count > 0) {
        anythingCame_ = true;
        return received_.push(buffer.first(static_cast<std::size_t>(count)));
    }
    const int error = count == 0 ? 0 : errno;
    // A line that has hung up is always ready and never has anything: no second try, or this would turn without end.
    if (count < 0 && meansLater(error) && (events & (POLLHUP | POLLERR | POLLNVAL)) == 0)
        return true;
    end(endText_(meansLater(error) ? EIO : error, anythingCame_));
    return false;
}

void DescriptorLink::end(const std::string& why)
{
    received_.end({ErrorCode::DeviceLost, name_ + ": " + why});
    over_.raise();
}

void DescriptorLink::giveBack()
{
    const std::scoped_lock lock(writing_);
    if (isSocket_)
        endInOrder(descriptor_);
    descriptor_.reset();
}

void DescriptorLink::close()
{
    end("the link was closed; connect it again");
    const std::scoped_lock lock(closing_);
    if (receiver_.joinable())
        receiver_.join();
}

}  // namespace planewright
