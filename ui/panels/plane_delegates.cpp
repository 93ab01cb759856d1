// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/plane_delegates.h"

#include <algorithm>

#include <QComboBox>
#include <QPainter>

#include "core/types/plane_words.h"
#include "ui/models/model_roles.h"

namespace planewright {

void SwatchDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    // Styles mix the colour of a selection into pictures of which they are given none for it.
    if (!option->icon.isNull())
        option->icon.addPixmap(option->icon.pixmap(option->decorationSize), QIcon::Selected);
}

void LimitBarDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyledItemDelegate::paint(painter, option, index);
    const QVariant value = index.data(kSortRole);
    const double limit = index.data(kLimitRole).toDouble();
    if (!value.isValid() || !(limit > 0.0))
        return;
    constexpr int kHeight = 3;  // [px]
    constexpr int kMargin = 4;  // [px]
    const double share = value.toDouble() / limit;
    const QRect track(option.rect.left() + kMargin, option.rect.bottom() - kHeight, option.rect.width() - 2 * kMargin,
                      kHeight);
    QRectF bar(track);
    bar.setWidth(track.width() * std::clamp(share, 0.0, 1.0));
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    const QColor colour = option.palette.color(chosen ? QPalette::HighlightedText : QPalette::WindowText);
    QColor faint = colour;
    faint.setAlphaF(0.2F);
    painter->fillRect(track, faint);
    painter->fillRect(bar, share > 1.0 ? QBrush(colour, Qt::Dense4Pattern) : QBrush(colour));
}

QWidget* ClassDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const
{
    auto* box = new QComboBox(parent);
    box->setObjectName(QStringLiteral("classEditor"));
    box->setAccessibleName(tr("Class"));
    box->setEditable(true);
    for (const std::string_view name : kPlaneClasses)
        box->addItem(QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())));
    return box;
}

void ClassDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    static_cast<QComboBox*>(editor)->setEditText(index.data(Qt::EditRole).toString());
}

void ClassDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const
{
    model->setData(index, static_cast<QComboBox*>(editor)->currentText().trimmed());
}

}  // namespace planewright
