// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <span>
#include <string_view>

#include <QString>

#include "app/files/scan_results.h"
#include "app/window/window_parts.h"

namespace planewright {

/// What can be exported of a scan.
enum class ExportKind { PlanesFound, ScanPoints, LineSegments, FloorPlan, PageOfScan };

/// Suffixes of a kind's files, the usual one first.
std::span<const std::string_view> suffixesOf(ExportKind kind);

/// What writes a part of the scan as it is now to a file, whose suffix says how: the same bytes as `planewright-cli
/// extract` writes of the same scan with the same parameters and edits, but that a page has pictures of the 3D view. An
/// existing file is replaced once the new one is complete. To be called on any thread; its errors: NotWritten. Errors:
/// Usage for another suffix, or without a scan.
Result<std::function<Result<void>()>> exportOf(WindowParts& parts, ExportKind kind, const QString& file);

/// The same for the recording itself: the slices as they were measured, and in a `.pwscan` parameters and edits.
/// Errors also: NotWritten where the file is being recorded.
Result<std::function<Result<void>()>> copyOf(WindowParts& parts, const QString& file);

}  // namespace planewright
