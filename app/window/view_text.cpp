// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/view_text.h"

#include <cmath>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

namespace planewright {

namespace {

constexpr double kLargestSize = 20.0;  // of points and lines [px]

QString jsonText(const QJsonObject& object)
{
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

std::optional<QJsonObject> objectOf(const QString& text)
{
    const QJsonDocument document = QJsonDocument::fromJson(text.toUtf8());
    return document.isObject() ? std::optional(document.object()) : std::nullopt;
}

std::optional<double> numberIn(const QJsonValue& value, double lowest, double highest)
{
    const double number = value.toDouble(std::nan(""));
    return number >= lowest && number <= highest ? std::optional(number) : std::nullopt;
}

}  // namespace

QString textOf(const ViewCamera& camera)
{
    QStringList numbers;
    for (const double number : {camera.target.x(), camera.target.y(), camera.target.z(), camera.distance,
                                camera.heading, camera.elevation, camera.viewAngle, camera.parallel ? 1.0 : 0.0})
        numbers.push_back(QString::number(number, 'g', 10));
    return numbers.join(QLatin1Char(' '));
}

std::optional<ViewCamera> cameraOf(const QString& text)
{
    const QStringList words = text.split(QLatin1Char(' '));
    std::array<double, 8> numbers{};
    if (words.size() != static_cast<qsizetype>(numbers.size()))
        return std::nullopt;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        bool good = false;
        numbers[i] = words[static_cast<qsizetype>(i)].toDouble(&good);
        if (!good || !std::isfinite(numbers[i]))
            return std::nullopt;
    }
    if (!(numbers[3] > 0.0) || !(numbers[6] > 0.01) || !(numbers[6] < 3.0))
        return std::nullopt;
    return ViewCamera{
        {numbers[0], numbers[1], numbers[2]}, numbers[3], numbers[4], numbers[5], numbers[6], numbers[7] != 0.0};
}

QString textOf(const LayerSettings& layers)
{
    QJsonArray styles;
    for (const LayerStyle& style : layers.styles)
        styles.append(QJsonObject{{"visible", style.visible}, {"opacity", style.opacity}, {"size", style.size}});
    return jsonText({{"layers", styles}, {"colour-by", static_cast<int>(layers.colourBy)}, {"labels", layers.labels}});
}

std::optional<LayerSettings> layersOf(const QString& text)
{
    const auto object = objectOf(text);
    if (!object)
        return std::nullopt;
    LayerSettings layers;
    const QJsonArray styles = object->value("layers").toArray();
    if (styles.size() != static_cast<qsizetype>(kLayers))
        return std::nullopt;
    for (std::size_t i = 0; i < kLayers; ++i) {
        const QJsonObject style = styles[static_cast<qsizetype>(i)].toObject();
        const auto opacity = numberIn(style["opacity"], 0.0, 1.0);
        const auto size = numberIn(style["size"], 0.0, kLargestSize);
        if (!opacity || !size || !style["visible"].isBool())
            return std::nullopt;
        layers.styles[i] = {style["visible"].toBool(), *opacity, *size};
    }
    const auto colourBy = numberIn(object->value("colour-by"), 0.0, static_cast<double>(kColourings) - 1.0);
    if (!colourBy || !object->value("labels").isBool())
        return std::nullopt;
    layers.colourBy = static_cast<ColourBy>(std::lround(*colourBy));
    layers.labels = object->value("labels").toBool();
    return layers;
}

std::optional<SegmentId> segmentIdOf(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char('.'));
    bool stepGood = false;
    bool indexGood = false;
    if (parts.size() != 2)
        return std::nullopt;
    const SegmentId id{parts[0].toInt(&stepGood), parts[1].toInt(&indexGood)};
    return stepGood && indexGood && id.step >= 0 && id.index >= 0 ? std::optional(id) : std::nullopt;
}

QString textOf(const ChosenParts& chosen)
{
    QJsonArray planes;
    for (const PlaneId plane : chosen.planes)
        planes.append(plane);
    QJsonArray segments;
    for (const SegmentId& segment : chosen.segments)
        segments.append(QStringLiteral("%1.%2").arg(segment.step).arg(segment.index));
    return jsonText({{"planes", planes}, {"segments", segments}});
}

std::optional<ChosenParts> chosenOf(const QString& text)
{
    const auto object = objectOf(text);
    if (!object || !object->value("planes").isArray() || !object->value("segments").isArray())
        return std::nullopt;
    ChosenParts chosen;
    for (const QJsonValue value : object->value("planes").toArray()) {
        if (!value.isDouble() || value.toInt(kNoPlane) < 0)
            return std::nullopt;
        chosen.planes.insert(value.toInt());
    }
    for (const QJsonValue value : object->value("segments").toArray()) {
        const auto segment = segmentIdOf(value.toString());
        if (!segment)
            return std::nullopt;
        chosen.segments.insert(*segment);
    }
    return chosen;
}

}  // namespace planewright
