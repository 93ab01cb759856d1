// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/served_pty.h"

#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <termios.h>
#include <utility>

#include "devices/transport/serial_settings.h"

namespace planewright {

namespace {

/// The system tells when a client closes the terminal, but not when one opens it: so one looks.
constexpr std::chrono::milliseconds kLookAgain{10};

Descriptor openEnd(const std::string& path)
{
    return Descriptor{::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
}

class ServedPty : public ServedLine {
public:
    ServedPty(Descriptor master, std::string path) : master_(std::move(master)), path_(std::move(path)) {}

    std::string address() const override { return "serial:" + path_; }

    void watch(std::vector<pollfd>& watched) const override
    {
        // Without a client it is always ready: to tell that there is none.
        if (hasClient_)
            watched.push_back(watchClient());
    }

    std::optional<std::chrono::nanoseconds> patience() const override
    {
        return hasClient_ || !master_.isOpen() ? std::nullopt : std::optional<std::chrono::nanoseconds>{kLookAgain};
    }

    std::vector<std::uint8_t> serve() override
    {
        std::vector<std::uint8_t> received;
        if (!hasClient_ && master_.isOpen())
            hasClient_ = isOpenedBySomebody();
        if (hasClient_ && !exchange(received)) {
            hasClient_ = false;
            forgetUnsent();
            forgetUnread();
        }
        return received;
    }

    void setPluggedIn(bool isPluggedIn) override
    {
        if (isPluggedIn)
            return;
        hasClient_ = false;
        master_.reset();
        forgetUnsent();
    }

protected:
    const Descriptor& client() const override { return hasClient_ ? master_ : nobody_; }

private:
    bool isOpenedBySomebody() const
    {
        pollfd state{master_.number(), POLLIN, 0};
        ::poll(&state, 1, 0);
        // Who said something and has gone since is heard all the same.
        return (state.revents & POLLHUP) == 0 || (state.revents & POLLIN) != 0;
    }

    void forgetUnread() const
    {
        if (const Descriptor end = openEnd(path_); end.isOpen())
            ::tcflush(end.number(), TCIFLUSH);
    }

    Descriptor master_;
    std::string path_;
    Descriptor nobody_;
    bool hasClient_ = false;
};

}  // namespace

Result<std::unique_ptr<ServedLine>> openServedPty()
{
    constexpr int kBaud = 115200;
    Descriptor master{::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)};
    std::array<char, 128> path{};
    if (!master.isOpen() || ::grantpt(master.number()) != 0 || ::unlockpt(master.number()) != 0 ||
        ::ptsname_r(master.number(), path.data(), path.size()) != 0 || !setRawLine(master.number(), kBaud))
        return fail(ErrorCode::NoDevice,
                    "pty: the system has no pseudo terminals left; end other programs, or "
                    "serve on tcp:0");
    // Opened and closed once, the terminal tells that nobody has it; before, it does not.
    openEnd(path.data());
    return std::make_unique<ServedPty>(std::move(master), path.data());
}

}  // namespace planewright
