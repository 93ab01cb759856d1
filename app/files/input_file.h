// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <istream>
#include <memory>
#include <stop_token>
#include <string>

#include "core/types/error.h"

namespace planewright {

/// Largest input that is opened [bytes].
inline constexpr long long kLargestInput = 4LL << 30;

/// Opens a regular file of at most kLargestInput for reading; a folder, device, socket or pipe is refused before a byte
/// is read or waited for. A failure while reading sets the stream's badbit, and so does a stop that is asked for.
/// Errors (Unreadable) name the file.
Result<std::unique_ptr<std::istream>> openInput(const std::string& path, const std::stop_token& stop = {});

}  // namespace planewright
