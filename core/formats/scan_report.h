// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "core/formats/plane_result.h"
#include "core/params/parameters.h"
#include "core/types/error.h"
#include "core/types/recording.h"
#include "core/types/snapshot.h"

namespace planewright {

/// A picture of a report.
struct ReportPicture {
    std::string title;
    std::string pngBase64;  ///< a PNG file in base 64
};

/// What a report is about; all of it is the caller's.
struct ReportedScan {
    std::string title;    ///< as the file or the scanner is called
    std::string program;  ///< name and version
    const Recording& recording;
    const Snapshot& snapshot;
    std::span<const PlaneResult> planes;
    const Parameters& parameters;
    int plannedSteps = 0;    ///< 0 where nobody knows
    double cutHeight = 0.0;  ///< at which the plan is cut [m]
    std::vector<ReportPicture> pictures = {};
};

/// Writes what came out of a scan as one HTML page that needs no other file: how much was seen, plan and elevations,
/// pictures, planes with their errors, how well they fix the scanner along x, y and z, what belongs to no plane, and
/// the parameters. The same scan gives the same bytes. Errors: NotWritten.
Result<void> writeScanReport(std::ostream& out, const ReportedScan& scan);

}  // namespace planewright
