// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "core/types/error.h"
#include "devices/emulated/served_line.h"

namespace planewright {

/// Makes a pseudo terminal, raw, for a client that opens it as a serial port. What a client left unread is gone when
/// the next one comes. A plug that was pulled out is the end of it: a new terminal would have another name.
Result<std::unique_ptr<ServedLine>> openServedPty();

}  // namespace planewright
