// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include "core/types/edit.h"
#include "core/types/error.h"

namespace planewright {

/// The word by which files call a kind of edit.
std::string_view name(Edit::Kind kind);

/// An edit's payload as JSON: `{"planes":[3,7]}`, with `"text"` for a name or class and `"on"` for hide and lock.
std::string editJson(const Edit& edit);

/// The edit of a kind's word and its payload, with all that it must have and nothing else. Its text is cleanName's.
/// Errors (Unreadable) begin with `place`.
Result<Edit> readEditJson(std::string_view kind, std::string_view payload, const std::string& place);

/// A name as planes may have it: at most 120 characters, without control characters and marks that turn the direction
/// of writing, and without blanks around it. Bytes that are no UTF-8 are left out.
std::string cleanName(std::string_view text);

}  // namespace planewright
