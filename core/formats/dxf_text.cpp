// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/dxf_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/formats/number_text.h"

namespace planewright {

namespace {

constexpr std::size_t kLongestLayer = 31;

/// Colours of the AutoCAD index: classes that every scan has keep theirs.
int colourOf(std::string_view layer, std::size_t place)
{
    static constexpr std::array<std::pair<std::string_view, int>, 4> kKnown{
        {{"wall", 7}, {"floor", 3}, {"ceiling", 4}, {"other", 8}}};
    const auto known = std::find_if(kKnown.begin(), kKnown.end(), [&](const auto& k) { return k.first == layer; });
    return known != kKnown.end() ? known->second : static_cast<int>(1 + place % 6);
}

}  // namespace

std::string layerName(std::string_view name)
{
    std::string layer{name.substr(0, kLongestLayer)};
    for (char& c : layer) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '$' ||
                           c == '-' || c == '_';
        if (!plain)
            c = '_';
    }
    return layer.empty() ? "other" : layer;
}

DxfText::DxfText(const std::vector<std::string>& layers)
{
    std::vector<std::string> names = layers;
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    group(0, "SECTION");
    group(2, "HEADER");
    group(9, "$ACADVER");
    group(1, "AC1009");
    group(9, "$INSUNITS");
    group(70, "6");  // metres
    group(9, "$MEASUREMENT");
    group(70, "1");  // metric
    group(0, "ENDSEC");
    group(0, "SECTION");
    group(2, "TABLES");
    group(0, "TABLE");
    group(2, "LAYER");
    group(70, std::to_string(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
        group(0, "LAYER");
        group(2, names[i]);
        group(70, "0");
        group(62, std::to_string(colourOf(names[i], i)));
        group(6, "CONTINUOUS");
    }
    group(0, "ENDTAB");
    group(0, "ENDSEC");
    group(0, "SECTION");
    group(2, "ENTITIES");
}

void DxfText::group(int code, std::string_view value)
{
    const std::string digits = std::to_string(code);
    text_.append(digits.size() < 3 ? 3 - digits.size() : 0, ' ');
    text_ += digits;
    text_ += '\n';
    text_ += value;
    text_ += '\n';
}

void DxfText::number(int code, double value)
{
    group(code, formatNumber(value));
}

void DxfText::point(int code, const Eigen::Vector3d& point)
{
    number(code, point.x());
    number(code + 10, point.y());
    number(code + 20, point.z());
}

void DxfText::face(std::string_view layer, std::span<const Eigen::Vector3d, 3> corners)
{
    group(0, "3DFACE");
    group(8, layer);
    point(10, corners[0]);
    point(11, corners[1]);
    point(12, corners[2]);
    point(13, corners[2]);  // a face has four corners; of a triangle the last is there twice
}

void DxfText::closedPolyline(std::string_view layer, const std::vector<Eigen::Vector3d>& ring)
{
    group(0, "POLYLINE");
    group(8, layer);
    group(66, "1");  // vertices follow
    point(10, Eigen::Vector3d::Zero());
    group(70, "9");  // closed, in space
    for (const Eigen::Vector3d& corner : ring) {
        group(0, "VERTEX");
        group(8, layer);
        point(10, corner);
        group(70, "32");  // of a polyline in space
    }
    group(0, "SEQEND");
    group(8, layer);
}

void DxfText::line(std::string_view layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    group(0, "LINE");
    group(8, layer);
    point(10, {from.x(), from.y(), 0.0});
    point(11, {to.x(), to.y(), 0.0});
}

std::string DxfText::take() &&
{
    group(0, "ENDSEC");
    group(0, "EOF");
    return std::move(text_);
}

}  // namespace planewright
