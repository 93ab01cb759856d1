// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/inspector_panel.h"

#include <algorithm>
#include <numeric>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTextDocumentFragment>
#include <QVBoxLayout>

#include "ui/models/number_text.h"
#include "ui/panels/decision_tree.h"

namespace planewright {

namespace {

/// A scanner with 40 slices a second gives a step so much time.
constexpr double kStepTime = 25.0;  // [ms]

QString headerLine(const InspectedStep& step)
{
    const StepReport& report = step.snapshot->report;
    if (report.step < 0)
        return QObject::tr("<b>Last pass</b> after step %1").arg(step.newest + 1);
    const int all = std::max(step.planned, step.newest + 1);
    QString line =
        QObject::tr("<b>Step %1 of %2</b> &nbsp; φ %3°").arg(report.step + 1).arg(all).arg(angleText(report.tilt));
    if (step.time)
        line += QStringLiteral(" &nbsp; %1 s").arg(numberText(std::chrono::duration<double>(*step.time).count(), 2));
    return line;
}

QString headerText(const InspectedStep& step)
{
    const StepReport& report = step.snapshot->report;
    const StepCounts& counts = report.counts;
    QString text = headerLine(step);
    const auto elapsed = std::accumulate(report.times.begin(), report.times.end(), std::chrono::nanoseconds{0});
    const double milliseconds = std::chrono::duration<double, std::milli>(elapsed).count();
    if (elapsed.count() > 0 && report.step < 0)
        text += QStringLiteral(" &nbsp; %1 ms").arg(numberText(milliseconds, 1));
    else if (elapsed.count() > 0)
        text += QStringLiteral(" &nbsp; %1%2 of 25 ms%3")
                    .arg(milliseconds > kStepTime ? QStringLiteral("<b>▲ ") : QString{}, numberText(milliseconds, 1),
                         milliseconds > kStepTime ? QStringLiteral("</b>") : QString{});
    if (report.step >= 0)
        text += QObject::tr("<br>%1, %2: %3 assigned, %4 clustered")
                    .arg(countText(counts.returns, QObject::tr("return"), QObject::tr("returns")),
                         countText(counts.segments, QObject::tr("segment"), QObject::tr("segments")))
                    .arg(counts.assigned)
                    .arg(counts.clustered);
    text += QObject::tr("<br>So far %1: %2 fitted, %3 unfitted; %4, mean E %5")
                .arg(countText(counts.fitted + counts.unfitted, QObject::tr("segment"), QObject::tr("segments")))
                .arg(counts.fitted)
                .arg(counts.unfitted)
                .arg(countText(counts.planes, QObject::tr("plane"), QObject::tr("planes")), meanErrorText(counts));
    return text;
}

QPushButton* makeButton(const QString& name, const QString& text, const QString& tip)
{
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    button->setToolTip(tip);
    return button;
}

}  // namespace

InspectorPanel::InspectorPanel(QWidget* parent)
    : QWidget(parent),
      header_(new QLabel(this)),
      play_(makeButton(QStringLiteral("playPhase"), tr("Play phase"), tr("Show the step's next phase in 3D (Alt+.)"))),
      stack_(new QStackedWidget(this)),
      instead_(new QLabel(tr("Choose a step in the timeline."), this)),
      tree_(new DecisionTree(model_, this))
{
    setObjectName(QStringLiteral("inspectorPanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(4);
    header_->setObjectName(QStringLiteral("stepHeader"));
    header_->setAccessibleName(tr("Numbers of the step"));
    header_->setWordWrap(true);
    header_->setTextFormat(Qt::RichText);
    header_->setToolTip(
        tr("Returns and segments of this slice; then all segments of the scan so far. A step should be "
           "over before the next slice comes, which is 25 ms at 40 slices a second."));
    layout->addWidget(header_);

    instead_->setAlignment(Qt::AlignCenter);
    instead_->setWordWrap(true);
    instead_->setObjectName(QStringLiteral("inspectorEmpty"));
    stack_->addWidget(instead_);
    stack_->addWidget(tree_);
    stack_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    layout->addWidget(stack_, 1);

    auto* buttons = new QHBoxLayout;
    auto* whyNot = makeButton(QStringLiteral("whyNotButton"), tr("Why not?…"),
                              tr("Ask why two planes are not one, or a segment is not in a plane (Y)"));
    buttons->addWidget(play_);
    buttons->addWidget(whyNot);
    buttons->addStretch(1);
    layout->addLayout(buttons);
    setFocusProxy(tree_);

    connect(play_, &QPushButton::clicked, this, &InspectorPanel::playPhaseRequested);
    connect(whyNot, &QPushButton::clicked, this, &InspectorPanel::whyNotRequested);
    connect(tree_, &DecisionTree::rowActivated, this, &InspectorPanel::activate);
    connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &InspectorPanel::tellChosen);
    setStep(std::nullopt);
}

void InspectorPanel::setStep(std::optional<InspectedStep> step)
{
    const bool isThere = step.has_value();
    header_->setText(isThere ? headerText(*step) : QString{});
    header_->setVisible(isThere);
    play_->setEnabled(isThere);
    model_.setStep(std::move(step));
    stack_->setCurrentWidget(isThere ? static_cast<QWidget*>(tree_) : instead_);
}

void InspectorPanel::setShownPhase(std::optional<std::size_t> number)
{
    model_.setShownPhase(number);
    if (number)
        tree_->showPhase(*number);
}

QString InspectorPanel::header() const
{
    return QTextDocumentFragment::fromHtml(header_->text()).toPlainText().replace(QChar::Nbsp, ' ');
}

QString InspectorPanel::shownInstead() const
{
    return stack_->currentWidget() == instead_ ? instead_->text() : QString{};
}

void InspectorPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    emit shown();
}

void InspectorPanel::tellChosen()
{
    std::vector<Operand> operands;
    for (const QModelIndex& row : tree_->selectionModel()->selectedRows()) {
        const Decision* decision = model_.decisionAt(row);
        if (decision == nullptr)
            continue;
        operands.insert(operands.end(), decision->operands.begin(), decision->operands.end());
        operands.insert(operands.end(), decision->result.begin(), decision->result.end());
    }
    if (!operands.empty())
        emit operandsChosen(operands);
}

void InspectorPanel::activate(const QModelIndex& index)
{
    const std::string_view parameter = model_.parameterAt(index);
    if (!parameter.empty())
        emit parameterRequested(QString::fromUtf8(parameter.data(), static_cast<qsizetype>(parameter.size())));
    else if (const InspectedPhase* phase = model_.phaseAt(index);
             phase != nullptr && phase->number && model_.decisionAt(index) == nullptr)
        emit phaseRequested(*phase->number);
    else
        tree_->setExpanded(index, !tree_->isExpanded(index));
}

}  // namespace planewright
