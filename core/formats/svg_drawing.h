// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace planewright {

/// Text as it may stand in HTML and SVG, between tags and in quoted attributes; what XML has no place for is left out.
std::string markupText(std::string_view text);

/// A drawing as SVG: metres in, x to the right and y up; one unit of the picture is a pixel. Numbers have two digits
/// behind the point, in every locale. Styles are names of CSS classes, which whoever shows the drawing defines.
class SvgDrawing {
public:
    using Ring = std::vector<Eigen::Vector2d>;

    /// Of what lies between two corners [m], as large as fits `width` × `height` pixels.
    SvgDrawing(const Eigen::Vector2d& lowest, const Eigen::Vector2d& highest, double width, double height);

    /// Of what lies between two corners, so many times smaller: printed, it is of that size.
    static SvgDrawing atScale(const Eigen::Vector2d& lowest, const Eigen::Vector2d& highest, double denominator);

    double pixelsPerMetre() const { return scale_; }

    /// An area with its holes, by the even-odd rule.
    void area(std::string_view style, const std::vector<Ring>& rings);
    void line(std::string_view style, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
    /// A circle of a radius in pixels.
    void dot(std::string_view style, const Eigen::Vector2d& centre, double radius);
    /// Centred on a point, or as near to it as the picture holds all of it; a text wider than the picture is cut short
    /// with an ellipsis. False, and nothing is drawn, where it would cover a text before it.
    bool label(std::string_view style, const Eigen::Vector2d& centre, std::string_view text);

    /// Lines a metre apart, or 2, 5, 10, … where they would be closer than 20 pixels, and a bar of that length below;
    /// a picture that is too narrow for the bar becomes wider.
    void grid();

    /// The whole drawing, with what it shows for those who do not see it, and, where it stands alone, its styles (CSS).
    std::string take(std::string_view title, std::string_view styles = {}) &&;

private:
    Eigen::Vector2d toPicture(const Eigen::Vector2d& point) const;
    Eigen::Vector2d size() const;
    void append(const Eigen::Vector2d& point);

    struct Box {
        Eigen::Vector2d lowest;
        Eigen::Vector2d highest;
    };

    Eigen::Vector2d lowest_;
    Eigen::Vector2d highest_;
    double scale_ = 1.0;
    double leastWidth_ = 0.0;  // [px]
    bool isToScale_ = false;
    std::string body_;
    std::vector<Box> labels_;
};

}  // namespace planewright
