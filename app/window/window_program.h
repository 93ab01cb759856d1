// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "app/window/window_options.h"

namespace planewright {

/// Runs the window program until it ends, and gives its exit code.
int runWindow(const WindowOptions& options, int& argc, char** argv);

}  // namespace planewright
