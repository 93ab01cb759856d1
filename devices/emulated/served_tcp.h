// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string_view>

#include "core/types/error.h"
#include "devices/emulated/served_line.h"

namespace planewright {

/// Listens at `PORT` or `HOST:PORT` as ServedLine::open() has it. As with a laser, whoever comes while somebody is
/// connected is let in and shown out at once.
Result<std::unique_ptr<ServedLine>> openServedTcp(std::string_view place);

}  // namespace planewright
