// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <istream>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/formats/message_text.h"
#include "core/formats/plane_record_list.h"
#include "core/formats/planes_json.h"
#include "core/formats/strict_json.h"

namespace planewright {

namespace {

using nlohmann::json;

bool isUnknown(const json& plane, const char* key)
{
    return !plane.contains(key) || plane[key].is_null();
}

/// What is wrong with a plane, or nothing and the plane.
std::string readPlane(const json& from, PlaneRecord& plane)
{
    if (!from.is_object())
        return "is not an object; correct it";
    const auto whole = [&](const char* key, int& value) {
        if (!from[key].is_number_integer() || std::abs(from[key].get<double>()) > std::numeric_limits<int>::max())
            return false;
        value = from[key].get<int>();
        return true;
    };
    for (const char* key : {"id", "nx", "ny", "nz", "d"}) {
        if (isUnknown(from, key))
            return "has no '" + std::string{key} + "'; add it";
        if (!from[key].is_number())
            return "'" + std::string{key} + "' is not a number; correct it";
    }
    if (!whole("id", plane.id))
        return "'id' is not a whole number; correct it";
    plane.normal = {from["nx"].get<double>(), from["ny"].get<double>(), from["nz"].get<double>()};
    plane.distance = from["d"].get<double>();
    if (!isUnknown(from, "points")) {
        int points = 0;
        if (!whole("points", points))
            return "'points' is not a whole number; correct it";
        plane.points = points;
    }
    for (const auto& [key, text] : {std::pair{"name", &plane.name}, std::pair{"class", &plane.className}}) {
        if (isUnknown(from, key))
            continue;
        if (!from[key].is_string())
            return "'" + std::string{key} + "' is not a text; correct it";
        *text = from[key].get<std::string>();
    }
    return {};
}

/// The list of planes of a file.
Result<json> planeList(std::istream& in, const std::string& fileName)
{
    auto object = parseStrictJson(in, fileName);
    if (!object)
        return object;
    if (const auto format = checkJsonFormat(*object, "planewright-planes", 1, fileName); !format)
        return tl::unexpected(format.error());
    if (!object->contains("planes") || !(*object)["planes"].is_array())
        return fail(ErrorCode::Unreadable,
                    placeInFile(fileName, 0) + "there is no list 'planes'; give a file that 'extract --planes' wrote");
    return std::move((*object)["planes"]);
}

std::optional<Eigen::Vector3d> tripleOf(const json& from)
{
    if (!from.is_array() || from.size() != 3)
        return std::nullopt;
    Eigen::Vector3d triple;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!from[i].is_number())
            return std::nullopt;
        triple[static_cast<Eigen::Index>(i)] = from[i].get<double>();
    }
    return triple;
}

/// What is wrong with a plane's covariance, or nothing and both.
std::string readCovariance(const json& from, Plane& plane)
{
    if (isUnknown(from, "covariance"))
        return {};
    const json& rows = from["covariance"];
    const json& tangents = from.value("tangents", json{});
    if (!rows.is_array() || rows.size() != 3)
        return "'covariance' is no list of three rows; correct it";
    if (!tangents.is_array() || tangents.size() != 2)
        return "'tangents' is no list of two vectors; correct it";
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = tripleOf(rows[i]);
        if (!row)
            return "'covariance' has a row that is no three numbers; correct it";
        plane.covariance.row(static_cast<Eigen::Index>(i)) = *row;
    }
    if (!plane.covariance.isApprox(plane.covariance.transpose(), 1e-6))
        return "'covariance' is not symmetric; correct it";
    plane.covariance = (0.5 * (plane.covariance + plane.covariance.transpose())).eval();
    for (std::size_t i = 0; i < 2; ++i) {
        const auto tangent = tripleOf(tangents[i]);
        if (!tangent || std::abs(tangent->norm() - 1.0) > 1e-3 || std::abs(tangent->dot(plane.normal)) > 1e-3)
            return "'tangents' are no unit vectors in the plane; correct them";
        plane.tangents.col(static_cast<Eigen::Index>(i)) = *tangent;
    }
    if (std::abs(plane.tangents.col(0).dot(plane.tangents.col(1))) > 1e-3)
        return "'tangents' are not at right angles; correct them";
    return {};
}

/// What is wrong with a plane's polygon, or nothing and the parts: a ring that turns left seen from +n begins one.
std::string readPolygon(const json& from, const Plane& plane, std::vector<Outline::Polygon>& parts)
{
    if (isUnknown(from, "polygon"))
        return {};
    if (!from["polygon"].is_array())
        return "'polygon' is no list of rings; correct it";
    for (const json& points : from["polygon"]) {
        if (!points.is_array() || points.size() < 4)
            return "'polygon' has a ring of less than three corners; correct it";
        std::vector<Eigen::Vector3d> ring;
        Eigen::Vector3d twiceArea = Eigen::Vector3d::Zero();
        for (const json& point : points) {
            const auto corner = tripleOf(point);
            if (!corner)
                return "'polygon' has a corner that is no three numbers; correct it";
            if (std::abs(plane.normal.dot(*corner) - plane.distance) > 0.01)
                return "'polygon' has a corner that is not in the plane; correct it";
            if (!ring.empty())
                twiceArea += (ring.back() - ring.front()).cross(*corner - ring.front());
            ring.push_back(*corner);
        }
        if (ring.front() != ring.back())
            return "'polygon' has a ring that is not closed; correct it";
        ring.pop_back();
        if (twiceArea.dot(plane.normal) >= 0.0)
            parts.push_back({std::move(ring), {}});
        else if (!parts.empty())
            parts.back().holes.push_back(std::move(ring));
        else
            return "'polygon' begins with a hole; correct it";
    }
    return {};
}

}  // namespace

Result<std::vector<PlaneRecord>> readPlanesJson(std::istream& in, const std::string& fileName)
{
    const auto list = planeList(in, fileName);
    if (!list)
        return tl::unexpected(list.error());
    const auto refuse = [&](const std::string& what) {
        return fail(ErrorCode::Unreadable, placeInFile(fileName, 0) + what);
    };
    PlaneRecordList planes;
    std::size_t place = 0;
    for (const json& from : *list) {
        PlaneRecord plane;
        if (const std::string wrong = readPlane(from, plane); !wrong.empty())
            return refuse("plane " + std::to_string(place) + " of the list: " + wrong);
        if (const std::string wrong = planes.add(std::move(plane)); !wrong.empty())
            return refuse(wrong);
        ++place;
    }
    return std::move(planes).take();
}

Result<std::vector<PlaneResult>> readPlaneResultsJson(std::istream& in, const std::string& fileName)
{
    const auto list = planeList(in, fileName);
    if (!list)
        return tl::unexpected(list.error());
    PlaneRecordList records;
    std::vector<PlaneResult> results;
    for (const json& from : *list) {
        const auto refuse = [&](const std::string& what) {
            return fail(ErrorCode::Unreadable,
                        placeInFile(fileName, 0) + "plane " + std::to_string(results.size()) + " of the list: " + what);
        };
        PlaneRecord record;
        if (const std::string wrong = readPlane(from, record); !wrong.empty())
            return refuse(wrong);
        if (record.distance < 0.0)
            return refuse("'d' is negative; give a file that 'extract --planes' wrote");
        auto plane = std::make_shared<Plane>();
        plane->id = record.id;
        plane->normal = record.normal.normalized();
        plane->distance = record.distance;
        plane->points = record.points.value_or(0);
        std::vector<Outline::Polygon> parts;
        for (const std::string& wrong : {readCovariance(from, *plane), readPolygon(from, *plane, parts)}) {
            if (!wrong.empty())
                return refuse(wrong);
        }
        PlaneResult& result = results.emplace_back();
        result.name = record.name;
        result.className = record.className;
        if (const std::string wrong = records.add(std::move(record)); !wrong.empty())
            return fail(ErrorCode::Unreadable, placeInFile(fileName, 0) + wrong);
        result.outline = outlineOf(parts, plane->normal, plane->distance);
        result.plane = std::move(plane);
    }
    return results;
}

}  // namespace planewright
