// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <istream>
#include <limits>

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

}  // namespace

Result<std::vector<PlaneRecord>> readPlanesJson(std::istream& in, const std::string& fileName)
{
    const auto object = parseStrictJson(in, fileName);
    if (!object)
        return tl::unexpected(object.error());
    if (const auto format = checkJsonFormat(*object, "planewright-planes", 1, fileName); !format)
        return tl::unexpected(format.error());
    const auto refuse = [&](const std::string& what) {
        return fail(ErrorCode::Unreadable, placeInFile(fileName, 0) + what);
    };
    if (!object->contains("planes") || !(*object)["planes"].is_array())
        return refuse("there is no list 'planes'; give a file that 'extract --planes' wrote");
    PlaneRecordList planes;
    std::size_t place = 0;
    for (const json& from : (*object)["planes"]) {
        PlaneRecord plane;
        if (const std::string wrong = readPlane(from, plane); !wrong.empty())
            return refuse("plane " + std::to_string(place) + " of the list: " + wrong);
        if (const std::string wrong = planes.add(std::move(plane)); !wrong.empty())
            return refuse(wrong);
        ++place;
    }
    return std::move(planes).take();
}

}  // namespace planewright
