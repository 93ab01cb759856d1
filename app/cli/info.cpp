// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/json_text.h"
#include "app/cli/recording_file.h"
#include "app/cli/text.h"
#include "core/geometry/sensor_model.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

/// A fact about a recording: its key in JSON, what people read, and its value.
struct Fact {
    std::string key;
    std::string label;
    Json value;
};

double roundedDegrees(double radians)
{
    return rounded(toDegrees(radians));
}

std::vector<Fact> factsOf(const RecordingFile& read)
{
    const ScanDescription& description = read.recording.description;
    const std::vector<ScanSlice>& slices = read.recording.slices;
    const SensorModel sensor = sensorOf(description);
    std::int64_t returns = 0;
    double nearest = 0.0;
    double farthest = 0.0;
    bool continuous = false;
    bool interlaced = false;
    for (const ScanSlice& slice : slices) {
        continuous = continuous || slice.tiltEnd.has_value();
        interlaced = interlaced || slice.ownBearing;
        for (const double range : slice.ranges) {
            if (!sensor.hasEcho(range))
                continue;
            nearest = returns == 0 ? range : std::min(nearest, range);
            farthest = std::max(farthest, range);
            ++returns;
        }
    }
    const ScanSlice& first = slices.front();
    const ScanSlice& last = slices.back();
    const auto missing =
        static_cast<std::int64_t>(last.step) - first.step + 1 - static_cast<std::int64_t>(slices.size());
    return {
        {"scanner", "scanner", description.scanner},
        {"slices", "slices", slices.size()},
        {"first_step", "first step", first.step},
        {"last_step", "last step", last.step},
        {"missing_steps", "missing steps", missing},
        {"beams", "beams in a slice", description.beams},
        {"points", "points", slices.size() * static_cast<std::size_t>(description.beams)},
        {"returns", "returns", returns},
        {"nearest_m", "nearest return [m]", rounded(nearest)},
        {"farthest_m", "farthest return [m]", rounded(farthest)},
        {"pitch_first_deg", "first pitch [deg]", roundedDegrees(first.tilt)},
        {"pitch_last_deg", "last pitch [deg]", roundedDegrees(last.tilt)},
        {"continuous", "nods on during a slice", continuous},
        {"bearing_start_deg", "bearing of beam 0 [deg]", roundedDegrees(description.firstBearing)},
        {"bearing_step_deg", "bearing step [deg]", roundedDegrees(description.bearingStep)},
        {"interlaced", "own bearing per slice", interlaced},
        {"range_min_m", "least range [m]", rounded(description.rangeMin)},
        {"range_max_m", "largest range [m]", rounded(description.rangeMax)},
        {"pitch_axis_offset_m", "pitch axis offset [m]", rounded(description.pitchAxisOffset)},
        {"duration_s", "duration [s]", rounded(std::chrono::duration<double>(last.time - first.time).count())},
        {"damaged", "damaged", read.damaged},
    };
}

/// What only a .pwscan says of a scan.
std::vector<Fact> factsOf(const ScanNotes& notes, const std::vector<ScanSlice>& slices)
{
    const auto suspects = std::count_if(slices.begin(), slices.end(), [](const auto& s) { return s.angleSuspect; });
    return {
        {"scan", "scan", notes.scan.id},
        {"name", "name", notes.scan.name},
        {"state", "state", name(notes.scan.state)},
        {"started_utc", "started (UTC)", notes.scan.startedUtc},
        {"floor", "floor", notes.scan.floor},
        {"planned_slices", "planned slices", notes.scan.plannedSlices ? Json(*notes.scan.plannedSlices) : Json()},
        {"suspect_slices", "slices of suspect angle", suspects},
        {"events", "events", notes.events.size()},
        {"edits", "edits in force", editsInForce(notes.edits).size()},
    };
}

std::string factLine(const std::string& label, const std::string& value)
{
    constexpr std::size_t kColumn = 26;
    const std::string blanks(label.size() < kColumn ? kColumn - label.size() : 1, ' ');
    return "  " + label + blanks + (value.empty() ? "not given" : value) + "\n";
}

/// What is said of files, as text and as JSON, and what the program returns for them.
struct Report {
    std::string text;
    Json json = Json::array();
    ExitCode worst = ExitCode::Done;

    void add(const std::string& path, const RecordingFile& read);
    /// The other files still have their say; the worst decides what the program returns.
    void add(const Error& error)
    {
        printError(error.message);
        worst = exitCodeOf(error.code);
    }
};

void Report::add(const std::string& path, const RecordingFile& read)
{
    if (read.damaged && worst == ExitCode::Done)
        worst = ExitCode::Damaged;
    std::vector<Fact> facts = read.notes ? factsOf(*read.notes, read.recording.slices) : std::vector<Fact>{};
    for (Fact& fact : factsOf(read))
        facts.push_back(std::move(fact));
    Json file{{"file", path}};
    text += path + "\n";
    for (const Fact& fact : facts) {
        file[fact.key] = fact.value;
        text += factLine(fact.label, fact.value.is_null() ? "" : valueText(fact.value));
    }
    file["extra"] = Json::object();
    for (const auto& [key, value] : read.recording.description.extra) {
        file["extra"][key] = value;
        text += factLine(key, value);
    }
    json.push_back(std::move(file));
}

Result<ExitCode> info(const std::vector<std::string>& paths, bool asJson)
{
    if (const auto known = checkRecordingNames(paths); !known)
        return tl::unexpected{known.error()};
    Report report;
    for (const std::string& path : paths) {
        const auto choices = scansOfRecordingFile(path);
        if (!choices) {
            report.add(choices.error());
            continue;
        }
        for (RecordingChoice choice : *choices) {
            choice.keepsSuspects = true;
            if (const auto read = readRecordingFile(path, choice))
                report.add(path, *read);
            else
                report.add(read.error());
        }
    }
    if (const auto printed = print(asJson ? jsonText(report.json) : report.text); !printed)
        return tl::unexpected{printed.error()};
    return report.worst;
}

}  // namespace

void addInfoCommand(CLI::App& program, Command& chosen)
{
    struct InfoOptions {
        std::vector<std::string> paths;
        bool json = false;
    };
    CLI::App& command = *program.add_subcommand("info", "what recordings hold");
    auto options = std::make_shared<InfoOptions>();
    command
        .add_option("FILE", options->paths,
                    "recordings (.csv, .csv.gz or .pwscan), or clouds (.pcd, .ptx, .3d or a folder of these)")
        ->required();
    command.add_flag("--json", options->json, "as JSON");
    command.callback([options, &chosen] { chosen = [options] { return info(options->paths, options->json); }; });
}

}  // namespace planewright
