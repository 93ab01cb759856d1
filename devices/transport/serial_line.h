// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include "core/types/error.h"
#include "devices/clock.h"
#include "devices/transport/transport.h"

namespace planewright {

/// Opens a serial port of the system, such as "/dev/ttyUSB0", for this program alone: raw, 8N1, without flow control,
/// at `baud` [bit/s]. A pseudo terminal is one as well.
///
/// Errors (NoDevice), with what to do: no such port, no permission (with the command that gives it), held by another
/// program, no serial port, a speed that it cannot have.
Result<std::unique_ptr<Transport>> openSerialLine(const std::string& path, int baud, const Clock& clock);

/// True where a port is there and this user has no right to open it.
bool isForbiddenPort(const std::string& path);

/// The shell command that lets this user open a serial port, after the next login: adds him to the port's group.
std::string serialPermissionCommand(const std::string& path);

/// Why a serial port cannot be opened, and what to do; without the path in front. `error` is the system's number.
std::string serialTroubleText(int error, const std::string& path);

}  // namespace planewright
