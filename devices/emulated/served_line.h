// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <poll.h>
#include <span>
#include <string>
#include <vector>

#include "core/types/error.h"
#include "devices/transport/descriptor.h"

namespace planewright {

/// The place where another process finds an emulated device, for one client at a time. It has no thread: its owner
/// polls what watch() names and then calls serve().
class ServedLine {
public:
    /// Bytes that a client may leave unread before what comes is dropped, as by a device whose memory is full.
    static constexpr std::size_t kMostUnsent = std::size_t{256} << 10;

    /// Opens the place of a text: `tcp:PORT` on this machine alone, `tcp:HOST:PORT` where HOST is an address of this
    /// machine (0.0.0.0: all of them), both with 0 for any free port, or `pty` for a pseudo terminal.
    ///
    /// Errors: Usage for another text; NoDevice for a port that is in use or not allowed, and where the system has
    /// nothing left to give.
    static Result<std::unique_ptr<ServedLine>> open(const std::string& where);

    virtual ~ServedLine() = default;

    /// What a client opens: "tcp:127.0.0.1:10940", "serial:/dev/pts/4".
    virtual std::string address() const = 0;

    /// Appends what is to be polled.
    virtual void watch(std::vector<pollfd>& watched) const = 0;

    /// The longest time after which to serve it even where nothing was polled; empty: none.
    virtual std::optional<std::chrono::nanoseconds> patience() const { return std::nullopt; }

    /// Lets clients come and go, and moves bytes; gives those that came.
    virtual std::vector<std::uint8_t> serve() = 0;

    /// The device's plug is in or out. Out: whoever is connected loses it, and nobody else comes in.
    virtual void setPluggedIn(bool isPluggedIn) = 0;

    /// Sends all of the bytes, or none of them where nobody is there or too much is unread.
    void send(std::span<const std::uint8_t> bytes);

protected:
    /// Whoever is connected: nobody where it is not open.
    virtual const Descriptor& client() const = 0;
    /// What is to be polled for a client.
    pollfd watchClient() const;
    /// Moves what can be moved; false where the client is gone.
    bool exchange(std::vector<std::uint8_t>& received);
    void forgetUnsent() { unsent_.clear(); }

private:
    bool sendUnsent();

    std::vector<std::uint8_t> unsent_;
};

}  // namespace planewright
