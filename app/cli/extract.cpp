// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/extraction_run.h"
#include "app/cli/number_option.h"
#include "app/cli/output_files.h"
#include "app/cli/parameter_options.h"
#include "app/cli/plane_table.h"
#include "app/cli/recording_file.h"
#include "app/cli/stored_scan.h"
#include "app/files/file_kind.h"
#include "app/files/scan_results.h"
#include "core/formats/history.h"
#include "core/geometry/correct_recording.h"
#include "core/segments/noise_doubt.h"
#include "core/types/angle_text.h"

namespace planewright {

namespace {

struct ExtractOptions {
    std::string input;
    int scan = -1;   ///< the last
    int until = -1;  ///< all steps
    std::vector<std::string> planes;
    std::string segments, points, labels, history, stats, floorPlan, report;
    double cutHeight = 1.0;  ///< above the floor [m]
    bool historyTimes = false;
    int repeats = 1;
    bool noEdits = false;
    bool overwrite = false;
    bool skipExisting = false;
    ParameterOptions parameters;
};

/// True where every output is there already: all appear together, each when it is complete.
bool isDone(const ExtractOptions& options)
{
    std::vector<std::string> outputs = options.planes;
    for (const std::string* path : {&options.segments, &options.points, &options.labels, &options.history,
                                    &options.stats, &options.floorPlan, &options.report}) {
        if (!path->empty())
            outputs.push_back(*path);
    }
    return !outputs.empty() &&
           std::ranges::all_of(outputs, [](const std::string& path) { return std::filesystem::is_regular_file(path); });
}

/// An opened output and what goes there.
struct PlannedOutput {
    OutputFile* file = nullptr;
    ResultWriter writer;
};

/// Opens outputs one by one and remembers the first failure.
class OutputPlan {
public:
    explicit OutputPlan(OutputFiles& files) : files_(files) {}

    void add(const std::string& path, const ResultWriter& writer)
    {
        if (path.empty() || !problem_)
            return;
        const auto file = files_.open(path);
        if (file)
            outputs_.push_back({*file, writer});
        else
            problem_ = tl::unexpected{file.error()};
    }

    template <class WriterOf>
    void add(const std::string& path, std::span<const std::string_view> suffixes, std::string_view what,
             WriterOf writerOf)
    {
        if (path.empty() || !problem_)
            return;
        const auto suffix = suffixOf(path, suffixes, what);
        if (suffix)
            add(path, writerOf(*suffix));
        else
            problem_ = tl::unexpected{suffix.error()};
    }

    const Result<void>& problem() const { return problem_; }
    const std::vector<PlannedOutput>& outputs() const { return outputs_; }

private:
    OutputFiles& files_;
    Result<void> problem_;
    std::vector<PlannedOutput> outputs_;
};

Result<void> keepUntil(Recording& recording, int until)
{
    if (until < 0)
        return {};
    if (!recording.slices.empty() && recording.slices.front().step > until)
        return fail(ErrorCode::Usage, "--until: the recording begins with step " +
                                          std::to_string(recording.slices.front().step) + ", give that or a later one");
    std::erase_if(recording.slices, [&](const ScanSlice& slice) { return slice.step > until; });
    return {};
}

/// Tells where ranges scatter by far more than the method takes for true.
void tellDoubtOfNoise(const Recording& recording, const NoiseParameters& told, const std::string& path)
{
    const std::optional<NoiseDoubt> doubt = noiseDoubtOf(recording, told);
    if (!doubt)
        return;
    const auto millimetres = [](double x) { return fixedText(1000.0 * x, 1) + " mm"; };
    printWarning(path + ": ranges scatter by " + millimetres(doubt->found) + " at " + fixedText(doubt->range, 1) +
                 " m, where " + millimetres(doubt->told) +
                 " are told: planes may fall to pieces. Tell it (-P noise.range-constant=" +
                 fixedText(doubt->found, 4) + "), or let --preset precise find it (-P noise.estimated=true)");
}

Result<ExitCode> extract(const ExtractOptions& options)
{
    if (options.skipExisting && isDone(options))
        return ExitCode::Done;
    OutputFiles files{options.overwrite || options.skipExisting};
    files.protect(options.input);
    OutputPlan plan{files};
    for (const std::string& path : options.planes)
        plan.add(path, kPlanesSuffixes, "the planes", planesWriter);
    plan.add(options.segments, kSegmentsSuffixes, "the segments", segmentsWriter);
    plan.add(options.points, kPointsSuffixes, "the points", pointsWriter);
    plan.add(options.floorPlan, kFloorPlanSuffixes, "the floor plan", [&](std::string_view) {
        return floorPlanWriter(options.cutHeight, [](std::string_view text) { printWarning(std::string{text}); });
    });
    plan.add(options.report, kReportSuffixes, "the report", [&](std::string_view) {
        return reportWriter(std::filesystem::path{options.input}.filename().string(), options.cutHeight);
    });
    plan.add(options.labels, [](std::ostream& out, const ScanResults& r) { return writeLabels(out, r.labels); });
    Stats stats;
    plan.add(options.stats, [&stats](std::ostream& out, const ScanResults&) { return writeStats(out, stats); });
    if (!plan.problem())
        return tl::unexpected{plan.problem().error()};
    OutputFile* history = nullptr;
    if (!options.history.empty()) {
        const auto file = files.open(options.history);
        if (!file)
            return tl::unexpected{file.error()};
        history = *file;
    }

    Result<RecordingFile> input = readRecordingFile(options.input, chosenScan(options.scan));
    if (!input)
        return tl::unexpected{input.error()};
    ScanResults extraction;
    extraction.recording = std::move(input->recording);
    if (const auto kept = keepUntil(extraction.recording, options.until); !kept)
        return tl::unexpected{kept.error()};
    const auto parameters = parametersOverSteps(*input, extraction.recording.description.scanner, options.input,
                                                options.until, options.parameters);
    if (!parameters)
        return tl::unexpected{parameters.error()};
    extraction.parameters = parameters->back().parameters;
    correctRecording(extraction.recording, parameters->front().parameters.sensor);
    tellDoubtOfNoise(extraction.recording, parameters->front().parameters.noise, options.input);

    ExtractionPlan work{options.repeats, {}};
    if (history != nullptr) {
        const auto begun =
            history->write([&](std::ostream& out) { return writeHistoryHeader(out, parameters->front().parameters); });
        if (!begun)
            return tl::unexpected{begun.error()};
        work.onReport = [&](const StepReport& report) {
            return history->write(
                [&](std::ostream& out) { return writeHistoryLine(out, report, options.historyTimes); });
        };
    }
    auto result = runExtraction(extraction.recording, *parameters, work);
    if (!result)
        return tl::unexpected{result.error()};
    extraction.snapshot = result->snapshot;
    stats = result->stats;
    applyStoredEdits(extraction, *input, options.noEdits, options.input);
    if (!options.labels.empty() || !options.points.empty())
        addLabels(extraction);

    for (const PlannedOutput& output : plan.outputs()) {
        const auto written = output.file->write([&](std::ostream& out) { return output.writer(out, extraction); });
        if (!written)
            return tl::unexpected{written.error()};
    }
    const auto done = files.empty() ? print(planeTable(extraction.planes)) : files.publish();
    if (!done)
        return tl::unexpected{done.error()};
    return input->damaged ? ExitCode::Damaged : ExitCode::Done;
}

}  // namespace

void addExtractCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand("extract", "planes from a recording");
    auto options = std::make_shared<ExtractOptions>();
    command
        .add_option("INPUT", options->input,
                    "recording (.csv, .csv.gz or .pwscan), or cloud (.pcd, .ptx, .3d or a folder of these)")
        ->required();
    command
        .add_option("--planes", options->planes,
                    "planes as .csv, .json, .ply, .obj or .dxf, repeatable; without any output a table is printed")
        ->type_name("FILE")
        ->allow_extra_args(false);
    command.add_option("--segments", options->segments, "line segments as .csv or .ply")->type_name("FILE");
    command.add_option("--points", options->points, "points with their planes as .ply or .pcd")->type_name("FILE");
    command.add_option("--labels", options->labels, "plane of every beam, a line per slice")->type_name("FILE");
    command.add_option("--floor-plan", options->floorPlan, "plan of the room, seen from above, as .dxf")
        ->type_name("FILE");
    command.add_option("--report", options->report, "a page about the scan with plan and elevations, as .html")
        ->type_name("FILE");
    addNumber(command, "--cut-height", options->cutHeight, 0.0, 100.0,
              "height above the floor at which a plan is cut, in metres (default 1)");
    command.add_option("--history", options->history, "every decision of every step (NDJSON)")->type_name("FILE");
    command.add_flag("--history-times", options->historyTimes, "with the time of each phase in the history");
    command.add_option("--stats", options->stats, "counts and times (JSON)")->type_name("FILE");
    addScanOption(command, options->scan);
    command.add_flag("--no-edits", options->noEdits, "planes as they were found, without what was edited in a .pwscan");
    addWholeNumber(command, "--until", options->until, 0, kMaxStep,
                   "last step to use (counted from 0), as if the scan had ended there");
    addWholeNumber(command, "--repeat", options->repeats, 1, 10000, "runs; times are medians over them");
    command.add_flag("--skip-existing", options->skipExisting,
                     "do nothing where all outputs are there; where some are missing, write all");
    command.add_flag("--overwrite", options->overwrite, "replace output files that exist");
    addParameterOptions(command, options->parameters);
    command.callback([options, &chosen] { chosen = [options] { return extract(*options); }; });
}

}  // namespace planewright
