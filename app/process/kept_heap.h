// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace planewright {

/// Lets a program keep the memory that it frees, for its own next use: to be called first in main().
///
/// glibc gives the top of the heap back at each free above a bound that starts at 128 KiB, and the kernel clears the
/// pages anew when they are asked for again: that takes as long as the extraction of a whole scan. Its bounds grow by
/// themselves to those that are set here, once a program has freed blocks so large. With another C library nothing
/// happens.
void keepFreedMemory();

}  // namespace planewright
