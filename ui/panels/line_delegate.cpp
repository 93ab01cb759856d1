// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/line_delegate.h"

#include <algorithm>

#include <QApplication>
#include <QPainter>
#include <QTreeView>

#include "ui/models/model_roles.h"
#include "ui/theme/theme.h"

namespace planewright {

namespace {

constexpr int kSideMargin = 4;  // [px]
constexpr int kLineMargin = 4;  // above and below [px]
constexpr int kLeastHeight = 28;

TextLine tonedLine(const QModelIndex& index)
{
    return index.data(kLineRole).value<TextLine>();
}

/// The width that a cell has for its words [px].
int widthFor(const QStyleOptionViewItem& option, const QModelIndex& index)
{
    if (option.rect.width() > 0)
        return option.rect.width() - 2 * kSideMargin;
    // A tree asks for heights without telling the width.
    const auto* tree = qobject_cast<const QTreeView*>(option.widget);
    if (tree == nullptr)
        return 0;
    int depth = tree->rootIsDecorated() ? 1 : 0;
    for (QModelIndex above = index.parent(); above.isValid(); above = above.parent())
        ++depth;
    return tree->viewport()->width() - depth * tree->indentation() - 2 * kSideMargin;
}

/// Lays the words out; gives the height.
double layOut(QTextLayout& layout, const TextLine& line, const QStyleOptionViewItem& option, int width)
{
    layout.setText(line.plain());
    layout.setFont(option.font);
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    QList<QTextLayout::FormatRange> formats;
    int start = 0;
    for (const TextPart& part : line.parts) {
        const auto length = static_cast<int>(part.text.size());
        formats.push_back({start, length, LineDelegate::formatOf(part.tone, option.palette, selected)});
        start += length;
    }
    layout.setFormats(formats);
    QTextOption wrap;
    wrap.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    wrap.setAlignment(option.displayAlignment & Qt::AlignHorizontal_Mask);
    layout.setTextOption(wrap);
    double height = 0.0;
    layout.beginLayout();
    for (QTextLine row = layout.createLine(); row.isValid(); row = layout.createLine()) {
        row.setLineWidth(std::max(width, 1));
        row.setPosition({0.0, height});
        height += row.height();
    }
    layout.endLayout();
    return height;
}

QPointF textCorner(const QStyleOptionViewItem& option, double height)
{
    return {static_cast<double>(option.rect.left() + kSideMargin),
            option.rect.top() + std::max(0.0, 0.5 * (option.rect.height() - height))};
}

}  // namespace

QTextCharFormat LineDelegate::formatOf(TextTone tone, const QPalette& palette, bool selected)
{
    const bool dark = themeOf(palette) == Theme::Dark;
    QTextCharFormat format;
    QColor colour = palette.color(QPalette::Text);
    switch (tone) {
        case TextTone::Plain:
            break;
        case TextTone::Strong:
            format.setFontWeight(QFont::Bold);
            break;
        case TextTone::Faint:
            colour = palette.color(QPalette::PlaceholderText);
            break;
        case TextTone::Pass:
            colour = dark ? QColor(122, 214, 150) : QColor(20, 104, 56);
            break;
        case TextTone::Fail:
            colour = dark ? QColor(255, 145, 132) : QColor(176, 32, 24);
            format.setFontWeight(QFont::Bold);
            break;
        case TextTone::Mark:
            format.setFontWeight(QFont::Bold);
            [[fallthrough]];
        case TextTone::Link:
            colour = palette.color(QPalette::Link);
            break;
    }
    format.setForeground(selected ? palette.color(QPalette::HighlightedText) : colour);
    format.setFontUnderline(tone == TextTone::Link);
    return format;
}

void LineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem shown = option;
    initStyleOption(&shown, index);
    shown.text.clear();
    const QStyle* style = shown.widget != nullptr ? shown.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &shown, painter, shown.widget);
    QTextLayout layout;
    const double height = layOut(layout, tonedLine(index), shown, widthFor(shown, index));
    painter->save();
    painter->setClipRect(shown.rect);
    layout.draw(painter, textCorner(shown, height));
    painter->restore();
}

QSize LineDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem shown = option;
    initStyleOption(&shown, index);
    const int width = widthFor(shown, index);
    if (width <= 0)
        return QStyledItemDelegate::sizeHint(option, index);
    QTextLayout layout;
    const double height = layOut(layout, tonedLine(index), shown, width);
    return {width + 2 * kSideMargin, std::max(kLeastHeight, static_cast<int>(height) + 2 * kLineMargin)};
}

TextTone LineDelegate::toneAt(const QStyleOptionViewItem& option, const QModelIndex& index, const QPoint& place) const
{
    QStyleOptionViewItem shown = option;
    initStyleOption(&shown, index);
    const TextLine line = tonedLine(index);
    QTextLayout layout;
    const double height = layOut(layout, line, shown, widthFor(shown, index));
    const QPointF within = place - textCorner(shown, height);
    for (int row = 0; row < layout.lineCount(); ++row) {
        const QTextLine text = layout.lineAt(row);
        if (!text.naturalTextRect().contains(within))
            continue;
        int at = text.xToCursor(within.x(), QTextLine::CursorOnCharacter);
        for (const TextPart& part : line.parts) {
            if (at < part.text.size())
                return part.tone;
            at -= static_cast<int>(part.text.size());
        }
    }
    return TextTone::Plain;
}

}  // namespace planewright
