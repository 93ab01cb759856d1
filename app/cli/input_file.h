// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <istream>
#include <memory>
#include <string>

#include "core/types/error.h"

namespace planewright {

/// Largest input that is opened [bytes].
inline constexpr long long kLargestInput = 4LL << 30;

/// Opens a regular file of at most kLargestInput for reading; a folder, device, socket or pipe is refused before a byte
/// is read or waited for. A failure while reading sets the stream's badbit. Errors (Unreadable) name the file.
Result<std::unique_ptr<std::istream>> openInput(const std::string& path);

}  // namespace planewright
