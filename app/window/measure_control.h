// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>

#include <QObject>

#include "app/window/window_parts.h"

namespace planewright {

/// Takes measurements with clicks in the 3D view: point to point, point to plane, plane to plane.
class MeasureControl : public QObject {
    Q_OBJECT

public:
    explicit MeasureControl(WindowParts& parts);

private:
    enum class Kind { None, Points, PointAndPlane, Planes };

    void begin(Kind kind, bool on);
    void take(const Picked& picked);
    void drawAll();

    WindowParts& parts_;
    Kind kind_ = Kind::None;
    std::optional<Picked> first_;
};

}  // namespace planewright
