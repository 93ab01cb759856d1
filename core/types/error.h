// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <tl/expected.hpp>

namespace planewright {

/// What kind of thing went wrong; the command line turns it into its exit code.
enum class ErrorCode {
    Internal,       ///< our own fault
    Usage,          ///< a wrong option or parameter
    Unreadable,     ///< an input that cannot be read or is malformed; nothing was written
    NotWritten,     ///< an output that could not be written; what stood there before is untouched
    GateFailed,     ///< the work was done and its result is worse than the caller allowed
    NoRenderer,     ///< nothing here can draw
    NoDevice,       ///< a device that is not there, may not be opened, or is not what was expected
    DeviceLost,     ///< a device that was there and is gone, or does not answer any more
    NeedsOperator,  ///< a device that waits for a person to see to it and to release it; never tried again unasked
    Interrupted,    ///< the user asked to stop
};

/// A failure for a person to read: names the file, the place in it and what to do.
struct Error {
    ErrorCode code = ErrorCode::Internal;
    std::string message;
};

/// A value, or why there is none.
template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning a failure from a function that gives a Result.
inline tl::unexpected<Error> fail(ErrorCode code, std::string message)
{
    return tl::unexpected<Error>(Error{code, std::move(message)});
}

}  // namespace planewright
