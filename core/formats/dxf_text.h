// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace planewright {

/// Writes a drawing as DXF text of release 12, which every CAD program reads; metres. Numbers are formatNumber's.
///
/// The library that reads drawings back in the tests writes six digits and the locale's decimal comma, so that this is
/// written out.
class DxfText {
public:
    /// Begins a drawing with layers of these names, each of which is there once in the end.
    explicit DxfText(const std::vector<std::string>& layers);

    void face(std::string_view layer, std::span<const Eigen::Vector3d, 3> corners);
    void closedPolyline(std::string_view layer, const std::vector<Eigen::Vector3d>& ring);
    void line(std::string_view layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

    /// The whole drawing, ended.
    std::string take() &&;

private:
    void group(int code, std::string_view value);
    void number(int code, double value);
    void point(int code, const Eigen::Vector3d& point);

    std::string text_;
};

/// A name as a layer may have it: letters, digits, `$`, `-` and `_`, at most 31; others become `_`. `other` for none.
std::string layerName(std::string_view name);

}  // namespace planewright
