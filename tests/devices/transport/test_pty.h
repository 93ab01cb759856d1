// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdlib>
#include <fcntl.h>
#include <string>

#include "devices/transport/descriptor.h"

namespace planewright {

/// A pseudo terminal: what is written to one end comes out of the other. The test holds the master, the program under
/// test opens the path.
struct TestPty {
    Descriptor master{::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)};
    std::string path;

    TestPty()
    {
        char name[64] = "";
        if (::grantpt(master.number()) == 0 && ::unlockpt(master.number()) == 0 &&
            ::ptsname_r(master.number(), name, sizeof name) == 0)
            path = name;
    }
};

/// Opens a terminal as a program does that knows nothing of it.
inline Descriptor openPlainly(const std::string& path)
{
    return Descriptor{::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
}

}  // namespace planewright
