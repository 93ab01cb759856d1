// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <zlib.h>

#include "core/formats/little_endian.h"
#include "core/formats/pwscan_slice.h"
#include "core/formats/recorded_slice.h"
#include "core/formats/recording_csv.h"

namespace planewright {

std::optional<std::string> packedRanges(const std::vector<double>& ranges)
{
    std::string packed;
    packed.reserve(4 * ranges.size());
    for (const double range : ranges) {
        const double millimetres = recordedMillimetres(range);
        if (millimetres > kMaxRangeMillimetres)
            return std::nullopt;
        appendLittleEndian(packed, static_cast<std::uint32_t>(millimetres));
    }
    return packed;
}

std::uint32_t checkSum(std::string_view bytes)
{
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

Result<SqlStatement> prepareSliceInsert(SqlDatabase& database)
{
    return database.prepare(
        "INSERT INTO slice(scan_id, step, time_us, pitch_deg, pitch_end_deg, pitch_commanded_deg, bearing_start_deg, "
        "flags, ranges, crc32) VALUES(?,?,?,?,?,?,?,?,?,?)");
}

Result<void> insertSlice(SqlStatement& insert, int scan, const ScanSlice& slice, std::string_view packed)
{
    const auto inDegrees = [](const std::optional<double>& angle) {
        return angle ? std::optional{degreesReadingBackTo(*angle)} : std::nullopt;
    };
    insert.bind(std::int64_t{scan})
        .bind(std::int64_t{slice.step})
        .bind(std::int64_t{slice.time.count()})
        .bind(degreesReadingBackTo(slice.tilt))
        .bind(inDegrees(slice.tiltEnd))
        .bind(inDegrees(slice.tiltCommanded))
        .bind(inDegrees(slice.ownBearing ? std::optional{slice.firstBearing} : std::nullopt))
        .bind(std::int64_t{(slice.angleSuspect ? kSliceAngleSuspect : 0) | (slice.timeSuspect ? kSliceTimeSuspect : 0) |
                           (slice.retaken ? kSliceRetaken : 0)})
        .bindBlob(packed)
        .bind(std::int64_t{checkSum(packed)});
    return insert.run();
}

}  // namespace planewright
