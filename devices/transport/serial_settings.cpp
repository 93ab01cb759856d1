// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/serial_settings.h"

// The C library's <termios.h> knows listed speeds only; 57142 of a servo is none. The kernel's own takes any, and the
// two headers cannot be read together, so that this file stands alone.
#include <asm/termbits.h>
#include <cerrno>
#include <cstdlib>
#include <linux/serial.h>
#include <sys/ioctl.h>

namespace planewright {

namespace {

/// A device whose clock cannot be divided down to a speed takes another: this much is too far for 8N1 [1/1000].
constexpr long long kMostDeviation = 20;

void setSpeed(termios2& line, int baud)
{
    line.c_cflag &= ~static_cast<tcflag_t>(CBAUD | CBAUD << IBSHIFT);
    line.c_cflag |= BOTHER | BOTHER << IBSHIFT;
    line.c_ospeed = static_cast<speed_t>(baud);
    line.c_ispeed = static_cast<speed_t>(baud);
}

}  // namespace

bool setRawLine(int descriptor, int baud)
{
    termios2 line{};
    if (::ioctl(descriptor, TCGETS2, &line) != 0)
        return false;
    line.c_iflag = IGNBRK;
    line.c_oflag = 0;
    line.c_lflag = 0;
    line.c_cflag &= ~static_cast<tcflag_t>(CSIZE | PARENB | CSTOPB | CRTSCTS | HUPCL);
    line.c_cflag |= CS8 | CREAD | CLOCAL;
    setSpeed(line, baud);
    // With one byte at least, a read that gives none means that the line has hung up.
    line.c_cc[VMIN] = 1;
    line.c_cc[VTIME] = 0;
    if (::ioctl(descriptor, TCSETS2, &line) != 0)
        return false;
    const long long off = std::llabs(static_cast<long long>(baudOf(descriptor)) - baud);
    if (off * 1000 <= kMostDeviation * baud)
        return true;
    errno = EINVAL;
    return false;
}

void raiseModemLines(int descriptor)
{
    int lines = TIOCM_DTR | TIOCM_RTS;
    ::ioctl(descriptor, TIOCMBIS, &lines);
    serial_struct driver{};
    if (::ioctl(descriptor, TIOCGSERIAL, &driver) != 0)
        return;
    driver.flags |= ASYNC_LOW_LATENCY;
    ::ioctl(descriptor, TIOCSSERIAL, &driver);
}

int baudOf(int descriptor)
{
    termios2 line{};
    return ::ioctl(descriptor, TCGETS2, &line) == 0 ? static_cast<int>(line.c_ospeed) : 0;
}

}  // namespace planewright
