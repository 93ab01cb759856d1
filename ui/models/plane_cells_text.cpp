// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/plane_cells_text.h"

#include <array>

#include "core/geometry/plane_angles.h"
#include "core/types/angle.h"
#include "core/types/plane_words.h"
#include "ui/models/number_text.h"

namespace planewright {

namespace {

constexpr int kNormalDecimals = 4;

const Outline* outlineOf(const ShownPlane& shown)
{
    return shown.outline ? &shown.outline->outline : nullptr;
}

QString text(const std::string& utf8)
{
    return QString::fromStdString(utf8);
}

/// A number where there is one, otherwise what tells that there is none.
QString known(const QVariant& value, int decimals)
{
    return value.isValid() ? numberText(value.toDouble(), decimals) : QStringLiteral("–");
}

QString sizeText(const ShownPlane& shown, const LengthStyle& style)
{
    const Outline* outline = outlineOf(shown);
    if (outline == nullptr)
        return QStringLiteral("…");
    return lengthText(outline->width, style) + QStringLiteral(" × ") + lengthText(outline->height, style);
}

struct ColumnWords {
    const char* title;
    const char* meaning;
};

constexpr std::array<ColumnWords, kPlaneColumns> kWords{{
    {"", "Colour, and whether the plane is shown"},
    {"ID", "Number of the plane"},
    {"Name", "Name given to the plane"},
    {"Class", "Floor, ceiling, wall, door or other"},
    {"nx", "Normal, to the right"},
    {"ny", "Normal, forward"},
    {"nz", "Normal, up"},
    {"d", "Distance from the scanner"},
    {"Heading°", "Where the plane lies, clockwise from straight ahead, in degrees"},
    {"Tilt°", "How steep the plane stands: 0° floor, 90° wall"},
    {"Area m²", "Area that was seen, in square metres"},
    {"W × H", "Width and height of the rectangle around it"},
    {"Seg.", "Line segments that support it"},
    {"End points", "End points of these segments"},
    {"E", "Fitting error E: mean squared Mahalanobis distance of its segments; 1 is what their noise gives"},
    {"RMS mm", "Distance of its points to it, root mean square, in millimetres"},
    {"Born", "Step at which it was made"},
    {"Changed", "Step at which it changed last"},
    {"Lineage", "Planes that it was made of"},
    {"State", "Live as fitted, merged of others, or split off another"},
    {"Lock", "Whether merging and splitting leave it alone"},
}};

}  // namespace

QVariant planeCellValue(const ShownPlane& shown, PlaneColumn column)
{
    const Plane& plane = *shown.plane;
    const Outline* outline = outlineOf(shown);
    const auto number = [](double value) { return std::isfinite(value) ? QVariant(value) : QVariant(); };
    switch (column) {
        case PlaneColumn::Colour:
            return shown.hidden ? 1 : 0;
        case PlaneColumn::Id:
            return plane.id;
        case PlaneColumn::Name:
            return text(shown.name);
        case PlaneColumn::Class:
            return text(shown.className);
        case PlaneColumn::Nx:
            return plane.normal.x();
        case PlaneColumn::Ny:
            return plane.normal.y();
        case PlaneColumn::Nz:
            return plane.normal.z();
        case PlaneColumn::Distance:
            return plane.distance;
        case PlaneColumn::Heading: {
            const auto heading = planeHeading(plane.normal);
            return heading ? QVariant(toDegrees(*heading)) : QVariant();
        }
        case PlaneColumn::Tilt:
            return toDegrees(planeTilt(plane.normal));
        case PlaneColumn::Area:
            return outline != nullptr ? QVariant(outline->area) : QVariant();
        case PlaneColumn::Size:
            return outline != nullptr ? QVariant(outline->width) : QVariant();
        case PlaneColumn::SegmentCount:
            return static_cast<int>(plane.segments.size());
        case PlaneColumn::EndPoints:
            return 2 * static_cast<int>(plane.segments.size());
        case PlaneColumn::Error:
            return number(plane.fittingError);
        case PlaneColumn::Rms:
            return number(kMillimetres * plane.rms);
        case PlaneColumn::Born:
            return plane.bornStep + 1;
        case PlaneColumn::Changed:
            return plane.changedStep + 1;
        case PlaneColumn::MadeOf:
            return text(lineageText(plane));
        case PlaneColumn::State:
            return text(planeState(plane));
        case PlaneColumn::Lock:
            return shown.locked ? 1 : 0;
    }
    return {};
}

QString planeCellText(const ShownPlane& shown, PlaneColumn column, const LengthStyle& style)
{
    const QVariant value = planeCellValue(shown, column);
    switch (column) {
        case PlaneColumn::Colour:
        case PlaneColumn::Lock:
            return {};
        case PlaneColumn::Id:
            return text(planeLabel(shown.plane->id));
        case PlaneColumn::Nx:
        case PlaneColumn::Ny:
        case PlaneColumn::Nz:
            return known(value, kNormalDecimals);
        case PlaneColumn::Distance:
            return lengthText(shown.plane->distance, style);
        case PlaneColumn::Heading:
        case PlaneColumn::Tilt:
        case PlaneColumn::Rms:
            return known(value, 1);
        case PlaneColumn::Area:
            return value.isValid() ? known(value, 2) : QStringLiteral("…");
        case PlaneColumn::Size:
            return sizeText(shown, style);
        case PlaneColumn::Error:
            return known(value, 2);
        default:
            return value.toString();
    }
}

QString planeColumnTitle(PlaneColumn column, const LengthStyle& style)
{
    const QString title = QString::fromUtf8(kWords[static_cast<std::size_t>(column)].title);
    const bool isLength = column == PlaneColumn::Distance || column == PlaneColumn::Size;
    return isLength ? title + ' ' + lengthUnit(style) : title;
}

QString planeColumnMeaning(PlaneColumn column)
{
    return QString::fromUtf8(kWords[static_cast<std::size_t>(column)].meaning);
}

}  // namespace planewright
