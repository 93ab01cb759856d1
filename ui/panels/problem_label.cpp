// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/problem_label.h"

#include <QEvent>

#include "ui/panels/underlined_edit.h"

namespace planewright {

ProblemLabel::ProblemLabel(QWidget* parent) : QLabel(parent)
{
    setObjectName(QStringLiteral("problem"));
    setAccessibleName(QStringLiteral("What is wrong"));
    setWordWrap(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    colour();
    hide();
}

void ProblemLabel::tell(const QString& problem)
{
    setText(problem);
    setVisible(!problem.isEmpty());
}

void ProblemLabel::changeEvent(QEvent* event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::ParentChange)
        colour();
}

void ProblemLabel::colour()
{
    const QColor wrong = wrongColour(palette());
    if (palette().color(foregroundRole()) == wrong)
        return;
    QPalette own = palette();
    own.setColor(foregroundRole(), wrong);
    setPalette(own);
}

}  // namespace planewright
