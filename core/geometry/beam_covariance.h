// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "core/geometry/sensor_model.h"

namespace planewright {

/// Two numbers in one register, and the same bits of each as if it were alone.
using Pair [[gnu::vector_size(16)]] = double;

/// The columns of J of Eq. (15), of one beam or, in pairs, of two of the same slice.
template <class Number>
struct BeamJacobian {
    Number byRange[3];
    Number byBearing[3];
    Number byTilt[3];
};

/// J at a range [m] and a bearing, by its sine and cosine; the tilt is that of `beam`.
template <class Number>
inline void takeJacobian(const Number& range, const Number& sinBearing, const Number& cosBearing, double sinTilt,
                         double cosTilt, const SensorModel& sensor, BeamJacobian<Number>& j)
{
    const double dl = sensor.pitchAxisOffset;
    j.byRange[0] = cosBearing;
    j.byRange[1] = sinBearing * sinTilt;
    j.byRange[2] = -sinBearing * cosTilt;
    j.byBearing[0] = -range * sinBearing;
    j.byBearing[1] = range * cosBearing * sinTilt;
    j.byBearing[2] = -range * cosBearing * cosTilt;
    j.byTilt[0] = Number{};
    j.byTilt[1] = range * sinBearing * cosTilt - dl * sinTilt;
    j.byTilt[2] = range * sinBearing * sinTilt + dl * cosTilt;
}

/// Row and column of C = J diag(variances) Jᵀ number by number: products of matrices this small wait for what was
/// stored just before. The last row adds up in the order in which such a product does.
template <class Number>
inline void takeCovariance(const BeamJacobian<Number>& j, const Number& ofRange, double ofBearing, double ofTilt,
                           Number (&covariance)[3][3])
{
    for (int row = 0; row < 3; ++row) {
        const Number range = j.byRange[row] * ofRange;
        const Number bearing = j.byBearing[row] * ofBearing;
        const Number tilt = j.byTilt[row] * ofTilt;
        for (int column = 0; column < 3; ++column) {
            const Number first = range * j.byRange[column];
            const Number second = bearing * j.byBearing[column];
            const Number third = tilt * j.byTilt[column];
            covariance[row][column] = row < 2 ? first + second + third : first + (second + third);
        }
    }
}

}  // namespace planewright
