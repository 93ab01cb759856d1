// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/mapping/stop_inputs.h"

#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "app/files/cloud_file.h"
#include "app/files/file_kind.h"
#include "app/files/input_file.h"
#include "core/formats/planes_json.h"
#include "core/formats/recording_pwscan.h"
#include "core/geometry/correct_recording.h"
#include "core/pipeline/apply_edits.h"
#include "core/pipeline/plane_extractor.h"

namespace planewright {

namespace {

constexpr std::array<std::string_view, 7> kStopSuffixes{".csv", ".csv.gz", ".pwscan", ".pcd", ".ptx", ".3d", ".json"};

/// A scan of a cloud tells its pose when it is read.
Result<std::vector<StopInput>> cloudsAsStops(const std::string& path)
{
    const auto scans = scansOfRecordingFile(path);
    if (!scans)
        return tl::unexpected{scans.error()};
    std::vector<StopInput> inputs;
    for (const RecordingChoice& choice : *scans)
        inputs.push_back({path, choice, choice.scan ? path + ", scan " + std::to_string(*choice.scan) : path, 0, {}});
    return inputs;
}

Result<std::vector<StopInput>> scansAsStops(const std::string& path)
{
    if (isCloudFile(path))
        return cloudsAsStops(path);
    const auto input = openInput(path);
    if (!input)
        return tl::unexpected{input.error()};
    if (!suffixOf(path, {kPwscanSuffix}, ""))
        return std::vector<StopInput>{{path, {}, path, 0, {}}};
    const auto scans = scansOfPwscan(path);
    if (!scans)
        return tl::unexpected{scans.error()};
    std::vector<StopInput> inputs;
    for (const ScanRecord& scan : *scans)
        inputs.push_back({path, {scan.id, false}, path + ", scan " + std::to_string(scan.id), scan.floor, scan.pose});
    return inputs;
}

Result<std::shared_ptr<const Snapshot>> snapshotOf(const Recording& recording,
                                                   std::span<const ParametersFrom> parameters,
                                                   const std::stop_token& stop)
{
    PlaneExtractor extractor(sensorOf(recording.description), parameters.front().parameters);
    std::span<const ParametersFrom> later = parameters.subspan(1);
    for (const ScanSlice& slice : recording.slices) {
        if (stop.stop_requested())
            return fail(ErrorCode::Interrupted, "extracting the stops was cancelled");
        for (; !later.empty() && later.front().step <= slice.step; later = later.subspan(1))
            extractor.setParameters(later.front().parameters);
        extractor.advance(slice);
    }
    for (; !later.empty(); later = later.subspan(1))
        extractor.setParameters(later.front().parameters);
    return extractor.finish();
}

}  // namespace

bool isPlanesResult(const std::string& path)
{
    return suffixOf(path, {".json"}, "").has_value();
}

Result<std::vector<StopInput>> stopInputs(const std::vector<std::string>& paths)
{
    for (const std::string& path : paths) {
        if (const auto known = suffixOf(path, kStopSuffixes, "a stop"); !known && !isCloudFile(path))
            return tl::unexpected{known.error()};
    }
    std::vector<StopInput> inputs;
    for (const std::string& path : paths) {
        if (isPlanesResult(path)) {
            inputs.push_back({path, {}, path, 0, {}});
            continue;
        }
        const auto scans = scansAsStops(path);
        if (!scans)
            return tl::unexpected{scans.error()};
        inputs.insert(inputs.end(), scans->begin(), scans->end());
    }
    return inputs;
}

Result<ReadStop> readStop(const StopInput& input, const ChooseParameters& chooseParameters,
                          const MappingParameters& mapping, bool noEdits, const std::stop_token& stop)
{
    ReadStop read;
    read.scan = {input.name, input.path, input.choice.scan.value_or(0), input.floor, input.odometry, {}};
    if (isPlanesResult(input.path)) {
        const auto file = openInput(input.path);
        if (!file)
            return tl::unexpected{file.error()};
        auto planes = readPlaneResultsJson(**file, input.path);
        if (!planes)
            return tl::unexpected{planes.error()};
        read.scan.planes = std::move(*planes);
        return read;
    }
    auto file = loadRecordingFile(input.path, input.choice, stop);
    if (!file)
        return tl::unexpected{file.error()};
    if (isCloudFile(input.path) && file->notes)
        read.scan.odometry = file->notes->scan.pose;
    read.damaged = file->damaged;
    read.warnings = file->warnings;
    auto parameters = chooseParameters(*file, input.path);
    if (!parameters)
        return tl::unexpected{parameters.error()};
    read.parameters = parameters->back().parameters;
    for (ParametersFrom& each : *parameters)
        each.parameters = forMap(each.parameters, mapping);
    Recording& recording = file->recording;
    correctRecording(recording, parameters->front().parameters.sensor);
    const auto snapshot = snapshotOf(recording, *parameters, stop);
    if (!snapshot)
        return tl::unexpected{snapshot.error()};
    const auto edits = file->notes && !noEdits ? editsInForce(file->notes->edits) : std::vector<Edit>{};
    const EditedPlanes edited = applyEdits(**snapshot, edits, recording.description, *read.parameters);
    for (const std::string& problem : edited.problems)
        read.warnings.push_back(input.name + ": " + problem);
    const Snapshot result = withPlanes(**snapshot, edited);
    read.scan.planes = planeResults(edited.planes, result.segments);
    return read;
}

}  // namespace planewright
