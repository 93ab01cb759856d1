// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/plane_cells.h"

#include <algorithm>
#include <cmath>

#include "core/formats/number_text.h"
#include "core/types/angle.h"

namespace planewright {

namespace {

using Ring = std::vector<Eigen::Vector3d>;

std::string lineageText(const Lineage& lineage)
{
    if (lineage.parents.empty() || lineage.kind == Lineage::Kind::Fitted)
        return {};
    std::string text = lineage.kind == Lineage::Kind::Merged ? "merge:" : "split:";
    for (const PlaneId parent : lineage.parents)
        text += std::to_string(parent) + "+";
    text.pop_back();
    return text;
}

void appendPoint(std::string& text, const Eigen::Vector3d& point)
{
    appendNumber(text, point.x());
    text += ' ';
    appendNumber(text, point.y());
    text += ' ';
    appendNumber(text, point.z());
}

void appendRing(std::string& text, const Ring& ring)
{
    text += '(';
    for (const Eigen::Vector3d& point : ring) {
        appendPoint(text, point);
        text += ", ";
    }
    appendPoint(text, ring.front());
    text += ')';
}

void appendPart(std::string& text, const Outline::Polygon& part)
{
    text += '(';
    appendRing(text, part.ring);
    for (const Ring& hole : part.holes) {
        text += ", ";
        appendRing(text, hole);
    }
    text += ')';
}

std::string stopsText(const std::vector<int>& stops)
{
    std::string text;
    for (const int stop : stops)
        text += (text.empty() ? "" : " ") + std::to_string(stop);
    return text;
}

}  // namespace

bool hasCovariance(const Plane& plane)
{
    return plane.covariance.allFinite() && (plane.covariance.array() != 0.0).any();
}

std::string wellKnownText(const Outline& outline)
{
    if (outline.parts.empty())
        return {};
    std::string text;
    if (outline.parts.size() == 1) {
        text = "POLYGON Z ";
        appendPart(text, outline.parts.front());
        return text;
    }
    text = "MULTIPOLYGON Z (";
    for (const Outline::Polygon& part : outline.parts) {
        appendPart(text, part);
        text += ", ";
    }
    text.resize(text.size() - 2);
    return text + ')';
}

double normalSigma(const Eigen::Matrix3d& covariance)
{
    const double middle = 0.5 * (covariance(0, 0) + covariance(1, 1));
    const double half = 0.5 * (covariance(0, 0) - covariance(1, 1));
    return std::sqrt(middle + std::hypot(half, covariance(0, 1)));
}

std::vector<PlaneCell> planeCells(const PlaneResult& result)
{
    const Plane& plane = *result.plane;
    const Outline& outline = result.outline;
    const bool extracted = !plane.segments.empty();
    const bool outlined = !outline.parts.empty();
    const bool certain = hasCovariance(plane);

    std::vector<PlaneCell> cells;
    cells.reserve(23);
    const auto text = [&](std::string_view name, std::string value) {
        cells.push_back({name, PlaneCell::Kind::Text, std::move(value)});
    };
    const auto number = [&](std::string_view name, double value, bool known = true) {
        cells.push_back({name, PlaneCell::Kind::Number, known ? formatNumber(value) : std::string{}});
    };
    const auto count = [&](std::string_view name, long long value, bool known = true) {
        cells.push_back({name, PlaneCell::Kind::Number, known ? std::to_string(value) : std::string{}});
    };

    count("id", plane.id);
    number("nx", plane.normal.x());
    number("ny", plane.normal.y());
    number("nz", plane.normal.z());
    number("d", plane.distance);
    count("segments", static_cast<long long>(plane.segments.size()), extracted);
    count("points", plane.points);
    number("error", plane.fittingError, extracted);
    number("rms_m", plane.rms, extracted);
    number("area_m2", outline.area, outlined);
    number("width_m", outline.width, outlined);
    number("height_m", outline.height, outlined);
    number("cx", outline.centroid.x(), outlined);
    number("cy", outline.centroid.y(), outlined);
    number("cz", outline.centroid.z(), outlined);
    number("sigma_normal_deg", toDegrees(normalSigma(plane.covariance)), certain);
    number("sigma_d_m", std::sqrt(plane.covariance(2, 2)), certain);
    count("born_step", plane.bornStep, extracted);
    count("changed_step", plane.changedStep, extracted);
    text("lineage", lineageText(plane.lineage));
    cells.push_back({"polygon_wkt", PlaneCell::Kind::Polygon, wellKnownText(outline)});
    text("name", result.name);
    text("class", result.className);
    if (!result.stops.empty())
        cells.push_back({"stops", PlaneCell::Kind::List, stopsText(result.stops)});
    return cells;
}

}  // namespace planewright
