// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include <QByteArray>
#include <QPainter>

namespace planewright {

/// What is painted as an SVG picture of this size [px]: lines, areas and texts as they are, no images.
QByteArray svgOf(const QSize& size, const std::function<void(QPainter&)>& paint);

}  // namespace planewright
