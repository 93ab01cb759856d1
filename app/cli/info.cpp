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

double inDegrees(double radians)
{
    return rounded(toDegrees(radians));
}

std::vector<Fact> factsOf(const ReadRecording& read)
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
        {"pitch_first_deg", "first pitch [deg]", inDegrees(first.tilt)},
        {"pitch_last_deg", "last pitch [deg]", inDegrees(last.tilt)},
        {"continuous", "nods on during a slice", continuous},
        {"bearing_start_deg", "bearing of beam 0 [deg]", inDegrees(description.firstBearing)},
        {"bearing_step_deg", "bearing step [deg]", inDegrees(description.bearingStep)},
        {"interlaced", "own bearing per slice", interlaced},
        {"range_min_m", "least range [m]", rounded(description.rangeMin)},
        {"range_max_m", "largest range [m]", rounded(description.rangeMax)},
        {"pitch_axis_offset_m", "pitch axis offset [m]", rounded(description.pitchAxisOffset)},
        {"duration_s", "duration [s]", rounded(std::chrono::duration<double>(last.time - first.time).count())},
        {"damaged", "damaged", read.damaged},
    };
}

std::string factLine(const std::string& label, const std::string& value)
{
    constexpr std::size_t kColumn = 26;
    const std::string blanks(label.size() < kColumn ? kColumn - label.size() : 1, ' ');
    return "  " + label + blanks + (value.empty() ? "not given" : value) + "\n";
}

Result<ExitCode> info(const std::vector<std::string>& paths, bool asJson)
{
    if (const auto known = checkRecordingNames(paths); !known)
        return tl::unexpected{known.error()};
    ExitCode worst = ExitCode::Done;
    Json all = Json::array();
    std::string text;
    for (const std::string& path : paths) {
        const auto read = readRecordingFile(path);
        if (!read) {
            // The other files still have their say; the worst decides what the program returns.
            printError(read.error().message);
            worst = exitCodeOf(read.error().code);
            continue;
        }
        if (read->damaged && worst == ExitCode::Done)
            worst = ExitCode::Damaged;
        Json file{{"file", path}};
        text += path + "\n";
        for (const Fact& fact : factsOf(*read)) {
            file[fact.key] = fact.value;
            text += factLine(fact.label, valueText(fact.value));
        }
        file["extra"] = Json::object();
        for (const auto& [key, value] : read->recording.description.extra) {
            file["extra"][key] = value;
            text += factLine(key, value);
        }
        all.push_back(std::move(file));
    }
    if (const auto printed = print(asJson ? jsonText(all) : text); !printed)
        return tl::unexpected{printed.error()};
    return worst;
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
    command.add_option("FILE", options->paths, "recordings (.csv or .csv.gz)")->required();
    command.add_flag("--json", options->json, "as JSON");
    command.callback([options, &chosen] { chosen = [options] { return info(options->paths, options->json); }; });
}

}  // namespace planewright
