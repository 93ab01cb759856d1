// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QColor>
#include <QPainter>
#include <QRect>
#include <QString>
#include <QStringList>

#include "ui/scene/map_scene.h"

namespace planewright {

/// What is written over the scene, beside what the scene itself says.
struct OverlayContent {
    QString stateText;    ///< of the session, with its sign, in lines; empty for none
    QColor stateColour;   ///< of the chip
    bool locked = false;  ///< a lock stands before the state
    QStringList facts;    ///< lines below the chip
    QString hint;         ///< in the middle, where there is nothing to see
    QString tip;          ///< at the pointer
    QPoint tipPlace;
    QSize corner;  ///< at the top right something else stands over the picture
};

QColor toQColor(Rgb colour);

/// Where a point of projected() is in a picture of this size [px].
QPointF toPixels(const Eigen::Vector3d& projected, QSize size);

/// Paints names of planes, legend, scale bar, state and tip over a picture of this size, with the painter's font.
void paintOverlay(QPainter& painter, QSize size, const MapScene& scene, const OverlayContent& content);

/// A round length that is drawn as a bar of at most this many metres: 1, 2 or 5 times a power of ten.
double scaleBarLength(double most);

}  // namespace planewright
