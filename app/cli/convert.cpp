// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <string>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "app/cli/recording_file.h"
#include "app/files/cloud_file.h"
#include "app/files/file_kind.h"
#include "core/formats/recording_pwscan.h"

namespace planewright {

namespace {

struct ConvertOptions {
    std::string input, output;
    int scan = -1;  ///< the last
    bool overwrite = false;
};

/// All scans of a cloud's file, each with its pose: the stops of a map.
Result<ExitCode> convertAllScans(const std::string& path, OutputFile& file, OutputFiles& files)
{
    const auto choices = scansOfRecordingFile(path);
    if (!choices)
        return tl::unexpected{choices.error()};
    Result<void> written = file.write([&](std::ostream& out) {
        return writeScansPwscan(out, choices->size(), [&](std::size_t scan) -> Result<WrittenScan> {
            auto input = readRecordingFile(path, (*choices)[scan]);
            if (!input)
                return tl::unexpected{input.error()};
            return WrittenScan{std::move(input->recording), std::move(*input->notes)};
        });
    });
    if (written)
        written = files.publish();
    if (!written)
        return tl::unexpected{written.error()};
    return ExitCode::Done;
}

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
    if (*suffix == kPwscanSuffix && options.scan < 0 && isCloudFile(options.input))
        return convertAllScans(options.input, **file, files);
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
    command
        .add_option("IN", options->input,
                    "recording (.csv, .csv.gz or .pwscan), or cloud (.pcd, .ptx, .3d or a folder of these)")
        ->required();
    command.add_option("OUT", options->output, "file to write; its suffix tells the format")->required();
    addScanOption(command, options->scan);
    command.add_flag("--overwrite", options->overwrite, "replace an output file that exists");
    command.callback([options, &chosen] { chosen = [options] { return convert(*options); }; });
}

}  // namespace planewright
