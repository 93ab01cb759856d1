// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/types/error.h"

namespace planewright {

/// What the program tells the shell.
enum class ExitCode {
    Done = 0,
    Internal = 1,        ///< our own fault
    Usage = 2,           ///< a wrong option or parameter
    Unreadable = 3,      ///< an input that cannot be read or is malformed; nothing was written
    Damaged = 4,         ///< an input was cut short, or a scan lacks slices; what is valid was processed and written
    NotWritten = 5,      ///< an output could not be written
    NoDevice = 6,        ///< a device was not found, not permitted, or not what was expected
    DeviceLost = 7,      ///< a device was lost during the scan; what was recorded is valid
    GateFailed = 8,      ///< the work was done, its result is worse than allowed
    NoRenderer = 9,      ///< nothing here can draw
    NeedsOperator = 10,  ///< a device waits for a person to release it; what was recorded is valid
    Interrupted = 130,
};

/// The exit code of an error.
constexpr ExitCode exitCodeOf(ErrorCode code)
{
    switch (code) {
        case ErrorCode::Usage:
            return ExitCode::Usage;
        case ErrorCode::Unreadable:
            return ExitCode::Unreadable;
        case ErrorCode::NotWritten:
            return ExitCode::NotWritten;
        case ErrorCode::GateFailed:
            return ExitCode::GateFailed;
        case ErrorCode::NoRenderer:
            return ExitCode::NoRenderer;
        case ErrorCode::NoDevice:
            return ExitCode::NoDevice;
        case ErrorCode::DeviceLost:
            return ExitCode::DeviceLost;
        case ErrorCode::NeedsOperator:
            return ExitCode::NeedsOperator;
        case ErrorCode::Interrupted:
            return ExitCode::Interrupted;
        case ErrorCode::Internal:
            break;
    }
    return ExitCode::Internal;
}

}  // namespace planewright
