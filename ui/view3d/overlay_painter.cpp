// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/overlay_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QFontMetrics>
#include <QObject>
#include <QPainterPath>

namespace planewright {

namespace {

constexpr int kMargin = 12;
constexpr int kPadding = 6;
constexpr std::size_t kMostLegendLines = 16;
constexpr int kFewestLegendLines = 2;

/// A rounded plate that text stands on, so that it can be read over anything.
void paintPlate(QPainter& painter, const QRect& rect, QColor colour, int alpha = 215)
{
    colour.setAlpha(alpha);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(rect, 4.0, 4.0);
}

bool isFree(const QRect& rect, const std::vector<QRect>& taken)
{
    return std::none_of(taken.begin(), taken.end(), [&](const QRect& other) { return other.intersects(rect); });
}

/// A label moved out of the plates that it would lie under, by no more than half its width or its height; empty where
/// that is not enough.
QRect besidePlates(const QRect& label, const QRect& picture, const std::vector<QRect>& plates)
{
    std::vector<QPoint> moves{{0, 0}};
    for (const QRect& plate : plates) {
        if (!plate.intersects(label))
            continue;
        for (const int across : {plate.left() - 1 - label.right(), plate.right() + 1 - label.left()}) {
            if (std::abs(across) <= label.width() / 2)
                moves.emplace_back(across, 0);
        }
        for (const int down : {plate.top() - 1 - label.bottom(), plate.bottom() + 1 - label.top()}) {
            if (std::abs(down) <= label.height())
                moves.emplace_back(0, down);
        }
    }
    for (const QPoint& move : moves) {
        if (const QRect moved = label.translated(move); picture.contains(moved) && isFree(moved, plates))
            return moved;
    }
    return {};
}

/// Labels that would lie over one drawn before are left out, those of selected planes last.
void paintLabels(QPainter& painter, QSize size, const MapScene& scene, const std::vector<QRect>& plates)
{
    const ThemeColours& colours = themeColours(scene.theme());
    const QFontMetrics metrics(painter.font());
    std::vector<SceneLabel> labels = scene.labels();
    std::stable_partition(labels.begin(), labels.end(), [](const SceneLabel& label) { return label.selected; });
    const QRect picture(QPoint(0, 0), size);
    std::vector<QRect> taken;
    for (const SceneLabel& label : labels) {
        const Eigen::Vector3d place = projected(scene.camera(), label.place);
        if (place.z() <= 0.0)
            continue;
        const QString text = QString::fromStdString(label.text);
        QRect rect(0, 0, metrics.horizontalAdvance(text) + 2 * kPadding + 12, metrics.height() + 4);
        rect.moveCenter(toPixels(place, size).toPoint());
        rect = besidePlates(rect, picture, plates);
        if (rect.isEmpty() || !isFree(rect, taken))
            continue;
        taken.push_back(rect);
        paintPlate(painter, rect, toQColor(colours.background));
        painter.setBrush(toQColor(label.colour));
        painter.drawEllipse(QRect(rect.left() + kPadding, rect.center().y() - 4, 9, 9));
        if (label.selected) {
            painter.setPen(QPen(toQColor(colours.selection), 2.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawRoundedRect(rect, 4.0, 4.0);
        }
        painter.setPen(toQColor(colours.text));
        painter.drawText(rect.adjusted(kPadding + 12, 0, -kPadding, 0), Qt::AlignVCenter | Qt::AlignLeft, text);
    }
}

/// As many lines as there is room for between a top and the bottom, the last of them for those that there is none for.
/// The chip may reach above it. Gives where it is.
QRect paintLegend(QPainter& painter, QSize size, const MapScene& scene, int top, const QRect& chip)
{
    const ThemeColours& colours = themeColours(scene.theme());
    const QFontMetrics metrics(painter.font());
    const int line = metrics.height() + 2;
    const int most = (size.height() - kMargin - top - 2 * kPadding) / line - 1;
    if ((!scene.map().snapshot && !scene.map().building) || most < kFewestLegendLines)
        return {};
    const std::vector<LegendEntry> entries = scene.legend(std::min(kMostLegendLines, static_cast<std::size_t>(most)));
    if (entries.empty())
        return {};
    const LayerSettings& layers = scene.layers();
    const std::string_view by = scene.map().building ? kMapColourByNames[static_cast<std::size_t>(layers.mapColourBy)]
                                                     : kColourByNames[static_cast<std::size_t>(layers.colourBy)];
    const QString title = QObject::tr("Colour by %1").arg(QString::fromUtf8(by.data(), std::ssize(by)));
    int width = metrics.horizontalAdvance(title);
    for (const LegendEntry& entry : entries)
        width = std::max(width, metrics.horizontalAdvance(QString::fromStdString(entry.text)) + 20);
    QRect plate(0, 0, width + 2 * kPadding, line * (static_cast<int>(entries.size()) + 1) + 2 * kPadding);
    plate.moveBottomRight(QPoint(size.width() - kMargin, size.height() - kMargin));
    if (plate.intersects(chip))
        return paintLegend(painter, size, scene, chip.bottom() + kPadding, {});
    paintPlate(painter, plate, toQColor(colours.background));
    painter.setPen(toQColor(colours.text));
    QRect row(plate.left() + kPadding, plate.top() + kPadding, width, line);
    painter.drawText(row, Qt::AlignVCenter | Qt::AlignLeft, title);
    for (const LegendEntry& entry : entries) {
        row.translate(0, line);
        painter.fillRect(QRect(row.left(), row.center().y() - 5, 12, 11), toQColor(entry.colour));
        painter.setPen(toQColor(colours.text));
        painter.drawText(row.adjusted(20, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         QString::fromStdString(entry.text));
    }
    return plate;
}

/// Gives where it is.
QRect paintScaleBar(QPainter& painter, QSize size, const MapScene& scene)
{
    const double metresPerPixel = scene.camera().heightAtTarget() / size.height();
    const double length = scaleBarLength(140.0 * metresPerPixel);
    const int pixels = static_cast<int>(std::lround(length / metresPerPixel));
    const QFontMetrics metrics(painter.font());
    const QString text = length >= 1.0 ? QStringLiteral("%1 m").arg(length) : QStringLiteral("%1 cm").arg(100 * length);
    const ThemeColours& colours = themeColours(scene.theme());
    QRect plate(kMargin, 0, std::max(pixels, metrics.horizontalAdvance(text)) + 2 * kPadding,
                metrics.height() + 8 + 2 * kPadding);
    plate.moveBottom(size.height() - kMargin);
    paintPlate(painter, plate, toQColor(colours.background));
    painter.setPen(QPen(toQColor(colours.text), 2.0));
    const int left = plate.left() + kPadding;
    const int bottom = plate.bottom() - kPadding;
    painter.drawLine(left, bottom, left + pixels, bottom);
    painter.drawLine(left, bottom - 5, left, bottom);
    painter.drawLine(left + pixels, bottom - 5, left + pixels, bottom);
    painter.drawText(QRect(left, plate.top() + kPadding, plate.width() - 2 * kPadding, metrics.height()), Qt::AlignLeft,
                     text);
    return plate;
}

/// A closed lock; drawn, since few fonts have one.
void paintLock(QPainter& painter, const QRectF& box)
{
    painter.save();
    const double line = 0.11 * box.height();
    const QRectF body(box.left() + 0.08 * box.width(), box.top() + 0.45 * box.height(), 0.84 * box.width(),
                      0.55 * box.height());
    const QRectF shackle(body.left() + 0.16 * body.width(), box.top() + 0.5 * line, 0.68 * body.width(),
                         0.8 * box.height());
    painter.setPen(QPen(Qt::white, line));
    painter.setBrush(Qt::NoBrush);
    QPainterPath path(QPointF(shackle.left(), body.top()));
    path.lineTo(shackle.left(), shackle.center().y());
    path.arcTo(shackle, 180.0, -180.0);
    path.lineTo(shackle.right(), body.top());
    painter.drawPath(path);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawRoundedRect(body, line, line);
    painter.restore();
}

/// Where a chip and the facts below it are; empty without them.
struct StatePlates {
    QRect chip;
    QRect facts;
};

/// Where the chip would reach into the corner it goes below it.
StatePlates paintState(QPainter& painter, QSize size, const MapScene& scene, const OverlayContent& content)
{
    const QFontMetrics metrics(painter.font());
    const ThemeColours& colours = themeColours(scene.theme());
    int top = kMargin;
    QRect chip;
    if (!content.stateText.isEmpty()) {
        const QStringList lines = content.stateText.split(QLatin1Char('\n'));
        int widest = 0;
        for (const QString& line : lines)
            widest = std::max(widest, metrics.horizontalAdvance(line));
        const int lock = content.locked ? metrics.ascent() + kPadding : 0;
        chip = QRect(kMargin, top, widest + lock + 4 * kPadding,
                     static_cast<int>(lines.size()) * metrics.height() + 2 * kPadding);
        if (!content.corner.isEmpty() && chip.right() + kPadding > size.width() - content.corner.width())
            chip.moveTop(std::max(top, content.corner.height() + kPadding));
        paintPlate(painter, chip, content.stateColour, 255);
        if (content.locked)
            paintLock(painter, QRectF(chip.left() + 2 * kPadding, chip.top() + kPadding + 0.5 * metrics.descent(),
                                      0.8 * metrics.ascent(), metrics.ascent()));
        painter.setPen(Qt::white);
        painter.drawText(chip.adjusted(2 * kPadding + lock, 0, -2 * kPadding, 0), Qt::AlignVCenter | Qt::AlignLeft,
                         content.stateText);
        top = chip.bottom() + 5;
    }
    if (content.facts.isEmpty())
        return {chip, {}};
    int width = 0;
    for (const QString& fact : content.facts)
        width = std::max(width, metrics.horizontalAdvance(fact));
    const QRect plate(kMargin, top, width + 2 * kPadding,
                      static_cast<int>(content.facts.size()) * metrics.height() + 2 * kPadding);
    paintPlate(painter, plate, toQColor(colours.background));
    painter.setPen(toQColor(colours.text));
    painter.drawText(plate.adjusted(kPadding, kPadding, -kPadding, -kPadding), Qt::AlignLeft, content.facts.join('\n'));
    return {chip, plate};
}

void paintHint(QPainter& painter, QSize size, const MapScene& scene, const QString& hint)
{
    if (hint.isEmpty())
        return;
    const ThemeColours& colours = themeColours(scene.theme());
    painter.save();
    QFont large = painter.font();
    large.setBold(true);
    painter.setFont(large);
    QRect plate = painter.fontMetrics().boundingRect(QRect(QPoint(0, 0), size), Qt::AlignCenter, hint);
    plate.adjust(-2 * kPadding, -kPadding, 2 * kPadding, kPadding);
    paintPlate(painter, plate, toQColor(colours.background));
    painter.setPen(toQColor(colours.text));
    painter.drawText(plate, Qt::AlignCenter, hint);
    painter.restore();
}

void paintTip(QPainter& painter, QSize size, const MapScene& scene, const OverlayContent& content)
{
    if (content.tip.isEmpty())
        return;
    const QFontMetrics metrics(painter.font());
    QRect plate(0, 0, metrics.horizontalAdvance(content.tip) + 2 * kPadding, metrics.height() + 2 * kPadding);
    plate.moveBottomLeft(content.tipPlace + QPoint(14, -8));
    plate.moveLeft(std::clamp(plate.left(), 0, std::max(0, size.width() - plate.width())));
    plate.moveTop(std::max(0, plate.top()));
    const ThemeColours& colours = themeColours(scene.theme());
    paintPlate(painter, plate, toQColor(colours.text), 235);
    painter.setPen(toQColor(colours.background));
    painter.drawText(plate, Qt::AlignCenter, content.tip);
}

}  // namespace

QColor toQColor(Rgb colour)
{
    return {colour.red, colour.green, colour.blue};
}

QPointF toPixels(const Eigen::Vector3d& projected, QSize size)
{
    return {size.width() / 2.0 + projected.x() * size.height(), size.height() / 2.0 - projected.y() * size.height()};
}

double scaleBarLength(double most)
{
    if (!(most > 0.0))
        return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= most)
            return factor * power;
    }
    return power;
}

void paintOverlay(QPainter& painter, QSize size, const MapScene& scene, const OverlayContent& content)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::TextAntialiasing);
    const auto [chip, facts] = paintState(painter, size, scene, content);
    const QRect legend = paintLegend(painter, size, scene, std::max(kMargin, content.corner.height() + kPadding), chip);
    const QRect scale = paintScaleBar(painter, size, scene);
    paintLabels(painter, size, scene, {chip, facts, legend, scale});
    paintHint(painter, size, scene, content.hint);
    paintTip(painter, size, scene, content);
}

}  // namespace planewright
