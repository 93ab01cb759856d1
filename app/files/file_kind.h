// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "core/types/error.h"

namespace planewright {

/// The one of these suffixes (`.csv`, `.csv.gz`) that a file name ends in, capitals or not. A name with none of them is
/// a Usage error that lists them; `what` says what the file is for.
Result<std::string_view> suffixOf(const std::string& path, std::span<const std::string_view> known,
                                  std::string_view what);

/// The same for suffixes written down where they are asked for.
inline Result<std::string_view> suffixOf(const std::string& path, std::initializer_list<std::string_view> known,
                                         std::string_view what)
{
    return suffixOf(path, std::span{known.begin(), known.size()}, what);
}

/// Suffixes of recordings.
inline constexpr std::array<std::string_view, 3> kRecordingSuffixes{".csv", ".csv.gz", ".pwscan"};
inline constexpr std::string_view kPwscanSuffix = kRecordingSuffixes[2];

/// Suffixes of clouds of points, which can be read as recordings and not written.
inline constexpr std::array<std::string_view, 3> kCloudSuffixes{".pcd", ".ptx", ".3d"};
inline constexpr std::string_view kPtxSuffix = kCloudSuffixes[1];

/// Suffixes of all that can be read as a recording.
inline constexpr std::array<std::string_view, 6> kScanSuffixes{".csv", ".csv.gz", ".pwscan", ".pcd", ".ptx", ".3d"};

}  // namespace planewright
