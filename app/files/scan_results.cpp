// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/files/scan_results.h"

#include <utility>

#include "core/formats/planes_csv.h"
#include "core/formats/planes_dxf.h"
#include "core/formats/planes_json.h"
#include "core/formats/planes_mesh.h"
#include "core/formats/points_files.h"
#include "core/formats/segments_files.h"
#include "core/pipeline/complete_labels.h"

namespace planewright {

void addLabels(ScanResults& results)
{
    results.labels = labelsOf(*results.snapshot, results.recording);
    completeLabels(results.labels, *results.snapshot, results.recording, results.parameters);
}

ResultWriter planesWriter(std::string_view suffix)
{
    if (suffix == ".json")
        return [](std::ostream& out, const ScanResults& r) {
            return writePlanesJson(out, r.planes, r.parameters, "planewright " PLANEWRIGHT_VERSION);
        };
    if (suffix == ".ply")
        return [](std::ostream& out, const ScanResults& r) { return writePlanesPly(out, r.planes); };
    if (suffix == ".obj")
        return [](std::ostream& out, const ScanResults& r) { return writePlanesObj(out, r.planes); };
    if (suffix == ".dxf")
        return [](std::ostream& out, const ScanResults& r) { return writePlanesDxf(out, r.planes); };
    return [](std::ostream& out, const ScanResults& r) { return writePlanesCsv(out, r.planes); };
}

ResultWriter segmentsWriter(std::string_view suffix)
{
    if (suffix == ".ply")
        return [](std::ostream& out, const ScanResults& r) { return writeSegmentsPly(out, *r.snapshot); };
    return [](std::ostream& out, const ScanResults& r) { return writeSegmentsCsv(out, *r.snapshot); };
}

ResultWriter pointsWriter(std::string_view suffix)
{
    if (suffix == ".pcd")
        return [](std::ostream& out, const ScanResults& r) { return writePointsPcd(out, r.recording, r.labels); };
    return [](std::ostream& out, const ScanResults& r) { return writePointsPly(out, r.recording, r.labels); };
}

ResultWriter floorPlanWriter(double cutHeight, std::function<void(std::string_view)> warn)
{
    return [cutHeight, warn = std::move(warn)](std::ostream& out, const ScanResults& r) {
        const auto floor = floorHeight(r.planes);
        if (!floor)
            warn("no floor is found; the plan is cut at the height of the pitch axis");
        return writeFloorPlanDxf(out, r.planes, floor ? *floor + cutHeight : 0.0);
    };
}

ResultWriter reportWriter(std::string title, double cutHeight, int plannedSteps, std::vector<ReportPicture> pictures)
{
    return [title = std::move(title), cutHeight, plannedSteps, pictures = std::move(pictures)](std::ostream& out,
                                                                                               const ScanResults& r) {
        const double floor = floorHeight(r.planes).value_or(-cutHeight);
        return writeScanReport(out, {title, "planewright " PLANEWRIGHT_VERSION, r.recording, *r.snapshot, r.planes,
                                     r.parameters, plannedSteps, floor + cutHeight, pictures});
    };
}

}  // namespace planewright
