// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace planewright {

/// What a result code of SQLite means to the owner of a file, and what to do about it.
std::string sqliteMessage(int code);

}  // namespace planewright
