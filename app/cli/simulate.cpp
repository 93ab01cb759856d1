// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/number_option.h"
#include "app/cli/output_files.h"
#include "app/cli/progress.h"
#include "app/cli/recording_file.h"
#include "app/cli/simulate_building.h"
#include "app/cli/simulate_options.h"
#include "app/cli/text.h"
#include "app/files/file_kind.h"
#include "core/formats/labels.h"
#include "core/formats/planes_csv.h"
#include "core/simulation/nodding_scanner.h"

namespace planewright {

namespace {

std::vector<PlaneResult> truthOf(const Scene& scene, const SimulatedScan& scan)
{
    std::map<int, int> returns;
    for (const std::vector<int>& labels : scan.labels) {
        for (const int label : labels)
            ++returns[label];
    }
    std::vector<PlaneResult> planes;
    for (const TruePlane& plane : scene.planes)
        planes.push_back(knownPlane(plane.id, plane.name, plane.normal, plane.distance, returns[plane.id]));
    return planes;
}

Result<ExitCode> simulateScene(const SimulateOptions& options)
{
    if (!options.truthPoses.empty() || options.stops > 0 || options.floors > 0)
        return fail(ErrorCode::Usage, "--stops, --floors and --truth-poses are for the scene 'building' alone");
    const Result<Scene> scene = makeScene(options.scene, options.seed);
    if (!scene)
        return tl::unexpected{scene.error()};
    const Result<SimulationNoise> noise = noiseOf(options);
    if (!noise)
        return tl::unexpected{noise.error()};
    const Result<AcquisitionSettings> settings = settingsOf(options);
    if (!settings)
        return tl::unexpected{settings.error()};
    const auto suffix = checkRecordingTarget(options.output);
    if (!suffix)
        return tl::unexpected{suffix.error()};
    if (!options.truth.empty()) {
        if (const auto csv = suffixOf(options.truth, {".csv"}, "the true planes"); !csv)
            return tl::unexpected{csv.error()};
    }

    OutputFiles files{options.overwrite};
    std::vector<OutputFile*> outputs;
    for (const std::string* path : {&options.output, &options.truth, &options.truthLabels}) {
        if (path->empty()) {
            outputs.push_back(nullptr);
            continue;
        }
        const auto file = files.open(*path);
        if (!file)
            return tl::unexpected{file.error()};
        outputs.push_back(*file);
    }

    Progress progress("simulating, slice");
    const SimulatedScan scanned = simulatedScan(*scene, *settings, *noise, options.seed, [&](int slices) {
        progress.show(static_cast<std::size_t>(slices), static_cast<std::size_t>(settings->slices));
    });
    Result<void> written =
        outputs[0]->write([&](std::ostream& out) { return writeRecording(out, scanned.recording, *suffix); });
    if (written && outputs[1] != nullptr)
        written = outputs[1]->write([&](std::ostream& out) { return writePlanesCsv(out, truthOf(*scene, scanned)); });
    if (written && outputs[2] != nullptr)
        written = outputs[2]->write([&](std::ostream& out) { return writeLabels(out, scanned.labels); });
    if (written)
        written = files.publish();
    if (!written)
        return tl::unexpected{written.error()};
    return ExitCode::Done;
}

}  // namespace

void addSimulateCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand("simulate", "a recording of a room whose planes are known");
    auto options = std::make_shared<SimulateOptions>();
    command.add_option("SCENE", options->scene, joined(sceneNames()) + ", or building: several stops on its floors")
        ->required();
    command.add_option("-o", options->output, "recording to write (.csv, .csv.gz or .pwscan)")
        ->type_name("FILE")
        ->required();
    command.add_option("--truth", options->truth, "the true planes as .csv")->type_name("FILE");
    command
        .add_option("--truth-labels", options->truthLabels,
                    "true plane of every beam: -1 none, -2 a surface that is no plane")
        ->type_name("FILE");
    addWholeNumber(command, "--seed", options->seed, std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max(),
                   "number that room and noise come from (default 1)");
    command.add_option("--noise", options->noise, joined(simulationNoiseNames()))
        ->type_name("PROFILE")
        ->capture_default_str();
    addNumber(command, "--dropout", options->dropout, 0.0, 100.0, "returns lost, in percent (default: the profile's)");
    command.add_option("--tilt", options->tilt, "pitch of the slices in degrees (default 10:170:1.16, 137 slices)")
        ->type_name("A:B:STEP");
    addWholeNumber(command, "--slices", options->slices, 1, kMaxSlices, "number of slices, whatever --tilt says");
    command.add_option("--bearing", options->bearing, "bearings in degrees (default 0:180:0.25, 721 beams)")
        ->type_name("A:B:STEP");
    addWholeNumber(command, "--floors", options->floors, 1, kMostFloors, "floors of a building (default 4)");
    addWholeNumber(command, "--stops", options->stops, 1, kMostStops,
                   "stops in a building (default 17 or 18 a floor: 70 on four)");
    command
        .add_option("--truth-poses", options->truthPoses,
                    "where the stops of a building are, in the frame of the first (TUM format)")
        ->type_name("FILE");
    command.add_flag("--overwrite", options->overwrite, "replace output files that exist");
    command.callback([options, &chosen] {
        chosen = [options] {
            return options->scene == kBuildingScene ? simulateBuilding(*options) : simulateScene(*options);
        };
    });
}

}  // namespace planewright
