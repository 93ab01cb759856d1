// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/program.h"

#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/temporary_files.h"

namespace planewright {

namespace {

/// Says what is wrong with the command line and where help is.
ExitCode refuse(const CLI::App& program, const CLI::ParseError& error)
{
    if (program.get_subcommands().empty()) {
        const std::vector<std::string> rest = program.remaining();
        const std::string kind = rest.empty() || !rest.front().starts_with('-') ? "command" : "option";
        printError((rest.empty() ? "give a command" : "there is no " + kind + " '" + rest.front() + "'") +
                   "; see 'planewright-cli --help'");
        return ExitCode::Usage;
    }
    std::string name = "planewright-cli";
    for (const CLI::App* chosen = &program; !chosen->get_subcommands().empty();) {
        chosen = chosen->get_subcommands().front();
        name += " " + chosen->get_name();
    }
    printError(std::string{error.what()} + "; see '" + name + " --help'");
    return ExitCode::Usage;
}

/// An empty value is the script's unset variable, not the wish to leave the option out.
void refuseEmptyValues(CLI::App& app)
{
    for (CLI::Option* option : app.get_options()) {
        if (option->get_items_expected_max() > 0)
            option->check([](const std::string& value) { return value.empty() ? "give a value" : std::string{}; });
    }
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        refuseEmptyValues(*command);
}

}  // namespace

ExitCode runProgram(int argc, char** argv)
{
    reserveStandardStreams();
    CLI::App program{"Planes from nodding 2D laser scans", "planewright-cli"};
    program.set_version_flag("--version", "planewright-cli " PLANEWRIGHT_VERSION);
    program.require_subcommand(1);
    Command command;
    for (const auto add : {addExtractCommand, addCalibrateCommand, addSimulateCommand, addRecordCommand,
                           addEmulateCommand, addDevicesCommand, addMapCommand, addConvertCommand, addInfoCommand,
                           addValidateCommand, addCompareCommand, addParamsCommand})
        add(program, command);
    refuseEmptyValues(program);
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

}  // namespace planewright
