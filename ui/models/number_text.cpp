// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types/angle.h"

namespace planewright {

QString numberText(double value, int decimals)
{
    if (!std::isfinite(value))
        return QStringLiteral("–");
    const QString text = QString::number(value, 'f', decimals);
    const bool isZero = std::none_of(text.cbegin(), text.cend(), [](QChar c) { return c >= '1' && c <= '9'; });
    return isZero && text.startsWith('-') ? text.mid(1) : text;
}

QString countText(qsizetype count, const QString& one, const QString& many)
{
    return QString::number(count) + QLatin1Char(' ') + (count == 1 ? one : many);
}

QString meanErrorText(const StepCounts& counts)
{
    return numberText(counts.planes > 0 ? counts.meanError : std::numeric_limits<double>::quiet_NaN(), 2);
}

QString lengthText(double metres, const LengthStyle& style)
{
    return style.millimetres ? numberText(metres * kMillimetres, std::max(style.decimals - 3, 0))
                             : numberText(metres, style.decimals);
}

QString lengthUnit(const LengthStyle& style)
{
    return style.millimetres ? QStringLiteral("mm") : QStringLiteral("m");
}

QString angleText(double radians)
{
    return numberText(toDegrees(radians), 1);
}

}  // namespace planewright
