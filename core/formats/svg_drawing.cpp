// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/svg_drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/formats/number_text.h"
#include "core/types/angle_text.h"

namespace planewright {

namespace {

constexpr double kMargin = 12.0;       // about the drawing [px]
constexpr double kBelow = 26.0;        // for the bar [px]
constexpr double kLabelHeight = 14.0;  // of a text of 12 px
constexpr double kLetterWidth = 7.5;
constexpr double kRim = 2.0;            // between a text and the edge of the picture [px]
constexpr double kClosestLines = 20.0;  // of the grid [px]

constexpr double kMillimetresPerPixel = 25.4 / 96.0;  // of CSS

/// Whether a byte of UTF-8 is the first of a letter.
bool beginsLetter(char byte)
{
    return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U;
}

std::ptrdiff_t lettersOf(std::string_view text)
{
    return std::count_if(text.begin(), text.end(), beginsLetter);
}

std::string pixels(double value)
{
    return fixedText(value, 2);
}

/// Width that a text takes [px].
double widthOf(std::string_view text)
{
    return kLetterWidth * static_cast<double>(lettersOf(text));
}

/// The text, or so much of it, with an ellipsis, as a width holds.
std::string shortened(std::string_view text, double width)
{
    if (widthOf(text) <= width)
        return std::string{text};
    const auto letters = static_cast<std::size_t>(std::max(1.0, std::floor(width / kLetterWidth)));
    std::size_t end = 0;
    for (std::size_t taken = 0; end < text.size(); ++end) {
        if (beginsLetter(text[end]) && ++taken == letters)
            break;
    }
    return std::string{text.substr(0, end)} + "…";
}

/// 1, 2, 5, 10, 20, … metres: the least that is far enough.
double gridStep(double pixelsPerMetre)
{
    double step = 1.0;
    for (int turn = 0; step * pixelsPerMetre < kClosestLines; ++turn)
        step *= turn % 3 == 1 ? 2.5 : 2.0;
    return step;
}

}  // namespace

std::string markupText(std::string_view text)
{
    std::string markup;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        switch (c) {
            case '&':
                markup += "&amp;";
                break;
            case '<':
                markup += "&lt;";
                break;
            case '>':
                markup += "&gt;";
                break;
            case '"':
                markup += "&quot;";
                break;
            case '\'':
                markup += "&#39;";
                break;
            default:
                if (code >= 0x20 && code != 0x7f)
                    markup += c;
                else if (c == '\n' || c == '\t')
                    markup += ' ';
        }
    }
    return markup;
}

SvgDrawing::SvgDrawing(const Eigen::Vector2d& lowest, const Eigen::Vector2d& highest, double width, double height)
    : lowest_(lowest), highest_(highest)
{
    constexpr double kLeastSize = 0.01;  // [m]
    const Eigen::Vector2d size = (highest - lowest).cwiseMax(kLeastSize);
    scale_ = std::min((width - 2.0 * kMargin) / size.x(), (height - 2.0 * kMargin - kBelow) / size.y());
}

SvgDrawing SvgDrawing::atScale(const Eigen::Vector2d& lowest, const Eigen::Vector2d& highest, double denominator)
{
    SvgDrawing drawing{lowest, highest, 0.0, 0.0};
    drawing.scale_ = 1e3 / (kMillimetresPerPixel * denominator);
    drawing.isToScale_ = true;
    return drawing;
}

Eigen::Vector2d SvgDrawing::toPicture(const Eigen::Vector2d& point) const
{
    return {kMargin + scale_ * (point.x() - lowest_.x()), kMargin + scale_ * (highest_.y() - point.y())};
}

void SvgDrawing::append(const Eigen::Vector2d& point)
{
    const Eigen::Vector2d at = toPicture(point);
    body_ += pixels(at.x()) + " " + pixels(at.y());
}

void SvgDrawing::area(std::string_view style, const std::vector<Ring>& rings)
{
    body_ += "<path class=\"" + markupText(style) + "\" fill-rule=\"evenodd\" d=\"";
    for (const Ring& ring : rings) {
        char command = 'M';
        for (const Eigen::Vector2d& corner : ring) {
            body_ += command;
            append(corner);
            command = 'L';
        }
        if (!ring.empty())
            body_ += 'Z';
    }
    body_ += "\"/>\n";
}

void SvgDrawing::line(std::string_view style, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    body_ += "<path class=\"" + markupText(style) + "\" d=\"M";
    append(from);
    body_ += 'L';
    append(to);
    body_ += "\"/>\n";
}

void SvgDrawing::dot(std::string_view style, const Eigen::Vector2d& centre, double radius)
{
    const Eigen::Vector2d at = toPicture(centre);
    body_ += "<circle class=\"" + markupText(style) + "\" cx=\"" + pixels(at.x()) + "\" cy=\"" + pixels(at.y()) +
             "\" r=\"" + pixels(radius) + "\"/>\n";
}

bool SvgDrawing::label(std::string_view style, const Eigen::Vector2d& centre, std::string_view text)
{
    const Eigen::Vector2d picture = size();
    const std::string shown = shortened(text, picture.x() - 2.0 * kRim);
    const Eigen::Vector2d half{0.5 * widthOf(shown), 0.5 * kLabelHeight};
    const Eigen::Vector2d inset = half + Eigen::Vector2d::Constant(kRim);
    const Eigen::Vector2d at = toPicture(centre).cwiseMin(picture - inset).cwiseMax(inset);
    const Box box{at - half, at + half};
    const bool isFree = std::none_of(labels_.begin(), labels_.end(), [&](const Box& other) {
        return (box.lowest.array() < other.highest.array()).all() && (other.lowest.array() < box.highest.array()).all();
    });
    if (!isFree)
        return false;
    labels_.push_back(box);
    body_ += "<text class=\"" + markupText(style) + "\" x=\"" + pixels(at.x()) + "\" y=\"" +
             pixels(at.y() + 0.3 * kLabelHeight) + "\" text-anchor=\"middle\">" + markupText(shown) + "</text>\n";
    return true;
}

void SvgDrawing::grid()
{
    const double step = gridStep(scale_);
    for (double x = step * std::ceil(lowest_.x() / step); x <= highest_.x(); x += step)
        line("grid", {x, lowest_.y()}, {x, highest_.y()});
    for (double y = step * std::ceil(lowest_.y() / step); y <= highest_.y(); y += step)
        line("grid", {lowest_.x(), y}, {highest_.x(), y});
    const Eigen::Vector2d from{lowest_.x(), lowest_.y() - 12.0 / scale_};
    line("bar", from, from + Eigen::Vector2d{step, 0.0});
    const Eigen::Vector2d at = toPicture(from);
    const std::string length = formatNumber(step) + " m";
    const double begin = at.x() + step * scale_ + 6.0;
    leastWidth_ = begin + widthOf(length) + kRim;
    body_ += "<text class=\"bar-text\" x=\"" + pixels(begin) + "\" y=\"" + pixels(at.y() + 4.0) + "\">" + length +
             "</text>\n";
}

/// Width and height of the picture [px].
Eigen::Vector2d SvgDrawing::size() const
{
    const Eigen::Vector2d size = toPicture({highest_.x(), lowest_.y()}) + Eigen::Vector2d{kMargin, kMargin + kBelow};
    return {std::max(size.x(), leastWidth_), size.y()};
}

std::string SvgDrawing::take(std::string_view title, std::string_view styles) &&
{
    const Eigen::Vector2d picture = size();
    const std::string words = markupText(title);
    const auto length = [this](double value) {
        return isToScale_ ? fixedText(kMillimetresPerPixel * value, 3) + "mm" : pixels(value);
    };
    const std::string style = styles.empty() ? std::string{} : "<style>" + std::string{styles} + "</style>\n";
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + pixels(picture.x()) + " " +
           pixels(picture.y()) + "\" width=\"" + length(picture.x()) + "\" height=\"" + length(picture.y()) +
           "\" role=\"img\" aria-label=\"" + words + "\">\n<title>" + words + "</title>\n" + style + std::move(body_) +
           "</svg>\n";
}

}  // namespace planewright
