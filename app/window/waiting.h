// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <functional>

#include "app/window/window_parts.h"
#include "core/types/error.h"

namespace planewright {

/// Lets the program go on until something holds; false after the time.
bool waitUntil(const std::function<bool()>& holds, std::chrono::milliseconds time);

/// Whether nothing comes of a scan by itself.
bool isAtRest(SessionState state);

/// Whether the window shows what is looked at: the session's map, or it after a phase.
bool isShown(const WindowParts& parts);

/// Lets the program go on until nothing is being opened, scanned or worked out any more, and the window shows it.
/// Errors: what the session failed with; Internal where it takes longer than the time.
Result<void> waitForRest(WindowParts& parts, std::chrono::milliseconds time);

}  // namespace planewright
