// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "app/cli/exit_code.h"

namespace planewright {

/// Reads the command line, does what it says, and prints what went wrong.
ExitCode runProgram(int argc, char** argv);

}  // namespace planewright
