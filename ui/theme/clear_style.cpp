// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/theme/clear_style.h"

#include <algorithm>

#include <QPainter>
#include <QStyleOption>
#include <QWidget>

namespace planewright {

namespace {

constexpr double kRing = 2.0;    // [px]
constexpr int kTarget = 28;      // least height of what is clicked [px]
constexpr double kRadius = 3.0;  // [px]

void drawRing(QPainter* painter, const QRectF& rectangle, const QColor& colour)
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(colour, kRing));
    painter->setBrush(Qt::NoBrush);
    const double inset = kRing / 2.0;
    painter->drawRoundedRect(rectangle.adjusted(inset, inset, -inset, -inset), kRadius, kRadius);
    painter->restore();
}

bool isClicked(QStyle::ContentsType type)
{
    switch (type) {
        case QStyle::CT_PushButton:
        case QStyle::CT_CheckBox:
        case QStyle::CT_RadioButton:
        case QStyle::CT_ToolButton:
        case QStyle::CT_ComboBox:
        case QStyle::CT_LineEdit:
        case QStyle::CT_SpinBox:
        case QStyle::CT_ItemViewItem:
        case QStyle::CT_HeaderSection:
        case QStyle::CT_TabBarTab:
        case QStyle::CT_MenuItem:
        case QStyle::CT_MenuBarItem:
        case QStyle::CT_Slider:
            return true;
        default:
            return false;
    }
}

}  // namespace

ClearStyle::ClearStyle() : QProxyStyle(QStringLiteral("fusion")) {}

void ClearStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                               const QWidget* widget) const
{
    const QColor colour = option->palette.color(QPalette::Highlight);
    if (element == PE_FrameFocusRect) {
        // In a chosen row the ring has the colour of the row's text.
        const auto* focus = qstyleoption_cast<const QStyleOptionFocusRect*>(option);
        const bool onAccent = focus != nullptr && focus->backgroundColor == colour;
        drawRing(painter, option->rect, onAccent ? option->palette.color(QPalette::HighlightedText) : colour);
        return;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_FrameLineEdit && option->state.testFlag(State_HasFocus))
        drawRing(painter, option->rect, colour);
}

void ClearStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                    const QWidget* widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    const bool ringed = control == CC_ComboBox || control == CC_SpinBox || control == CC_Slider;
    if (ringed && option->state.testFlag(State_HasFocus))
        drawRing(painter, option->rect, option->palette.color(QPalette::Highlight));
}

QSize ClearStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                   const QWidget* widget) const
{
    QSize needed = QProxyStyle::sizeFromContents(type, option, size, widget);
    if (!isClicked(type))
        return needed;
    // A slider stands upright where it is higher than wide.
    const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
    if (type == CT_Slider && slider != nullptr && slider->orientation == Qt::Vertical)
        needed.setWidth(std::max(needed.width(), kTarget));
    else
        needed.setHeight(std::max(needed.height(), kTarget));
    if (type == CT_ToolButton)
        needed.setWidth(std::max(needed.width(), kTarget));
    return needed;
}

}  // namespace planewright
