// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QStyledItemDelegate>
#include <QTextLayout>

#include "ui/models/decision_text.h"

namespace planewright {

/// Draws cells that answer kLineRole: words with tones, over as many lines as it takes where there is a width for it.
class LineDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

    /// The tone of what is under a place in a cell; plain where nothing is.
    TextTone toneAt(const QStyleOptionViewItem& option, const QModelIndex& index, const QPoint& place) const;

    /// How a tone is drawn on a palette's base; on a selection all but its weight is of the selection.
    static QTextCharFormat formatOf(TextTone tone, const QPalette& palette, bool selected);
};

}  // namespace planewright
