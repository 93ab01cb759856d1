// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "devices/transport/byte_queue.h"
#include "devices/transport/descriptor.h"
#include "devices/transport/transport.h"
#include "devices/transport/wake_event.h"

namespace planewright {

/// Why a link is over, for messages: `error` is the system's number, 0 where the other side ended it in order;
/// `anythingCame` is false where it ended before its first byte. Gives a sentence and what to do, without the name.
using LinkEndText = std::function<std::string(int error, bool anythingCame)>;

/// Bytes over a descriptor of the system: what TCP connections and serial lines have in common.
///
/// A thread of its own receives, so that times of arrival are true while the reader is busy. At the first error the
/// link is over and the descriptor given back at once: a device that comes again needs its name.
class DescriptorLink : public Transport {
public:
    /// Takes a descriptor that is open, and makes it one that does not block. Errors (NoDevice): the system has no
    /// thread or descriptor left.
    static Result<std::unique_ptr<Transport>> open(Descriptor descriptor, std::string name, LinkEndText endText,
                                                   const Clock& clock);
    ~DescriptorLink() override;

    std::string name() const override { return name_; }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override;
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override;
    void close() override;

private:
    DescriptorLink(Descriptor descriptor, std::string name, LinkEndText endText, const Clock& clock);

    /// The receiver's loop: until the link is over.
    void receive();
    /// Takes what is there; false where the link is over.
    bool receiveOnce(std::span<std::uint8_t> buffer, short events);
    /// Sends what fits now; gives the count.
    Result<std::size_t> sendSome(std::span<const std::uint8_t> bytes);
    void end(const std::string& why);
    void giveBack();

    std::string name_;
    LinkEndText endText_;
    const Clock& clock_;
    bool isSocket_;
    ByteQueue received_;
    std::atomic<bool> anythingCame_{false};
    WakeEvent over_;
    std::mutex writing_;  ///< held while bytes are sent, and where the descriptor is given back
    Descriptor descriptor_;
    std::mutex closing_;  ///< held while the receiver is waited for
    std::thread receiver_;
};

}  // namespace planewright
