// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/recording_file.h"
#include "app/files/file_kind.h"

namespace planewright {

namespace {

struct ConvertOptions {
    std::string input, output;
    int scan = -1;  ///< the last
    bool overwrite = false;
};

Result<ExitCode> convert(const ConvertOptions& options)
{
    const auto suffix = checkRecordingTarget(options.output);
    if (!suffix)
        return tl::unexpected{suffix.error()};
    OutputFiles files{options.overwrite};
    files.protect(options.input);
    const auto file = files.open(options.output);
    if (!file)
        return tl::unexpected{file.error()};
    RecordingChoice choice = chosenScan(options.scan);
    choice.keepsSuspects = *suffix == kPwscanSuffix;
    const auto input = readRecordingFile(options.input, choice);
    if (!input)
        return tl::unexpected{input.error()};
    Result<void> written =
        (*file)->write([&](std::ostream& out) { return writeRecording(out, input->recording, *suffix, input->notes); });
    if (written)
        written = files.publish();
    if (!written)
        return tl::unexpected{written.error()};
    return input->damaged ? ExitCode::Damaged : ExitCode::Done;
}

}  // namespace

void addConvertCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand("convert", "a recording in another format");
    auto options = std::make_shared<ConvertOptions>();
    command.add_option("IN", options->input, "recording (.csv, .csv.gz or .pwscan)")->required();
    command.add_option("OUT", options->output, "file to write; its suffix tells the format")->required();
    addScanOption(command, options->scan);
    command.add_flag("--overwrite", options->overwrite, "replace an output file that exists");
    command.callback([options, &chosen] { chosen = [options] { return convert(*options); }; });
}

}  // namespace planewright
