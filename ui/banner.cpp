// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/banner.h"

#include <QHBoxLayout>

namespace planewright {

Banner::Banner(QWidget* parent)
    : QFrame(parent),
      text_(new QLabel(this)),
      first_(new QPushButton(this)),
      second_(new QPushButton(this)),
      dismiss_(new QPushButton(tr("Dismiss"), this))
{
    setObjectName(QStringLiteral("banner"));
    setAccessibleName(tr("Message"));
    setFrameShape(QFrame::StyledPanel);
    text_->setObjectName(QStringLiteral("bannerText"));
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    first_->setObjectName(QStringLiteral("bannerFirst"));
    second_->setObjectName(QStringLiteral("bannerSecond"));
    dismiss_->setObjectName(QStringLiteral("bannerDismiss"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->addWidget(text_, 1);
    for (QPushButton* button : {first_, second_, dismiss_}) {
        button->setMinimumHeight(28);
        layout->addWidget(button);
    }
    connect(dismiss_, &QPushButton::clicked, this, &QWidget::hide);
    hide();
}

void Banner::showMessage(Kind kind, const QString& text, const std::vector<Choice>& choices)
{
    const bool problem = kind == Kind::Problem;
    // White on these is 5.6:1 and 7.2:1.
    setStyleSheet(QStringLiteral("#banner { background: %1; } #bannerText { color: white; }")
                      .arg(problem ? QStringLiteral("#b3261e") : QStringLiteral("#1f4e8c")));
    text_->setText((problem ? QStringLiteral("▲ ") : QStringLiteral("● ")) + text);
    const auto fill = [this, &choices](QPushButton* button, std::size_t place) {
        button->disconnect();
        button->setVisible(place < choices.size());
        if (place >= choices.size())
            return;
        button->setText(choices[place].first);
        connect(button, &QPushButton::clicked, this, [this, action = choices[place].second] {
            hide();
            action();
        });
    };
    fill(first_, 0);
    fill(second_, 1);
    show();
}

QString Banner::text() const
{
    return text_->text();
}

}  // namespace planewright
