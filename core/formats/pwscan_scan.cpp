// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/pwscan_scan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formats/geometry_keys.h"
#include "core/formats/message_text.h"
#include "core/formats/recorded_slice.h"
#include "core/formats/recording_csv.h"
#include "core/formats/scan_extra.h"
#include "core/formats/sqlite_database.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

constexpr std::array<std::string_view, 4> kStateNames{"running", "complete", "partial", "fault"};
constexpr std::size_t kMostTextBytes = std::size_t{64} << 20;  ///< of all scans together

enum Column {
    kId,
    kName,
    kFloor,
    kStartedUtc,
    kState,
    kScanner,
    kBearingStart,
    kBearingStep,
    kBeams,
    kRangeMin,
    kRangeMax,
    kAxisOffset,
    kPlannedSlices,
    kExtra,
    kPose
};

/// Reads one row, and says of the first thing that is wrong what it is.
class ScanRow {
public:
    explicit ScanRow(const SqlStatement& row) : row_(row) {}

    ScanRecord read(const std::string& place);

    std::string problem;

private:
    std::string text(Column column, std::string_view name)
    {
        const auto value = row_.textIf(column);
        expect(value && isPlainUtf8(*value), name, "is no plain text");
        return value.value_or("");
    }
    int whole(Column column, std::string_view name, int lowest, int highest)
    {
        const auto value = row_.integerIf(column);
        const bool right = value && *value >= lowest && *value <= highest;
        expect(right, name, "is no whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
        return right ? static_cast<int>(*value) : lowest;
    }
    double number(int column, std::string_view name, double lowest, double highest)
    {
        const SqlStatement::Type type = row_.type(column);
        const double value = row_.real(column);
        expect((type == SqlStatement::Type::Real || type == SqlStatement::Type::Integer) && value >= lowest &&
                   value <= highest,
               name, "is no number within its limits");
        return value;
    }
    void expect(bool right, std::string_view name, const std::string& what)
    {
        if (!right && problem.empty())
            problem = std::string{name} + " " + what;
    }
    std::optional<Pose> pose();

    const SqlStatement& row_;
};

std::optional<Pose> ScanRow::pose()
{
    std::array<double, 7> values{};
    for (int i = 0; i < 7; ++i) {
        if (row_.isNull(kPose + i))
            return std::nullopt;
        values[static_cast<std::size_t>(i)] = number(kPose + i, "the pose", -1e9, 1e9);
    }
    const Eigen::Quaterniond orientation{values[3], values[4], values[5], values[6]};
    expect(std::abs(orientation.norm() - 1.0) < 1e-3, "the pose", "has no unit quaternion");
    return Pose{orientation.normalized(), {values[0], values[1], values[2]}};
}

ScanRecord ScanRow::read(const std::string& place)
{
    ScanRecord scan;
    scan.id = whole(kId, "id", 0, kMaxStep);
    scan.name = text(kName, "name");
    scan.floor = whole(kFloor, "floor", -1000, 1000);
    scan.startedUtc = text(kStartedUtc, "started_utc");
    const auto state = std::find(kStateNames.begin(), kStateNames.end(), row_.textIf(kState).value_or(""));
    expect(state != kStateNames.end(), "state", "is none of running, complete, partial and fault");
    if (state != kStateNames.end())
        scan.state = static_cast<ScanState>(state - kStateNames.begin());
    ScanDescription& description = scan.description;
    description.scanner = text(kScanner, "scanner");
    description.firstBearing = degrees(number(kBearingStart, "bearing_start_deg", -360.0, 360.0));
    description.bearingStep = degrees(number(kBearingStep, "bearing_step_deg", 1e-300, 360.0));
    description.beams = whole(kBeams, "beams", 1, kMaxBeams);
    description.rangeMin = number(kRangeMin, "range_min_m", 0.0, 1e6);
    description.rangeMax = number(kRangeMax, "range_max_m", 0.0, 1e6);
    expect(description.rangeMax > description.rangeMin, "range_max_m", "is not above range_min_m");
    description.pitchAxisOffset = number(kAxisOffset, "pitch_axis_offset_m", -10.0, 10.0);
    if (!row_.isNull(kPlannedSlices))
        scan.plannedSlices = whole(kPlannedSlices, "planned_slices", 0, kMaxStep);
    scan.pose = pose();
    const auto extra = row_.textIf(kExtra);
    expect(extra.has_value(), "extra", "is no text");
    if (extra && problem.empty()) {
        auto keys = readExtraJson(*extra, place + ", extra");
        if (keys)
            description.extra = std::move(*keys);
        problem = keys ? takeGeometryKeys(description) : "extra is no JSON object of a recording";
    }
    return scan;
}

}  // namespace

std::string_view name(ScanState state)
{
    return kStateNames[static_cast<std::size_t>(state)];
}

Result<int> insertScan(SqlDatabase& database, const ScanRecord& scan)
{
    auto insert = database.prepare(
        "INSERT INTO scan(name, floor, started_utc, state, scanner, bearing_start_deg, bearing_step_deg, beams, "
        "range_min_m, range_max_m, pitch_axis_offset_m, planned_slices, extra, x, y, z, qw, qx, qy, qz) "
        "VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    if (!insert)
        return tl::unexpected{insert.error()};
    const ScanDescription& description = scan.description;
    const std::string extra = extraJson(keysOf(description));
    insert->bind(scan.name)
        .bind(std::int64_t{scan.floor})
        .bind(scan.startedUtc)
        .bind(name(scan.state))
        .bind(description.scanner)
        .bind(degreesReadingBackTo(description.firstBearing))
        .bind(degreesReadingBackTo(description.bearingStep))
        .bind(std::int64_t{description.beams})
        .bind(description.rangeMin)
        .bind(description.rangeMax)
        .bind(description.pitchAxisOffset)
        .bind(scan.plannedSlices ? std::optional<std::int64_t>{*scan.plannedSlices} : std::nullopt)
        .bind(extra);
    if (scan.pose) {
        const Eigen::Vector3d& p = scan.pose->translation;
        const Eigen::Quaterniond& q = scan.pose->rotation;
        for (const double value : {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()})
            insert->bind(value);
    }
    if (const auto inserted = insert->run(); !inserted)
        return tl::unexpected{inserted.error()};
    return static_cast<int>(database.lastInsertedRow());
}

Result<std::vector<ScanRecord>> readScans(SqlDatabase& database, ProblemList& problems)
{
    auto rows = database.prepare(
        "SELECT id, name, floor, started_utc, state, scanner, bearing_start_deg, bearing_step_deg, beams, range_min_m, "
        "range_max_m, pitch_axis_offset_m, planned_slices, extra, x, y, z, qw, qx, qy, qz "
        "FROM scan NOT INDEXED ORDER BY id LIMIT " +
        std::to_string(kMaxScans + 1));
    if (!rows)
        return tl::unexpected{rows.error()};
    std::vector<ScanRecord> scans;
    std::size_t bytes = 0;
    for (std::size_t row = 0;; ++row) {
        const Result<bool> there = rows->step();
        if (!there)
            return tl::unexpected{there.error()};
        if (!*there)
            return scans;
        for (const Column column : {kName, kStartedUtc, kScanner, kExtra})
            bytes += rows->text(column).size();
        if (row == static_cast<std::size_t>(kMaxScans) || bytes > kMostTextBytes) {
            problems.add("there are more scans than a recording may hold; the first " + std::to_string(scans.size()) +
                             " are looked at",
                         0);
            return scans;
        }
        const std::string place = "scan " + std::to_string(rows->integer(kId));
        ScanRow reader{*rows};
        ScanRecord scan = reader.read(place);
        if (!reader.problem.empty())
            problems.add(place + ": " + reader.problem + "; the scan is not used", 0);
        else if (scans.empty() || scans.back().id < scan.id)
            scans.push_back(std::move(scan));
        else
            problems.add(place + ": the number does not rise; the scan is not used", 0);
    }
}

}  // namespace planewright
