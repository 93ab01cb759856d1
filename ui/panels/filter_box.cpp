// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/filter_box.h"

#include <QVBoxLayout>

#include "ui/panels/problem_label.h"
#include "ui/panels/underlined_edit.h"

namespace planewright {

FilterBox::FilterBox(const QString& name, const QString& placeholder, Taker taker, QWidget* parent)
    : QWidget(parent), edit_(new UnderlinedEdit(this)), reason_(new ProblemLabel(this)), taker_(std::move(taker))
{
    edit_->setObjectName(QStringLiteral("filter"));
    edit_->setAccessibleName(name);
    edit_->setPlaceholderText(placeholder);
    edit_->setClearButtonEnabled(true);
    setFocusProxy(edit_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->setSpacing(2);
    layout->addWidget(edit_);
    layout->addWidget(reason_);
    connect(edit_, &QLineEdit::textChanged, this, &FilterBox::apply);
}

QString FilterBox::query() const
{
    return edit_->text();
}

void FilterBox::setQuery(const QString& query)
{
    edit_->setText(query);
}

QLineEdit* FilterBox::edit() const
{
    return edit_;
}

QString FilterBox::problem() const
{
    return reason_->text();
}

void FilterBox::apply()
{
    const auto problem = taker_(edit_->text());
    edit_->underline(problem ? problem->position : 0, problem ? problem->length : 0);
    reason_->tell(problem ? problem->reason : QString{});
    edit_->setAccessibleDescription(reason_->text());
    if (!problem)
        emit applied(edit_->text());
}

}  // namespace planewright
