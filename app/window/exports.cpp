// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/exports.h"

#include "app/cli/output_file.h"
#include "app/files/file_kind.h"
#include "core/pipeline/apply_edits.h"

namespace planewright {

namespace {

constexpr double kCutHeight = 1.0;  // above the floor [m]

ResultWriter writerOf(ExportKind kind, std::string_view suffix)
{
    switch (kind) {
        case ExportKind::ScanPoints:
            return pointsWriter(suffix);
        case ExportKind::LineSegments:
            return segmentsWriter(suffix);
        case ExportKind::FloorPlan:
            return floorPlanWriter(kCutHeight, [](std::string_view) {});
        case ExportKind::PlanesFound:
            break;
    }
    return planesWriter(suffix);
}

ScanResults resultsOf(const WindowParts& parts, bool withLabels)
{
    const SessionMap& map = *parts.session.map();
    ScanResults results;
    results.recording.description = parts.session.description();
    results.recording.slices.reserve(map.slices.size());
    for (const SharedSlice& slice : map.slices)
        results.recording.slices.push_back(*slice);
    results.parameters = parts.session.parameters();
    const EditedPlanes edited =
        applyEdits(*map.snapshot, parts.edits.inForce(), results.recording.description, results.parameters);
    results.snapshot = std::make_shared<const Snapshot>(withPlanes(*map.snapshot, edited));
    results.planes = planeResults(edited.planes, results.snapshot->segments);
    if (withLabels)
        addLabels(results);
    return results;
}

}  // namespace

std::span<const std::string_view> suffixesOf(ExportKind kind)
{
    switch (kind) {
        case ExportKind::ScanPoints:
            return kPointsSuffixes;
        case ExportKind::LineSegments:
            return kSegmentsSuffixes;
        case ExportKind::FloorPlan:
            return kFloorPlanSuffixes;
        case ExportKind::PlanesFound:
            break;
    }
    return kPlanesSuffixes;
}

Result<void> exportScan(const WindowParts& parts, ExportKind kind, const QString& file)
{
    if (!parts.session.map()->snapshot)
        return fail(ErrorCode::Usage, "There is no scan to export; open or take one first.");
    const std::string path = file.toStdString();
    const auto suffix = suffixOf(path, suffixesOf(kind), "the export");
    if (!suffix)
        return tl::unexpected{suffix.error()};
    const ScanResults results = resultsOf(parts, kind == ExportKind::ScanPoints);
    const ResultWriter writer = writerOf(kind, *suffix);
    return OutputFile::writeWhole(path, true, [&](std::ostream& out) { return writer(out, results); });
}

}  // namespace planewright
