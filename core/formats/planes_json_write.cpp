// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <ostream>

#include "core/formats/json_text.h"
#include "core/formats/plane_cells.h"
#include "core/formats/planes_json.h"
#include "core/formats/written.h"

namespace planewright {

namespace {

/// `[a,b,c]` of a vector-like thing of three.
template <class Vector>
void appendTriple(std::string& text, const Vector& v)
{
    char before = '[';
    for (int i = 0; i < 3; ++i) {
        text += before;
        appendJsonNumber(text, v[i]);
        before = ',';
    }
    text += ']';
}

void appendJsonRing(std::string& text, const std::vector<Eigen::Vector3d>& ring)
{
    text += '[';
    for (const Eigen::Vector3d& point : ring) {
        appendTriple(text, point);
        text += ',';
    }
    appendTriple(text, ring.front());
    text += ']';
}

void appendPolygon(std::string& text, const Outline& outline)
{
    if (outline.parts.empty()) {
        text += "null";
        return;
    }
    char before = '[';
    const auto ring = [&](const std::vector<Eigen::Vector3d>& points) {
        text += before;
        appendJsonRing(text, points);
        before = ',';
    };
    for (const Outline::Polygon& part : outline.parts) {
        ring(part.ring);
        for (const auto& hole : part.holes)
            ring(hole);
    }
    text += ']';
}

void appendCovariance(std::string& text, const Plane& plane)
{
    if (!hasCovariance(plane)) {
        text += R"(,"covariance":null,"tangents":null)";
        return;
    }
    text += R"(,"covariance":)";
    for (int row = 0; row < 3; ++row) {
        text += row == 0 ? '[' : ',';
        appendTriple(text, plane.covariance.row(row));
    }
    text += R"(],"tangents":[)";
    appendTriple(text, plane.tangents.col(0));
    text += ',';
    appendTriple(text, plane.tangents.col(1));
    text += ']';
}

/// `[1,2,3]` of numbers with blanks between.
void appendList(std::string& text, std::string numbers)
{
    std::ranges::replace(numbers, ' ', ',');
    text += '[' + numbers + ']';
}

void appendPlane(std::string& text, const PlaneResult& plane)
{
    char before = '{';
    for (const PlaneCell& cell : planeCells(plane)) {
        text += before;
        before = ',';
        appendJsonText(text, cell.kind == PlaneCell::Kind::Polygon ? "polygon" : cell.name);
        text += ':';
        if (cell.kind == PlaneCell::Kind::Polygon)
            appendPolygon(text, plane.outline);
        else if (cell.text.empty())
            text += "null";
        else if (cell.kind == PlaneCell::Kind::List)
            appendList(text, cell.text);
        else if (cell.kind == PlaneCell::Kind::Text)
            appendJsonText(text, cell.text);
        else
            text += cell.text;
    }
    appendCovariance(text, *plane.plane);
    text += '}';
}

}  // namespace

Result<void> writePlanesJson(std::ostream& out, std::span<const PlaneResult> planes, const Parameters& parameters,
                             std::string_view program)
{
    std::string text = R"({"format":"planewright-planes 1","program":)";
    appendJsonText(text, program);
    text += R"(,"parameters":)";
    appendJsonParameters(text, parameters);
    text += R"(,"planes":[)";
    for (std::size_t i = 0; i < planes.size(); ++i) {
        text += i == 0 ? "\n" : ",\n";
        appendPlane(text, planes[i]);
        out << text;
        text.clear();
    }
    out << text << "\n]}\n";
    return written(out);
}

}  // namespace planewright
