// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/parameter_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include "ui/panels/plain_fields.h"
#include "ui/panels/problem_label.h"

namespace planewright {

namespace {

constexpr int kTarget = 28;  // [px]

/// Room for eight digits and the frame [px].
int fieldWidth(const QWidget& widget)
{
    constexpr int kFrame = 14;  // [px]
    return widget.fontMetrics().horizontalAdvance(QStringLiteral("00000000")) + kFrame;
}

QString textOf(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

/// The meaning, what is allowed, and the key that the command line knows.
QString helpOf(const ParameterRow& row)
{
    return QStringLiteral("<p>%1</p><p>Give %2.</p><p><code>%3</code></p>")
        .arg(textOf(row.meaning).toHtmlEscaped(), QString::fromStdString(allowedValues(row)).toHtmlEscaped(),
             textOf(row.key));
}

}  // namespace

ParameterField::ParameterField(ParameterModel& model, const ParameterRow& row, QWidget* parent)
    : QWidget(parent), model_(model), row_(row), reset_(new QToolButton(this)), problem_(new ProblemLabel(this))
{
    const QString name = parameterLabel(row);
    // A word joiner keeps "ρ,0" on one line.
    const QString symbol = parameterSymbol(row).replace(QStringLiteral(","), QStringLiteral(",\u2060"));
    setObjectName(textOf(row.key));
    setToolTip(helpOf(row));
    QWidget* field = makeField();
    field->setObjectName(QStringLiteral("field"));
    field->setAccessibleName(name + (row.unitName.empty() ? QString{} : ", " + textOf(row.unitName)));
    field->setAccessibleDescription(textOf(row.meaning));
    auto* label = new QLabel(symbol.isEmpty() ? name.toHtmlEscaped()
                                              : QStringLiteral("%1 <span style=\"white-space:nowrap\"><i>%2</i></span>")
                                                    .arg(name.toHtmlEscaped(), symbol),
                             this);
    label->setTextFormat(Qt::RichText);
    label->setWordWrap(true);
    label->setBuddy(field);
    auto* unit = new QLabel(parameterUnit(row), this);
    unit->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("m")) + 2);
    reset_->setObjectName(QStringLiteral("reset"));
    reset_->setText(QStringLiteral("↺"));
    reset_->setAutoRaise(true);
    reset_->setFixedSize(kTarget, kTarget);
    reset_->setAccessibleName(tr("Reset %1").arg(name));
    QSizePolicy policy = reset_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    reset_->setSizePolicy(policy);

    auto* grid = new QGridLayout(this);
    grid->setContentsMargins({});
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(0);
    grid->addWidget(label, 0, 0);
    grid->addWidget(field, 0, 1);
    grid->addWidget(unit, 0, 2);
    grid->addWidget(reset_, 0, 3);
    grid->addWidget(problem_, 1, 0, 1, 4);
    grid->setColumnStretch(0, 1);
    connect(reset_, &QToolButton::clicked, this, [this] {
        model_.reset(row_.key);
        refresh();
        focusField();  // the arrow that had the keyboard is gone now
    });
    refresh();
}

QWidget* ParameterField::makeField()
{
    if (row_.unit == Unit::Switch) {
        toggle_ = new QCheckBox(this);
        toggle_->setFixedWidth(fieldWidth(*this));
        connect(toggle_, &QCheckBox::clicked, this,
                [this](bool on) { take(on ? QStringLiteral("true") : QStringLiteral("false")); });
        return toggle_;
    }
    if (!row_.choices.empty()) {
        choices_ = new QuietComboBox(this);
        for (const std::string_view choice : row_.choices)
            choices_->addItem(textOf(choice));
        choices_->setMinimumWidth(fieldWidth(*this));
        connect(choices_, &QComboBox::textActivated, this, &ParameterField::take);
        return choices_;
    }
    edit_ = new QLineEdit(this);
    edit_->setFixedWidth(fieldWidth(*this));
    edit_->setAlignment(Qt::AlignRight);
    connect(edit_, &QLineEdit::textEdited, this, &ParameterField::check);
    connect(edit_, &QLineEdit::editingFinished, this, [this] { take(edit_->text()); });
    return edit_;
}

QString ParameterField::problem() const
{
    return problem_->text();
}

void ParameterField::check(const QString& text)
{
    problem_->tell(model_.problemOf(row_.key, text));
}

void ParameterField::take(const QString& text)
{
    const QString problem = model_.setText(row_.key, text);
    problem_->tell(problem);
    if (!problem.isEmpty())
        return;
    if (edit_ != nullptr)
        edit_->setModified(false);
    refresh();
}

void ParameterField::refresh()
{
    const QString text = model_.text(row_.key);
    if (toggle_ != nullptr)
        toggle_->setChecked(text == QStringLiteral("true"));
    else if (choices_ != nullptr)
        choices_->setCurrentText(text);
    else if (text != shown_ || (problem_->text().isEmpty() && !(edit_->hasFocus() && edit_->isModified())))
        edit_->setText(text);  // otherwise the user is about to write something else
    if (edit_ == nullptr || edit_->text() == text)
        problem_->tell({});
    shown_ = text;
    const bool changed = model_.isChanged(row_.key);
    reset_->setVisible(changed);
    reset_->setToolTip(tr("Back to the preset “%1”").arg(model_.preset()));
}

void ParameterField::focusField()
{
    QWidget* field = toggle_ != nullptr    ? static_cast<QWidget*>(toggle_)
                     : choices_ != nullptr ? static_cast<QWidget*>(choices_)
                                           : edit_;
    field->setFocus(Qt::OtherFocusReason);
}

}  // namespace planewright
