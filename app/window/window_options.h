// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/parameter_options.h"
#include "app/window/picture_size.h"
#include "core/types/error.h"
#include "ui/common/palette.h"
#include "ui/opengl/offscreen_context.h"

namespace planewright {

/// Which way the window is drawn.
enum class RendererChoice { Auto, Osmesa, Egl, Gl };

/// What the command line of the window program says.
struct WindowOptions {
    std::string input;  ///< a file or an address; empty for none
    bool offscreen = false;
    std::string script;
    std::string screenshot;
    PictureSize size;  ///< of the screenshot
    bool wholeWindow = false;
    int step = -1;  ///< the last
    std::optional<Theme> theme;
    double scale = 1.0;
    RendererChoice renderer = RendererChoice::Auto;
    bool safeMode = false;  ///< without what was kept: layout, preferences, shortcuts
    ParameterOptions parameters;
};

/// Reads the command line. Gives options, or the exit code where there is nothing more to do (help, version, a usage
/// error that was told on stderr).
tl::expected<WindowOptions, int> parseWindowOptions(int argc, char** argv);

}  // namespace planewright
