// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/calibrate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/json_text.h"
#include "app/cli/output_files.h"
#include "app/cli/parameter_options.h"
#include "app/cli/recording_file.h"
#include "app/cli/text.h"
#include "core/formats/preset_file.h"
#include "core/types/angle_text.h"

namespace planewright {

namespace {

struct CalibrateOptions {
    std::vector<std::string> inputs;
    std::string output;
    std::string level{"auto"};
    bool json = false;
    bool overwrite = false;
    ParameterOptions parameters;
};

/// What the sensor file sets: all that --sensor is for.
constexpr std::array<std::string_view, 10> kSensorKeys{
    "noise.range-constant", "noise.range-proportional",   "noise.bearing",       "noise.pitch",
    "noise.systematic",     "sensor.pitch-zero",          "sensor.range-offset", "sensor.sweep-turn",
    "sensor.pitch-delay",   "sensor.lever-arm-correction"};

/// A quantity in the unit that people see.
struct Finding {
    std::string_view name;
    bool observed = false;
    double value = 0.0;
    double sigma = 0.0;
    std::string_view unit;
    std::string note;  ///< what was assumed, or why it is not observable and what scan would make it so
};

std::string_view nameOf(ScannerError error)
{
    constexpr std::array<std::string_view, kScannerErrors> kNames{"range_offset", "lever_arm_correction", "sweep_turn",
                                                                  "pitch_delay"};
    return kNames[static_cast<std::size_t>(error)];
}

std::string_view unitOf(ScannerError error)
{
    return error == ScannerError::RangeOffset || error == ScannerError::LeverArm ? "m" : "steps";
}

/// So many digits that the uncertainty has two.
int digitsFor(double sigma)
{
    return sigma > 0.0 && std::isfinite(sigma) ? std::clamp(1 - static_cast<int>(std::floor(std::log10(sigma))), 0, 6)
                                               : 3;
}

/// What kind of scan would tell an error.
std::string adviceFor(ScannerError error)
{
    switch (error) {
        case ScannerError::RangeOffset:
            return "scan walls that are seen head-on and at a slant";
        case ScannerError::LeverArm:
            return "scan floor, walls and ceiling over as much pitch as the scanner can";
        case ScannerError::SweepTurn:
            return "scan while the head nods on, with walls on both sides";
        case ScannerError::PitchDelay:
            return "scan while the head nods both ways";
    }
    return {};
}

std::string whyNot(ScannerError error, const CalibratedError& found, bool nodsBothWays)
{
    std::string why = "not observable: ";
    if (!found.tangled.empty()) {
        std::string others;
        for (const ScannerError other : found.tangled)
            others += (others.empty() ? "" : " and ") + std::string{nameOf(other)};
        why += "these planes cannot tell it from " + others;
    } else if (error == ScannerError::PitchDelay && !nodsBothWays) {
        why += "the head nods one way, where a delay is a part of pitch_zero";
    } else if (std::isfinite(found.sigma) && found.sigma < 1.0) {
        why += "known to " + fixedText(found.sigma, digitsFor(found.sigma)) + " " + std::string{unitOf(error)} +
               " at best";
    } else {
        why += "no plane tells of it";
    }
    return why + "; " + adviceFor(error);
}

std::string planesText(const Calibration& calibration)
{
    int level = 0;
    int plumb = 0;
    for (const CalibratedScan& scan : calibration.scans) {
        level += scan.usedAsLevel ? scan.levelPlanes : 0;
        plumb += scan.usedAsLevel ? scan.plumbPlanes : 0;
    }
    return std::to_string(level) + " planes taken as level and " + std::to_string(plumb) + " as plumb";
}

Finding pitchZeroOf(const Calibration& calibration, const std::string& level)
{
    Finding finding{"pitch_zero",
                    calibration.pitchZeroObserved,
                    toDegrees(calibration.pitchZero),
                    toDegrees(calibration.pitchZeroSigma),
                    "deg",
                    {}};
    const auto leaning = std::find_if(calibration.scans.begin(), calibration.scans.end(),
                                      [](const CalibratedScan& scan) { return scan.levelFound && !scan.usedAsLevel; });
    if (finding.observed)
        finding.note = "if the scanner stood level: " + planesText(calibration);
    else if (level == "never")
        finding.note = "not estimated: --level never";
    else if (leaning != calibration.scans.end())
        finding.note = "not observable: the pitch axis leans by " + fixedText(toDegrees(leaning->roll), 1) +
                       " deg, the scanner did not stand level; level it and scan again, or give --level always";
    else
        finding.note = "not observable: no floor, ceiling or wall ahead tells what is level; scan a room with them";
    return finding;
}

std::vector<Finding> findingsOf(const Calibration& calibration, const CalibrateOptions& options)
{
    std::vector<Finding> findings{pitchZeroOf(calibration, options.level)};
    for (int i = 0; i < kScannerErrors; ++i) {
        const auto error = static_cast<ScannerError>(i);
        const CalibratedError& found = calibration.errors[static_cast<std::size_t>(i)];
        findings.push_back({nameOf(error), found.observed, found.value, found.sigma, unitOf(error),
                            found.observed ? "" : whyNot(error, found, calibration.nodsBothWays)});
    }
    return findings;
}

std::string asText(const std::vector<Finding>& findings, const Calibration& calibration,
                   const std::vector<std::string>& inputs)
{
    std::vector<std::vector<std::string>> rows{{"quantity", "value", "sigma", "unit", "note"}};
    for (const Finding& finding : findings) {
        const int digits = digitsFor(finding.sigma);
        rows.push_back({std::string{finding.name}, finding.observed ? fixedText(finding.value, digits) : "-",
                        finding.observed ? fixedText(finding.sigma, digits) : "-", std::string{finding.unit},
                        finding.note});
    }
    std::vector<std::vector<std::string>> scans{{"scan", "planes", "returns", "level", "plumb", "pitch_zero", "roll"}};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const CalibratedScan& scan = calibration.scans[i];
        const auto angle = [&](double value, double sigma) {
            const int digits = digitsFor(toDegrees(sigma));
            return scan.levelFound ? fixedText(toDegrees(value), digits) + " +- " + fixedText(toDegrees(sigma), digits)
                                   : std::string{"-"};
        };
        scans.push_back({inputs[i], std::to_string(scan.planes), std::to_string(scan.points),
                         std::to_string(scan.levelPlanes), std::to_string(scan.plumbPlanes),
                         angle(scan.pitchZero, scan.pitchZeroSigma), angle(scan.roll, scan.rollSigma)});
    }
    return tableText(rows) + "\n" + tableText(scans);
}

Json asJson(const std::vector<Finding>& findings, const Calibration& calibration,
            const std::vector<std::string>& inputs)
{
    Json json;
    for (const Finding& finding : findings) {
        Json one{{"observed", finding.observed}};
        one["value"] = finding.observed ? Json(rounded(finding.value)) : Json();
        one["sigma"] = finding.observed ? Json(rounded(finding.sigma)) : Json();
        one["unit"] = finding.unit;
        one["note"] = finding.note;
        json[std::string{finding.name}] = std::move(one);
    }
    json["disagreement"] = rounded(calibration.disagreement);
    json["pitch_noise_deg"] = rounded(toDegrees(calibration.pitchNoise));
    Json scans = Json::array();
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const CalibratedScan& scan = calibration.scans[i];
        const auto angle = [&](double value) { return scan.levelFound ? Json(rounded(toDegrees(value))) : Json(); };
        scans.push_back({{"scan", inputs[i]},
                         {"planes", scan.planes},
                         {"returns", scan.points},
                         {"level", scan.levelPlanes},
                         {"plumb", scan.plumbPlanes},
                         {"used_as_level", scan.usedAsLevel},
                         {"pitch_zero_deg", angle(scan.pitchZero)},
                         {"pitch_zero_sigma_deg", angle(scan.pitchZeroSigma)},
                         {"roll_deg", angle(scan.roll)},
                         {"roll_sigma_deg", angle(scan.rollSigma)}});
    }
    json["scans"] = std::move(scans);
    return json;
}

LevelUse levelUseOf(const std::string& word)
{
    return word == "always" ? LevelUse::Always : word == "never" ? LevelUse::Never : LevelUse::Auto;
}

Result<ExitCode> runCalibration(const CalibrateOptions& options)
{
    OutputFiles files{options.overwrite};
    for (const std::string& input : options.inputs)
        files.protect(input);
    OutputFile* output = nullptr;
    if (!options.output.empty()) {
        const auto file = files.open(options.output);
        if (!file)
            return tl::unexpected{file.error()};
        output = *file;
    }
    if (const auto known = checkRecordingNames(options.inputs); !known)
        return tl::unexpected{known.error()};
    std::vector<Recording> recordings;
    bool damaged = false;
    for (const std::string& input : options.inputs) {
        Result<RecordingFile> read = readRecordingFile(input);
        if (!read)
            return tl::unexpected{read.error()};
        if (read->recording.description.beamTable || read->recording.description.isTurned())
            return fail(ErrorCode::Usage, input +
                                              ": this is an imported cloud, whose scanner was recovered from its "
                                              "points; calibrate with recordings of a nodding scanner");
        damaged = damaged || read->damaged;
        recordings.push_back(std::move(read->recording));
        if (recordings.back().description.scanner != recordings.front().description.scanner)
            return fail(ErrorCode::Usage, input + ": its scanner '" + recordings.back().description.scanner +
                                              "' is not the '" + recordings.front().description.scanner + "' of " +
                                              options.inputs.front() +
                                              ". Errors are those of one scanner: calibrate each with its own scans.");
    }
    Result<Parameters> parameters = parametersInForce(options.parameters, recordings.front().description.scanner);
    if (!parameters)
        return tl::unexpected{parameters.error()};

    const auto calibration = calibrate(recordings, *parameters, {levelUseOf(options.level), degrees(0.1)});
    if (!calibration)
        return fail(calibration.error().code, joined(options.inputs) + ": " + calibration.error().message);
    for (std::size_t i = 0; i < options.inputs.size(); ++i) {
        if (calibration->scans[i].planes == 0)
            printWarning(options.inputs[i] + ": no plane is seen well enough; this scan tells nothing");
    }

    if (output != nullptr) {
        parameters->sensor = calibration->sensor;
        Result<void> written =
            output->write([&](std::ostream& out) { return writePresetFile(out, *parameters, kSensorKeys); });
        if (written)
            written = files.publish();
        if (!written)
            return tl::unexpected{written.error()};
    }
    const std::vector<Finding> findings = findingsOf(*calibration, options);
    const auto printed = print(options.json ? jsonText(asJson(findings, *calibration, options.inputs))
                                            : asText(findings, *calibration, options.inputs));
    if (!printed)
        return tl::unexpected{printed.error()};
    return damaged ? ExitCode::Damaged : ExitCode::Done;
}

}  // namespace

void addCalibrateCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand(
        "calibrate", "pitch zero, range offset, lever arm and timing of a scanner, from the planes of its own scans");
    auto options = std::make_shared<CalibrateOptions>();
    command.add_option("INPUT", options->inputs, "recordings of one scanner (.csv, .csv.gz or .pwscan)")->required();
    command.add_option("-o", options->output, "sensor file to write, for --sensor of every command")->type_name("FILE");
    command
        .add_option("--level", options->level,
                    "pitch zero from floors and walls: of scans whose pitch axis is level (auto), always or never")
        ->check(CLI::IsMember({"auto", "always", "never"}))
        ->capture_default_str();
    command.add_flag("--json", options->json, "as JSON");
    command.add_flag("--overwrite", options->overwrite, "replace a sensor file that exists");
    addParameterOptions(command, options->parameters);
    command.callback([options, &chosen] { chosen = [options] { return runCalibration(*options); }; });
}

}  // namespace planewright
