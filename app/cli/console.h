// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include "core/types/error.h"

namespace planewright {

/// Fills standard streams that the caller has closed, so that no file that is opened later takes their place.
void reserveStandardStreams();

/// One line on stderr, `planewright-cli: …`; control characters of foreign texts become '?'.
void printError(std::string_view message);

/// The same of something that is no failure.
void printNote(std::string_view message);

/// One line on stderr, `planewright-cli: warning: …`.
void printWarning(std::string_view message);

/// What is waited for, again and again with a number that changes: the same line twice is printed once. On a terminal
/// each takes the place of the one before, and whatever is printed next takes that of the last. Any thread.
void printWaiting(const std::string& line);

/// Writes to standard output and flushes it. Errors: NotWritten.
Result<void> print(std::string_view text);

}  // namespace planewright
