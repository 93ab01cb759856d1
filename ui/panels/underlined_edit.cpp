// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/underlined_edit.h"

#include <algorithm>

#include <QPainter>
#include <QPainterPath>

#include "ui/theme/theme.h"

namespace planewright {

void UnderlinedEdit::underline(int position, int length)
{
    position_ = position;
    length_ = length;
    update();
}

void UnderlinedEdit::paintEvent(QPaintEvent* event)
{
    QLineEdit::paintEvent(event);
    if (length_ == 0)
        return;
    // The line edit scrolls its text; where a character stands is known from where the cursor stands.
    const double cursor = cursorRect().center().x();
    const QFontMetricsF metrics(font());
    const auto xOf = [&](int place) {
        return cursor + metrics.horizontalAdvance(text().left(place)) -
               metrics.horizontalAdvance(text().left(cursorPosition()));
    };
    constexpr double kWave = 2.0;  // [px]
    const double left = std::max(xOf(position_), 4.0);
    const double right = std::min(xOf(position_ + length_), width() - 4.0);
    const double bottom = height() / 2.0 + metrics.height() / 2.0;
    QPainterPath wave({left, bottom});
    bool up = true;
    for (double x = left + kWave; x <= std::max(right, left + 2.0 * kWave); x += kWave, up = !up)
        wave.lineTo(x, up ? bottom - kWave : bottom);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(wrongColour(palette()), 1.5));
    painter.drawPath(wave);
}

QColor wrongColour(const QPalette& palette)
{
    return themeOf(palette) == Theme::Dark ? QColor(255, 140, 130) : QColor(176, 20, 20);
}

}  // namespace planewright
