// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/parameter_group_box.h"

#include <algorithm>

#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/parameter_field.h"

namespace planewright {

ParameterGroupBox::ParameterGroupBox(ParameterModel& model, const ParameterGroup& group, QWidget* parent)
    : QWidget(parent), model_(model), title_(group.title), header_(new QToolButton(this)), body_(new QWidget(this))
{
    header_->setObjectName(QStringLiteral("group"));
    header_->setCheckable(true);
    header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    header_->setAutoRaise(true);
    header_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QFont bold = header_->font();
    bold.setBold(true);
    header_->setFont(bold);
    auto* rows = new QVBoxLayout(body_);
    rows->setContentsMargins(8, 0, 0, 4);
    rows->setSpacing(2);
    for (const ParameterRow* row : group.rows) {
        fields_.push_back(new ParameterField(model, *row, body_));
        rows->addWidget(fields_.back());
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->setSpacing(2);
    layout->addWidget(header_);
    layout->addWidget(body_);
    connect(header_, &QToolButton::toggled, this, &ParameterGroupBox::setOpen);
    setOpen(false);
    refresh();
}

void ParameterGroupBox::setOpen(bool open)
{
    header_->setChecked(open);
    header_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    body_->setVisible(open);
}

void ParameterGroupBox::refresh()
{
    for (ParameterField* field : fields_)
        field->refresh();
    const auto changed = std::count_if(fields_.begin(), fields_.end(),
                                       [this](const ParameterField* field) { return model_.isChanged(field->key()); });
    header_->setText(changed == 0 ? title_ : tr("%1 (%2 changed)").arg(title_).arg(changed));
    header_->setAccessibleName(header_->text());
}

}  // namespace planewright
