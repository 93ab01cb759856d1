// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ostream>

#include "core/types/error.h"

namespace planewright {

/// What became of everything that was written to a stream. The stream does not know its file's name; the caller does.
inline Result<void> written(std::ostream& out)
{
    out.flush();
    if (!out)
        return fail(ErrorCode::NotWritten, "could not be written; check the free space and that writing is permitted");
    return {};
}

}  // namespace planewright
