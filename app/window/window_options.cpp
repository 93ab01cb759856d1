// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/window_options.h"

#include <cstdio>
#include <map>

#include <CLI/CLI.hpp>

#include "app/cli/exit_code.h"

namespace planewright {

tl::expected<WindowOptions, int> parseWindowOptions(int argc, char** argv)
{
    WindowOptions options;
    CLI::App program{"Planes of a room while it is being scanned"};
    program.name("planewright");
    program.set_version_flag("--version", "planewright " PLANEWRIGHT_VERSION);
    program.add_option("INPUT", options.input, "recording, project, or address as sim:corridor?seed=7");
    program.add_flag("--offscreen", options.offscreen, "without a display, for screenshots and scripts");
    program.add_option("--script", options.script, "actions to perform, a JSON object a line")->type_name("FILE");
    program.add_option("--screenshot", options.screenshot, "picture to write when the scan is complete (.png)")
        ->type_name("FILE");
    std::string size;
    program.add_option("--size", size, "of the screenshot, as 1280x800")->type_name("WxH");
    program.add_flag("--window", options.wholeWindow, "a screenshot of the whole window");
    program.add_option("--step", options.step, "step to show, counted from 0 (default: the last)")
        ->check(CLI::Range(0, 1'000'000'000));
    std::string theme;
    program.add_option("--theme", theme, "light or dark")->check(CLI::IsMember({"light", "dark"}));
    program.add_option("--scale", options.scale, "scale of the window, 0.5 to 4")->check(CLI::Range(0.5, 4.0));
    std::string renderer = "auto";
    const std::map<std::string, RendererChoice> renderers{{"auto", RendererChoice::Auto},
                                                          {"osmesa", RendererChoice::Osmesa},
                                                          {"egl", RendererChoice::Egl},
                                                          {"gl", RendererChoice::Gl}};
    program.add_option("--renderer", renderer, "auto, osmesa, egl or gl")
        ->check(CLI::IsMember({"auto", "osmesa", "egl", "gl"}));
    program.add_flag("--safe-mode", options.safeMode, "without the preferences and the layout that were kept");
    addParameterOptions(program, options.parameters);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked = error.get_exit_code() == 0;
        program.exit(error);
        return tl::unexpected<int>(asked ? 0 : static_cast<int>(ExitCode::Usage));
    }
    options.renderer = renderers.at(renderer);
    if (!theme.empty())
        options.theme = theme == "dark" ? Theme::Dark : Theme::Light;
    if (!size.empty()) {
        const auto read = readPictureSize(size);
        if (!read) {
            std::fprintf(stderr,
                         "planewright: --size: give width and height in pixels as 1280x800, each from %d to %d\n",
                         kFewestPixels, kMostPixels);
            return tl::unexpected<int>(static_cast<int>(ExitCode::Usage));
        }
        options.size = *read;
    }
    if (options.offscreen && options.renderer == RendererChoice::Gl) {
        std::fprintf(stderr, "planewright: --renderer gl needs a display; leave out --offscreen\n");
        return tl::unexpected<int>(static_cast<int>(ExitCode::Usage));
    }
    return options;
}

}  // namespace planewright
