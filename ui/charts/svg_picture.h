// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include <QByteArray>
#include <QPainter>

namespace planewright {

/// What is painted as an SVG picture of this size [px]: lines, areas and texts as they are, no images.
///
/// Qt's own QSvgGenerator leaves clips out (Qt 6.4), and curves of a chart would run beyond its axes.
QByteArray svgOf(const QSize& size, const std::function<void(QPainter&)>& paint);

}  // namespace planewright
