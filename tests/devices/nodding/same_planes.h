// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <QtTest>

#include "core/geometry/sensor_model.h"
#include "core/pipeline/plane_extractor.h"
#include "core/types/angle.h"

namespace planewright {

inline std::vector<Plane> planesOf(const ScanDescription& description, const std::vector<ScanSlice>& slices)
{
    PlaneExtractor extractor(sensorOf(description), Parameters{});
    for (const ScanSlice& slice : slices)
        extractor.step(slice);
    const auto snapshot = extractor.finish();
    std::vector<Plane> planes;
    for (const auto& plane : snapshot->planes)
        planes.push_back(*plane);
    return planes;
}

/// Every expected plane of so many points is there, within half a count of an RX-64 (0.29 degrees) and a centimetre;
/// and so many of them there are.
inline void verifySamePlanes(const std::vector<Plane>& planes, const std::vector<Plane>& expected, int points,
                             int least)
{
    int large = 0;
    for (const Plane& wanted : expected) {
        if (wanted.points < points)
            continue;
        ++large;
        const bool isThere = std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
            return plane.normal.dot(wanted.normal) > std::cos(degrees(0.15)) &&
                   std::abs(plane.distance - wanted.distance) < 0.01;
        });
        QVERIFY2(isThere, qPrintable(QString("plane %1 at %2 m").arg(wanted.id).arg(wanted.distance)));
    }
    QVERIFY2(large >= least, qPrintable(QString::number(large)));
}

}  // namespace planewright
