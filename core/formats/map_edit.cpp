// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/map_edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/formats/json_text.h"
#include "core/formats/message_text.h"
#include "core/formats/pwscan_open.h"
#include "core/formats/pwscan_scan.h"
#include "core/formats/pwscan_schema.h"
#include "core/formats/recording_csv.h"
#include "core/formats/sqlite_database.h"
#include "core/formats/strict_json.h"

namespace planewright {

namespace {

constexpr std::array<std::string_view, 5> kMapKinds{"omit-stop", "order-stop", "match-plane", "stop-odometry",
                                                    "place-floor"};
constexpr std::size_t kLongestPayload = 4096;  // bytes
constexpr double kFarthest = 1e6;              // [m]
constexpr double kUnitTolerance = 1e-3;

/// A whole number from 0 to the largest int.
std::optional<int> wholeNumber(const nlohmann::json& value)
{
    if (!value.is_number_unsigned() ||
        value.get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
        return std::nullopt;
    return value.get<int>();
}

void appendPose(std::string& json, const Pose& pose)
{
    const Eigen::Vector3d& t = pose.translation;
    const Eigen::Quaterniond& q = pose.rotation;
    json += '[';
    for (const double number : {t.x(), t.y(), t.z(), q.w(), q.x(), q.y(), q.z()}) {
        json += json.back() == '[' ? "" : ",";
        appendJsonNumber(json, number);
    }
    json += ']';
}

std::optional<Pose> poseIn(const nlohmann::json& value)
{
    std::array<double, 7> numbers{};
    if (!value.is_array() || value.size() != numbers.size())
        return std::nullopt;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!value[i].is_number())
            return std::nullopt;
        numbers[i] = value[i].get<double>();
    }
    const auto& [x, y, z, qw, qx, qy, qz] = numbers;
    const Eigen::Quaterniond rotation(qw, qx, qy, qz);
    const Eigen::Vector3d place(x, y, z);
    if (!place.allFinite() || place.cwiseAbs().maxCoeff() > kFarthest ||
        !(std::abs(rotation.norm() - 1.0) < kUnitTolerance))
        return std::nullopt;
    return Pose{rotation.normalized(), place};
}

std::optional<SeenPlane> seenPlaneIn(const nlohmann::json& value)
{
    if (!value.is_object() || value.size() != 2 || !value.contains("scan") || !value.contains("plane"))
        return std::nullopt;
    const auto scan = wholeNumber(value["scan"]);
    const auto plane = wholeNumber(value["plane"]);
    if (!scan || !plane)
        return std::nullopt;
    return SeenPlane{*scan, *plane};
}

/// Reads one key of a payload; what is wrong with it, or nothing.
std::string readKey(const std::string& key, const nlohmann::json& value, MapEdit& edit)
{
    using Kind = MapEdit::Kind;
    if (key == "on" && edit.kind == Kind::Omit && value.is_boolean()) {
        edit.on = value.get<bool>();
        return {};
    }
    if (key == "before" && edit.kind == Kind::Order) {
        edit.before = wholeNumber(value);
        return edit.before || value.is_null() ? std::string{} : "'before' is no number of a scan";
    }
    if (key == "plane" && edit.kind == Kind::Match) {
        edit.plane = wholeNumber(value).value_or(kNoPlane);
        return edit.plane != kNoPlane ? std::string{} : "'plane' is no plane number";
    }
    if (key == "as" && edit.kind == Kind::Match) {
        edit.as = seenPlaneIn(value);
        return edit.as || value.is_null() ? std::string{} : "'as' is no plane of a scan";
    }
    if (key == "pose" && edit.kind == Kind::Odometry) {
        edit.odometry = poseIn(value);
        return edit.odometry || value.is_null() ? std::string{} : "'pose' is not [x,y,z,qw,qx,qy,qz]";
    }
    if (key == "pose" && edit.kind == Kind::Floor) {
        edit.place = poseIn(value);
        return edit.place || value.is_null() ? std::string{} : "'pose' is not [x,y,z,qw,qx,qy,qz]";
    }
    return quotedText(key) + " does not belong into the payload of this edit, or is of a wrong type";
}

}  // namespace

std::string_view name(MapEdit::Kind kind)
{
    return kMapKinds[static_cast<std::size_t>(kind)];
}

bool isMapEditKind(std::string_view kind)
{
    return std::ranges::find(kMapKinds, kind) != kMapKinds.end();
}

std::string mapEditJson(const MapEdit& edit)
{
    std::string json;
    switch (edit.kind) {
        case MapEdit::Kind::Omit:
            return edit.on ? R"({"on":true})" : R"({"on":false})";
        case MapEdit::Kind::Order:
            return R"({"before":)" + (edit.before ? std::to_string(*edit.before) : "null") + "}";
        case MapEdit::Kind::Match:
            json = R"({"plane":)" + std::to_string(edit.plane) + R"(,"as":)";
            json += edit.as ? R"({"scan":)" + std::to_string(edit.as->scan) + R"(,"plane":)" +
                                  std::to_string(edit.as->plane) + "}"
                            : "null";
            return json + "}";
        case MapEdit::Kind::Odometry:
        case MapEdit::Kind::Floor:
            break;
    }
    const std::optional<Pose>& pose = edit.kind == MapEdit::Kind::Floor ? edit.place : edit.odometry;
    json = R"({"pose":)";
    if (pose)
        appendPose(json, *pose);
    else
        json += "null";
    return json + "}";
}

Result<MapEdit> readMapEditJson(int scan, std::string_view kind, std::string_view payload, const std::string& place)
{
    const auto refuse = [&](const std::string& what) { return fail(ErrorCode::Unreadable, place + ": " + what); };
    const auto known = std::ranges::find(kMapKinds, kind);
    if (known == kMapKinds.end())
        return refuse("there is no edit " + quotedText(kind));
    if (payload.size() > kLongestPayload)
        return refuse("the payload is larger than " + std::to_string(kLongestPayload) + " bytes");
    std::istringstream in{std::string{payload}};
    const auto object = parseStrictJson(in, place);
    if (!object)
        return tl::unexpected{object.error()};
    MapEdit edit;
    edit.kind = static_cast<MapEdit::Kind>(known - kMapKinds.begin());
    edit.scan = scan;
    const std::size_t keys = edit.kind == MapEdit::Kind::Match ? 2 : 1;
    if (!object->is_object() || object->size() > keys)
        return refuse("the payload is not that of " + quotedText(kind));
    for (const auto& [key, value] : object->items()) {
        if (const std::string problem = readKey(key, value, edit); !problem.empty())
            return refuse(problem);
    }
    if (object->size() != keys)
        return refuse("the payload of " + quotedText(kind) + " lacks something");
    return edit;
}

Result<int> insertMapEdit(SqlDatabase& database, const MapEdit& edit, bool undone)
{
    auto insert = database.prepare("INSERT INTO edit(scan_id, kind, payload, undone) VALUES(?,?,?,?)");
    if (!insert)
        return tl::unexpected{insert.error()};
    const std::string payload = mapEditJson(edit);
    insert->bind(std::int64_t{edit.scan}).bind(name(edit.kind)).bind(payload).bind(std::int64_t{undone ? 1 : 0});
    if (const auto inserted = insert->run(); !inserted)
        return tl::unexpected{inserted.error()};
    return static_cast<int>(database.lastInsertedRow());
}

Result<std::vector<StoredMapEdit>> readMapEdits(SqlDatabase& database, ProblemList& problems)
{
    std::vector<StoredMapEdit> edits;
    auto rows =
        database.prepare("SELECT seq, scan_id, kind, payload, undone FROM edit NOT INDEXED ORDER BY seq LIMIT " +
                         std::to_string(kMaxScanNotes));
    if (!rows)
        return tl::unexpected{rows.error()};
    for (;;) {
        const Result<bool> there = rows->step();
        if (!there) {
            problems.add("the edits cannot be read to their end, the file is damaged; those before are used", 0);
            return edits;
        }
        if (!*there)
            return edits;
        if (!isMapEditKind(rows->text(2)))
            continue;
        const std::int64_t seq = rows->integer(0);
        const std::string place = "edit " + std::to_string(seq);
        const auto scan = rows->integerIf(1);
        const auto undone = rows->integerIf(4);
        if (!undone || seq < 0 || seq > kMaxStep || !scan || *scan < 0 || *scan > kMaxStep) {
            problems.add(place + ": seq, scan_id or undone is not what it must be; it is not applied", 0);
            continue;
        }
        auto edit = readMapEditJson(static_cast<int>(*scan), rows->text(2), rows->text(3), place);
        if (edit)
            edits.push_back({static_cast<int>(seq), std::move(*edit), *undone != 0});
        else
            problems.add(edit.error().message + "; it is not applied", 0);
    }
}

Result<ReadMapEdits> mapEditsOfPwscan(const std::string& path)
{
    auto database = openPwscanForReading(path);
    if (!database)
        return tl::unexpected{database.error()};
    if (const auto version = checkPwscanSchema(*database, path); !version)
        return tl::unexpected{version.error()};
    ProblemList problems{path, kMaxListedProblems};
    auto edits = readMapEdits(*database, problems);
    if (!edits)
        return tl::unexpected{edits.error()};
    return ReadMapEdits{std::move(*edits), problems.texts()};
}

std::vector<MapEdit> editsInForce(const std::vector<StoredMapEdit>& edits)
{
    std::vector<MapEdit> inForce;
    for (const StoredMapEdit& stored : edits) {
        if (!stored.undone)
            inForce.push_back(stored.edit);
    }
    return inForce;
}

}  // namespace planewright
