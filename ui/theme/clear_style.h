// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QProxyStyle>

namespace planewright {

/// Qt's Fusion with a focus ring of two pixels around whatever has the keyboard, edges that can be seen on light and
/// dark, and no target below 28 pixels.
class ClearStyle : public QProxyStyle {
    Q_OBJECT

public:
    ClearStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
    QRect subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                           const QWidget* widget) const override;
};

/// One for QApplication::setStyle, which takes it over.
ClearStyle* makeClearStyle();

}  // namespace planewright
