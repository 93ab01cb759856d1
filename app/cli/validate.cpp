// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/json_text.h"
#include "app/cli/recording_file.h"

namespace planewright {

namespace {

/// What is to say about one file.
struct Verdict {
    ExitCode code = ExitCode::Done;
    std::string_view word = "valid";
    RecordingProblems found;
};

Verdict judge(const std::string& path)
{
    const auto read = problemsOfRecordingFile(path);
    if (!read)
        return {ExitCode::Unreadable, "unreadable", {{read.error().message}, 0, {}, false}};
    RecordingProblems found = *read;
    if (!found.problems.empty())
        return {ExitCode::Unreadable, "malformed", std::move(found)};
    if (found.damaged)
        return {ExitCode::Damaged, "damaged", std::move(found)};
    return {ExitCode::Done, "valid", std::move(found)};
}

std::string describe(const std::string& path, const Verdict& verdict)
{
    std::string text;
    for (const std::string& problem : verdict.found.problems)
        text += problem + "\n";
    if (verdict.found.more > 0)
        text += path + ": " + std::to_string(verdict.found.more) + " more problems\n";
    for (const std::string& warning : verdict.found.warnings)
        text += "warning: " + warning + "\n";
    return text + path + ": " + std::string{verdict.word} + "\n";
}

Result<ExitCode> validate(const std::vector<std::string>& paths, bool asJson)
{
    if (const auto known = checkRecordingNames(paths); !known)
        return tl::unexpected{known.error()};
    ExitCode worst = ExitCode::Done;
    Json all = Json::array();
    std::string text;
    for (const std::string& path : paths) {
        const Verdict verdict = judge(path);
        all.push_back({{"file", path},
                       {"verdict", verdict.word},
                       {"problems", verdict.found.problems},
                       {"more_problems", verdict.found.more},
                       {"warnings", verdict.found.warnings}});
        text += describe(path, verdict);
        // A malformed file cannot be used at all, a damaged one in part.
        if (worst != ExitCode::Unreadable && verdict.code != ExitCode::Done)
            worst = verdict.code;
    }
    if (const auto printed = print(asJson ? jsonText(all) : text); !printed)
        return tl::unexpected{printed.error()};
    return worst;
}

}  // namespace

void addValidateCommand(CLI::App& program, Command& chosen)
{
    struct ValidateOptions {
        std::vector<std::string> paths;
        bool json = false;
    };
    CLI::App& command = *program.add_subcommand("validate", "every problem that recordings have");
    auto options = std::make_shared<ValidateOptions>();
    command
        .add_option("FILE", options->paths,
                    "recordings (.csv, .csv.gz or .pwscan), or clouds (.pcd, .ptx, .3d or a folder of these)")
        ->required();
    command.add_flag("--json", options->json, "as JSON");
    command.callback([options, &chosen] { chosen = [options] { return validate(options->paths, options->json); }; });
}

}  // namespace planewright
