// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <atomic>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/number_option.h"
#include "app/cli/parameter_options.h"
#include "app/cli/plane_table.h"
#include "app/cli/progress.h"
#include "app/cli/scan_setup_options.h"
#include "app/cli/signal_watch.h"
#include "app/files/file_kind.h"
#include "app/files/recording_file.h"
#include "app/session/loops/pwscan_recorder.h"
#include "app/session/loops/scan_pipeline.h"
#include "app/sources/open_source.h"
#include "app/sources/scan_size.h"
#include "core/formats/recorded_slice.h"
#include "core/formats/recording_csv.h"
#include "core/types/angle_text.h"
#include "core/types/count_text.h"

namespace planewright {

namespace {

constexpr std::chrono::milliseconds kLookEvery{50};

struct RecordOptions {
    std::string scanner;
    ScanSetupOptions setup;
    std::string output;
    bool append = false;
    bool home = false;
    bool extract = false;
    int retries = 3;  ///< in a row, after a link has failed
    ParameterOptions parameters;
};

/// What happened on the threads of a scan, for the one that waits for it.
struct ScanNews {
    std::atomic<bool> isOver{false};
    // Each of one thread; read when the threads have ended.
    std::optional<Error> failure;  ///< of the source
    std::optional<Error> notExtracted;
    std::optional<Error> notClosed;  ///< of the recording
    ScanOutcome outcome = ScanOutcome::Complete;
};

Result<OpenedSource> openScanner(const RecordOptions& options, const std::stop_token& stop)
{
    const auto address = parseSourceAddress(options.scanner);
    if (!address)
        return fail(address.error().code, "--scanner: " + address.error().message);
    if (address->kind == SourceAddress::Kind::File)
        return fail(ErrorCode::Usage, "--scanner: '" + options.scanner +
                                          "' is no scanner; give usb:, tcp:HOST:PORT or sim:SCENE, or replay:" +
                                          options.scanner + " to record it once more");
    const auto setup = sourceSetupOf(options.setup, address->kind);
    if (!setup)
        return tl::unexpected{setup.error()};
    return openSource(*address, *setup, steadyClock(), stop);
}

Result<Parameters> parametersOf(const RecordOptions& options, const std::string& scanner)
{
    if (options.extract)
        return parametersInForce(options.parameters, scanner);
    if (!options.parameters.preset.empty() || !options.parameters.sensor.empty() ||
        !options.parameters.assignments.empty())
        return fail(ErrorCode::Usage, "--preset, --sensor and -P say how planes are extracted; give --extract, too");
    return Parameters{};
}

/// The recording, begun: whether there can be one shows before anything moves.
Result<std::unique_ptr<SliceRecorder>> beginRecording(const RecordOptions& options, const ScanSource& source)
{
    if (const auto suffix = suffixOf(options.output, {kPwscanSuffix}, "a recording that is taken now"); !suffix)
        return tl::unexpected{suffix.error()};
    std::error_code error;
    const bool isThere = std::filesystem::exists(options.output, error);
    if (isThere && !options.append)
        return fail(ErrorCode::NotWritten,
                    options.output + ": the file exists; give another name, or --append to add the scan to it");
    if (!isThere) {
        if (const auto target = checkRecordingTarget(options.output); !target)
            return tl::unexpected{target.error()};
    }
    auto recorder = std::make_unique<PwscanRecorder>(
        options.output, isThere ? PwscanRecorder::Target::Append : PwscanRecorder::Target::NewFile, source.name());
    const auto begun = recorder->begin(source.isLive() ? asRecorded(source.description()) : source.description(),
                                       source.plannedSlices());
    if (!begun)
        return tl::unexpected{begun.error()};
    return recorder;
}

/// Opens on a thread of its own, since a device may be waited for: a signal ends that.
Result<OpenedSource> openWatched(const RecordOptions& options, const SignalWatch& signals)
{
    std::optional<Result<OpenedSource>> opened;
    std::atomic<bool> isDone{false};
    {
        std::jthread opening([&](const std::stop_token& stop) {
            opened = openScanner(options, stop);
            isDone = true;
        });
        while (!isDone) {
            if (signals.wait(kLookEvery))
                opening.request_stop();
        }
    }
    return std::move(*opened);
}

/// Brings the head to level, on a thread of its own: a signal holds it at once. Gives the signal. Errors: those of
/// the devices.
Result<std::optional<int>> bringHome(ScanSource& source, const SignalWatch& signals)
{
    Result<std::optional<double>> home = std::nullopt;
    std::optional<int> interrupted;
    std::atomic<bool> isDone{false};
    {
        std::jthread going([&](const std::stop_token& stop) {
            home = source.goHome(stop);
            isDone = true;
        });
        while (!isDone) {
            if (const std::optional<int> signal = signals.wait(kLookEvery); signal && !interrupted) {
                interrupted = signal;
                [[maybe_unused]] const Result<void> stopped = source.stopMotion();
                going.request_stop();
            }
        }
    }
    if (interrupted)
        return interrupted;
    if (!home)
        return tl::unexpected{home.error()};
    if (*home)
        printNote("the head is at " + degreesText(**home, 1));
    return std::nullopt;
}

/// A line about a fault, with the first bytes that came.
std::string noteOf(FaultRecord record)
{
    constexpr std::size_t kMostShown = 3 * 16 - 1;  // 16 bytes, with a blank between two
    if (record.bytes.size() > kMostShown)
        record.bytes = record.bytes.substr(0, kMostShown) + " …";
    return recordText(record);
}

ScanEvents eventsFor(ScanNews& news, ScanPipeline*& pipeline)
{
    ScanEvents events;
    events.acquisition.onBegun = [] {};
    events.acquisition.onFault = [&news, &pipeline](const Error& error) {
        news.failure = error;
        // What is not found when the scan is to go on was there when it began.
        if (error.code == ErrorCode::NoDevice)
            news.failure->code = ErrorCode::DeviceLost;
        pipeline->giveUp();
    };
    events.acquisition.onRecovering = [](const Error& error, std::chrono::milliseconds wait) {
        printWarning(error.message + "; trying to go on in " + std::to_string(wait.count()) + " ms");
    };
    events.acquisition.onRecords = [](const std::vector<FaultRecord>& records, const Error* fault) {
        for (const FaultRecord& record : records) {
            // What the fault says itself is not said twice.
            if (fault == nullptr || fault->message.find(record.text) == std::string::npos)
                printNote(noteOf(record));
        }
    };
    events.acquisition.onEnded = [&news](ScanOutcome outcome) { news.outcome = outcome; };
    events.recording.onTrouble = [](const Error& error) {
        printWarning(error.message + "; slices are kept in memory, and writing is tried again every second");
    };
    events.recording.onRecovered = [] { printWarning("all slices are on the disk again"); };
    events.recording.onClosed = [&](const Result<void>& closed) {
        if (!closed)
            news.notClosed = closed.error();
    };
    events.onNews = [] {};
    events.onExtractionFailed = [&](const Error& error) { news.notExtracted = error; };
    return events;
}

/// What the program ends with: slices that are on no disk count more than a device that is gone. The others are told.
std::optional<Error> worstOf(const ScanNews& news)
{
    std::optional<Error> worst;
    for (const std::optional<Error>& trouble : {news.failure, news.notExtracted, news.notClosed}) {
        if (!trouble)
            continue;
        if (worst)
            printError(worst->message);
        worst = trouble;
    }
    return worst;
}

/// Waits for the scan to be over; a signal ends it in order, a second one in a hurry. Gives the first.
std::optional<int> waitFor(ScanPipeline& pipeline, const ScanNews& news, const SignalWatch& signals, int planned)
{
    Progress progress("recording, slice");
    std::optional<int> interrupted;
    while (!news.isOver) {
        if (const std::optional<int> signal = signals.wait(kLookEvery)) {
            if (interrupted) {
                pipeline.abandon();
            } else {
                interrupted = signal;
                pipeline.finish();
                [[maybe_unused]] const Result<void> stopped = pipeline.stopMotion();
            }
        }
        progress.show(static_cast<std::size_t>(pipeline.status().acquired), static_cast<std::size_t>(planned));
    }
    return interrupted;
}

Result<ExitCode> record(const RecordOptions& options)
{
    const SignalWatch signals;
    Result<OpenedSource> opened = openWatched(options, signals);
    if (!opened)
        return tl::unexpected{opened.error()};
    for (const std::string& warning : opened->warnings)
        printWarning(warning);
    if (options.home && opened->source->health().empty())
        return fail(ErrorCode::Usage, "--home: " + opened->source->name() + " has no head that moves; leave it out");
    const auto parameters = parametersOf(options, opened->source->description().scanner);
    if (!parameters)
        return tl::unexpected{parameters.error()};
    auto recorder = beginRecording(options, *opened->source);
    if (!recorder)
        return tl::unexpected{recorder.error()};

    if (opened->plan)
        printNote(scanSizeText(*opened->plan, opened->source->plannedSlices().value_or(0)));

    // Whoever starts a scan has seen to the head.
    opened->source->release();
    if (options.home) {
        const auto signal = bringHome(*opened->source, signals);
        if (!signal || *signal) {
            if (const Result<void> closed = (*recorder)->close(ScanOutcome::Partial); !closed)
                printWarning(closed.error().message);
            return signal.map([](const std::optional<int>& caught) { return static_cast<ExitCode>(128 + *caught); });
        }
    }
    ScanNews news;
    ScanPipeline* running = nullptr;
    ScanPipeline pipeline{{opened->source,
                           std::move(*recorder),
                           {{0, *parameters}},
                           false,
                           options.extract,
                           {options.retries, std::numeric_limits<int>::max()}},
                          eventsFor(news, running),
                          steadyClock()};
    running = &pipeline;
    std::optional<int> interrupted;
    {
        std::vector<std::jthread> threads;
        std::atomic<int> left{3};
        for (auto& loop : pipeline.loops()) {
            threads.emplace_back([&news, &left, run = std::move(loop)] {
                run();
                if (--left == 0)
                    news.isOver = true;
            });
        }
        interrupted = waitFor(pipeline, news, signals, opened->source->plannedSlices().value_or(0));
    }

    if (pipeline.status().acquired == 0 && !news.notClosed)
        printWarning(options.output + ": no slice has come; nothing is left of this scan");
    if (const auto trouble = worstOf(news))
        return tl::unexpected{*trouble};
    const bool isPartial = news.outcome == ScanOutcome::Partial && !interrupted;
    if (isPartial) {
        const int lost = pipeline.status().lost;
        printWarning(options.output + ": " + countText(lost, "slice") + " of the plan " + (lost == 1 ? "is" : "are") +
                     " missing; the scan is marked as partial");
    }
    if (options.extract) {
        const auto steps = pipeline.take();
        const auto printed = steps.empty() ? Result<void>{} : print(planeTable(planeResults(*steps.back().snapshot)));
        if (!printed)
            return tl::unexpected{printed.error()};
    }
    if (interrupted)
        return static_cast<ExitCode>(128 + *interrupted);
    return isPartial ? ExitCode::Damaged : ExitCode::Done;
}

}  // namespace

void addRecordCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand("record", "a recording of what a scanner sees now");
    command.footer(
        "Exit codes (what was recorded is valid with each of them):\n"
        "  0  every slice of the plan is recorded\n"
        "  4  some are missing; the scan is marked as partial\n"
        "  5  slices could not be written\n"
        "  6  a device is not there, or may not be used\n"
        "  7  a device was lost\n"
        "  10  a device waits for a person\n"
        "  130  interrupted");
    auto options = std::make_shared<RecordOptions>();
    command
        .add_option("--scanner", options->scanner,
                    "a laser: usb:SERIAL, tcp:HOST:PORT, serial:PATH or dialogue:FILE; or sim:SCENE?seed=N&speed=X or "
                    "replay:FILE?speed=X, "
                    "where speed 1 is real time, 0 as fast as possible")
        ->type_name("ADDRESS")
        ->required();
    addScanSetupOptions(command, options->setup);
    addWholeNumber(command, "--retries", options->retries, 0, 100,
                   "how often in a row, without a slice between, the scan goes on by itself at the missing slice after "
                   "a link to a "
                   "device has failed; never after an emergency stop, an alarm or where something blocks the head "
                   "(default 3, 0 for "
                   "none)");
    command.add_option("-o", options->output, "recording to write (.pwscan)")->type_name("FILE")->required();
    command.add_flag("--append", options->append, "add the scan to a recording that is there");
    command.add_flag("--home", options->home, "bring the head to level first, slowly; Ctrl-C holds it at once");
    command.add_flag("--extract", options->extract, "extract planes meanwhile, and print them at the end");
    addParameterOptions(command, options->parameters);
    command.callback([options, &chosen] { chosen = [options] { return record(*options); }; });
}

}  // namespace planewright
