// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "app/cli/exit_code.h"

namespace planewright {

/// What the command that was chosen does: gives an exit code, or an error for the user to read.
using Command = std::function<Result<ExitCode>()>;

/// Each adds a subcommand with its options to the program; parsing a command line that chooses it sets `chosen`.
void addExtractCommand(CLI::App& program, Command& chosen);
void addCalibrateCommand(CLI::App& program, Command& chosen);
void addSimulateCommand(CLI::App& program, Command& chosen);
void addRecordCommand(CLI::App& program, Command& chosen);
void addEmulateCommand(CLI::App& program, Command& chosen);
void addDevicesCommand(CLI::App& program, Command& chosen);
void addMapCommand(CLI::App& program, Command& chosen);
void addConvertCommand(CLI::App& program, Command& chosen);
void addInfoCommand(CLI::App& program, Command& chosen);
void addValidateCommand(CLI::App& program, Command& chosen);
void addCompareCommand(CLI::App& program, Command& chosen);
void addParamsCommand(CLI::App& program, Command& chosen);

}  // namespace planewright
