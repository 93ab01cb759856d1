// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>

#include "core/types/error.h"
#include "devices/device_address.h"

namespace planewright {

/// What an address names, before anything is opened.
struct SourceAddress {
    enum class Kind {
        Simulation,  ///< sim:SCENE?seed=N&speed=X
        Replay,      ///< replay:FILE?speed=X
        Laser,       ///< usb:, tcp:, serial: or dialogue: as device_address.h has them
        File,        ///< a plain file name: to be looked at, not to be waited for
    };
    Kind kind = Kind::File;
    std::string name;  ///< of the scene, the path of the file, or the laser's address as it was given
    std::uint64_t seed = 1;
    double speed = 1.0;  ///< 1 is real time, 0 as fast as possible
    DeviceAddress laser;
};

/// Reads an address. The options begin at the last '?': a file whose name has one is given with a '?' behind it.
///
/// Errors (Usage) begin with the address: no name, an unknown key (with those known), a key twice, a number that is
/// none or out of limits, a tilt unit, which scans nothing by itself. Whether the scene, the file or the laser is there
/// shows when it is opened.
Result<SourceAddress> parseSourceAddress(const std::string& text);

}  // namespace planewright
