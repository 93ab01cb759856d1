// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <exception>
#include <new>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/temporary_files.h"

namespace planewright {

namespace {

/// Says what is wrong with the command line and where help is.
ExitCode refuse(const CLI::App& program, const CLI::ParseError& error)
{
    std::string name = "planewright-cli";
    for (const CLI::App* chosen = &program; !chosen->get_subcommands().empty();) {
        chosen = chosen->get_subcommands().front();
        name += " " + chosen->get_name();
    }
    printError(std::string{error.what()} + "; see '" + name + " --help'");
    return ExitCode::Usage;
}

ExitCode run(int argc, char** argv)
{
    CLI::App program{"Planes from nodding 2D laser scans", "planewright-cli"};
    program.set_version_flag("--version", "planewright-cli " PLANEWRIGHT_VERSION);
    program.require_subcommand(1);
    Command command;
    for (const auto add : {addExtractCommand, addSimulateCommand, addConvertCommand, addInfoCommand, addValidateCommand,
                           addCompareCommand, addParamsCommand})
        add(program, command);
    Result<ExitCode> code = ExitCode::Done;
    try {
        program.parse(argc, argv);
        handleSignals();
        code = command();
    } catch (const CLI::CallForHelp&) {
        code = print(program.help()).map([] { return ExitCode::Done; });
    } catch (const CLI::CallForVersion& version) {
        code = print(std::string{version.what()} + "\n").map([] { return ExitCode::Done; });
    } catch (const CLI::ParseError& error) {
        return refuse(program, error);
    }
    if (code)
        return *code;
    printError(code.error().message);
    return exitCodeOf(code.error().code);
}

}  // namespace

}  // namespace planewright

int main(int argc, char** argv)
try {
    return static_cast<int>(planewright::run(argc, argv));
} catch (const std::bad_alloc&) {
    planewright::printError("out of memory; close other programs or use a smaller recording");
    return static_cast<int>(planewright::ExitCode::Internal);
} catch (const std::exception& error) {
    planewright::printError(std::string{"internal error: "} + error.what());
    return static_cast<int>(planewright::ExitCode::Internal);
}
