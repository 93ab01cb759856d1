// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QString>

#include "core/types/step_report.h"
#include "ui/common/length_style.h"

namespace planewright {

inline constexpr double kMillimetres = 1000.0;  ///< in a metre

/// A number for the eye with so many digits behind the point, by no locale: never "-0", and "–" for one that is no
/// number.
QString numberText(double value, int decimals);

/// A count with its noun, as "1 plane" and "12 planes".
QString countText(qsizetype count, const QString& one, const QString& many);

/// The mean fitting error of a step, "–" where there is no plane.
QString meanErrorText(const StepCounts& counts);

/// A length given in metres, in the unit of the style and without its name.
QString lengthText(double metres, const LengthStyle& style);

/// "m" or "mm".
QString lengthUnit(const LengthStyle& style);

/// An angle given in radians, in degrees with one digit and without the sign.
QString angleText(double radians);

}  // namespace planewright
