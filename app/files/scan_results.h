// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <functional>
#include <memory>
#include <ostream>
#include <string_view>
#include <vector>

#include "core/formats/labels.h"
#include "core/formats/plane_result.h"
#include "core/formats/scan_report.h"
#include "core/params/parameters.h"
#include "core/types/error.h"
#include "core/types/recording.h"
#include "core/types/snapshot.h"

namespace planewright {

/// All that results of a scan are written from, by whatever program.
struct ScanResults {
    Recording recording;  ///< corrected as the planes were found in it
    Parameters parameters;
    std::shared_ptr<const Snapshot> snapshot;  ///< with the operator's edits
    std::vector<PlaneResult> planes;
    Labels labels;  ///< only where an output needs them: addLabels()
};

/// Works out the plane of every beam.
void addLabels(ScanResults& results);

using ResultWriter = std::function<Result<void>(std::ostream&, const ScanResults&)>;

// The kinds of files by their suffixes, and what writes them.
inline constexpr std::array<std::string_view, 5> kPlanesSuffixes{".csv", ".json", ".ply", ".obj", ".dxf"};
inline constexpr std::array<std::string_view, 2> kSegmentsSuffixes{".csv", ".ply"};
inline constexpr std::array<std::string_view, 2> kPointsSuffixes{".ply", ".pcd"};
inline constexpr std::array<std::string_view, 1> kFloorPlanSuffixes{".dxf"};
inline constexpr std::array<std::string_view, 2> kReportSuffixes{".html", ".htm"};

ResultWriter planesWriter(std::string_view suffix);
ResultWriter segmentsWriter(std::string_view suffix);
/// Needs labels.
ResultWriter pointsWriter(std::string_view suffix);

/// A plan of what stands in the room, at a height above its floor [m]. Where no floor is found it is cut at the height
/// of the pitch axis, and `warn` hears of it.
ResultWriter floorPlanWriter(double cutHeight, std::function<void(std::string_view)> warn);

/// A page about the scan; `title` is what it is called. The plan is cut at a height above the floor [m], or above the
/// pitch axis where there is none.
ResultWriter reportWriter(std::string title, double cutHeight, int plannedSteps = 0,
                          std::vector<ReportPicture> pictures = {});

}  // namespace planewright
