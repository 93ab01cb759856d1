// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/exports.h"

#include <filesystem>

#include <QBuffer>

#include "app/cli/output_file.h"
#include "app/files/file_kind.h"
#include "app/files/recording_file.h"
#include "app/window/screenshot.h"
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
        case ExportKind::PageOfScan:  // has a writer with pictures
        case ExportKind::PlanesFound:
            break;
    }
    return planesWriter(suffix);
}

std::string base64Of(const QImage& picture)
{
    QByteArray png;
    QBuffer file(&png);
    file.open(QIODevice::WriteOnly);
    picture.save(&file, "png");
    return png.toBase64().toStdString();
}

/// The view as it is, and from the usual corner.
std::vector<ReportPicture> picturesOf(WindowParts& parts)
{
    constexpr QSize kReportPicture(1040, 650);
    View3d& view = parts.window->view();
    std::vector<ReportPicture> pictures;
    pictures.push_back(
        {QObject::tr("As seen in the window").toStdString(), base64Of(takePicture(parts, kReportPicture, false))});
    const ViewCamera camera = view.camera();
    view.showNamed(NamedView::Iso);
    pictures.push_back(
        {QObject::tr("From above and behind").toStdString(), base64Of(takePicture(parts, kReportPicture, false))});
    view.setCamera(camera);
    return pictures;
}

ResultWriter pageWriter(WindowParts& parts)
{
    const std::string recording = parts.session.status().recording;
    const std::string title =
        recording.empty() ? parts.session.status().source : std::filesystem::path{recording}.filename().string();
    return reportWriter(title, kCutHeight, parts.session.map()->plannedSteps, picturesOf(parts));
}

/// What an export is made of, all of it shared or copied: the scan may go on meanwhile.
struct ScanAtThisMoment {
    std::shared_ptr<const SessionMap> map;
    ScanDescription description;
    Parameters parameters;
    std::vector<Edit> edits;
};

Recording recordingOf(const ScanDescription& description, const std::vector<SharedSlice>& slices)
{
    Recording recording;
    recording.description = description;
    recording.slices.reserve(slices.size());
    for (const SharedSlice& slice : slices)
        recording.slices.push_back(*slice);
    return recording;
}

ScanResults resultsOf(const ScanAtThisMoment& scan, bool withLabels)
{
    ScanResults results;
    results.recording = recordingOf(scan.description, scan.map->slices);
    results.parameters = scan.parameters;
    const EditedPlanes edited = applyEdits(*scan.map->snapshot, scan.edits, scan.description, scan.parameters);
    results.snapshot = std::make_shared<const Snapshot>(withPlanes(*scan.map->snapshot, edited));
    results.planes = planeResults(edited.planes, results.snapshot->segments);
    if (withLabels)
        addLabels(results);
    return results;
}

/// What a `.pwscan` holds of a scan that has no file yet.
ScanNotes notesOf(const WindowParts& parts)
{
    ScanNotes notes = parts.session.imported().value_or(ScanNotes{});
    if (notes.scan.name.empty())
        notes.scan.name = parts.session.status().source;
    notes.scan.state = ScanState::Complete;
    notes.events.push_back(parametersEvent(0, parts.session.parameters()));
    notes.edits = parts.edits.all();
    return notes;
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
        case ExportKind::PageOfScan:
            return kReportSuffixes;
        case ExportKind::PlanesFound:
            break;
    }
    return kPlanesSuffixes;
}

Result<std::function<Result<void>()>> exportOf(WindowParts& parts, ExportKind kind, const QString& file)
{
    if (!parts.session.map()->snapshot)
        return fail(ErrorCode::Usage, "There is no scan to export; open or take one first.");
    const std::string path = file.toStdString();
    const auto suffix = suffixOf(path, suffixesOf(kind), "the export");
    if (!suffix)
        return tl::unexpected{suffix.error()};
    ScanAtThisMoment scan{parts.session.map(), parts.session.description(), parts.session.parameters(),
                          parts.edits.inForce()};
    ResultWriter writer = kind == ExportKind::PageOfScan ? pageWriter(parts) : writerOf(kind, *suffix);
    return [scan = std::move(scan), writer = std::move(writer), kind, path] {
        const ScanResults results = resultsOf(scan, kind == ExportKind::ScanPoints);
        return OutputFile::writeWhole(path, true, [&](std::ostream& out) { return writer(out, results); });
    };
}

Result<std::function<Result<void>()>> copyOf(WindowParts& parts, const QString& file)
{
    if (!parts.session.map()->snapshot)
        return fail(ErrorCode::Usage, "There is no scan to copy; open or take one first.");
    const std::string path = file.toStdString();
    const auto suffix = checkRecordingTarget(path);
    if (!suffix)
        return tl::unexpected{suffix.error()};
    const auto write = [path, suffix = *suffix](const Recording& recording, const std::optional<ScanNotes>& notes) {
        return OutputFile::writeWhole(path, true,
                                      [&](std::ostream& out) { return writeRecording(out, recording, suffix, notes); });
    };
    // All that the file holds goes with it: events, and what became of the scan.
    if (const PwscanProject* project = parts.session.project())
        return [write, source = project->path(), scan = parts.session.scanInProject()]() -> Result<void> {
            const auto read = loadRecordingFile(source, {scan, true});
            return read ? write(read->recording, read->notes) : tl::unexpected{read.error()};
        };
    return [write, description = parts.session.measuredDescription(), slices = parts.session.measuredSlices(),
            notes = notesOf(parts)] { return write(recordingOf(description, slices), notes); };
}

}  // namespace planewright
