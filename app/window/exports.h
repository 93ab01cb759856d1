// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string_view>

#include <QString>

#include "app/files/scan_results.h"
#include "app/window/window_parts.h"

namespace planewright {

/// What can be exported of a scan.
enum class ExportKind { PlanesFound, ScanPoints, LineSegments, FloorPlan };

/// Suffixes of a kind's files, the usual one first.
std::span<const std::string_view> suffixesOf(ExportKind kind);

/// Writes a part of what is shown to a file, whose suffix says how: the same bytes as `planewright-cli extract` writes
/// of the same scan with the same parameters and edits. An existing file is replaced once the new one is complete.
/// Errors: Usage for another suffix; NotWritten.
Result<void> exportScan(const WindowParts& parts, ExportKind kind, const QString& file);

}  // namespace planewright
