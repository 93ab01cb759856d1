// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/formats/sqlite_database.h"
#include "core/types/recording.h"

namespace planewright {

/// The bits of a slice's `flags`.
inline constexpr std::int64_t kSliceAngleSuspect = 1;
inline constexpr std::int64_t kSliceTimeSuspect = 2;
inline constexpr std::int64_t kSliceRetaken = 4;

/// Ranges as `.pwscan` holds them: a uint32 of millimetres each, the lowest byte first. Nothing where one is more than
/// a recording can hold.
std::optional<std::string> packedRanges(const std::vector<double>& ranges);

/// zlib's crc32 of bytes.
std::uint32_t checkSum(std::string_view bytes);

/// Adds a slice to a scan with the statement that prepareSliceInsert gave.
Result<SqlStatement> prepareSliceInsert(SqlDatabase& database);
Result<void> insertSlice(SqlStatement& insert, int scan, const ScanSlice& slice, std::string_view packed);

/// Reads the slices of one scan in the order of their steps, each held against what a slice must be before it is used.
///
/// `onSlice` hears of every good one, `onProblem` of every bad one, with its place; the values of a bad one are never
/// used. No more than the limits of a recording is read, and the ranges of one slice are in memory at a time.
/// `ranges` counts the ranges that have been read, over several scans of a file. Errors (Unreadable): the scan cannot
/// be asked at all.
struct SliceListener {
    std::function<void(ScanSlice&&)> onSlice;
    std::function<void(const std::string&)> onProblem;
};
Result<void> readSlices(SqlDatabase& database, int scan, const ScanDescription& description, std::size_t& ranges,
                        const SliceListener& listener);

}  // namespace planewright
