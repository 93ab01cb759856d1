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

/// A line of one pixel, 3 : 1 at least against what is on either side of it: where a control begins and ends.
void drawEdge(QPainter* painter, const QRectF& rectangle, const QStyleOption* option)
{
    QColor colour = option->palette.color(QPalette::WindowText);
    constexpr float kStrength = 0.55F;
    colour.setAlphaF(option->state.testFlag(QStyle::State_Enabled) ? kStrength : kStrength / 2.0F);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(colour, 1.0));
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(rectangle.adjusted(0.5, 0.5, -0.5, -0.5), 2.0, 2.0);
    painter->restore();
}

bool hasEdge(QStyle::PrimitiveElement element)
{
    return element == QStyle::PE_FrameLineEdit || element == QStyle::PE_IndicatorCheckBox ||
           element == QStyle::PE_IndicatorItemViewItemCheck || element == QStyle::PE_PanelButtonCommand;
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
    if (hasEdge(element))
        drawEdge(painter, option->rect, option);
    if (element == PE_FrameLineEdit && option->state.testFlag(State_HasFocus))
        drawRing(painter, option->rect, colour);
}

void ClearStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                    const QWidget* widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_ComboBox || control == CC_SpinBox)
        drawEdge(painter, option->rect, option);
    const bool ringed = control == CC_ComboBox || control == CC_SpinBox || control == CC_Slider;
    if (ringed && option->state.testFlag(State_HasFocus))
        drawRing(painter, option->rect, option->palette.color(QPalette::Highlight));
}

QRect ClearStyle::subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const
{
    // The ring goes around the whole cell, whatever is in it.
    return element == SE_ItemViewItemFocusRect ? option->rect : QProxyStyle::subElementRect(element, option, widget);
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

ClearStyle* makeClearStyle()
{
    return new ClearStyle;
}

}  // namespace planewright
