// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/decisions_model.h"

#include "ui/models/model_roles.h"
#include "ui/models/number_text.h"

namespace planewright {

namespace {

/// An index knows the rows above it: 0 of a phase, then the phase from 1, and above these bits the decision from 1.
constexpr int kPhaseBits = 8;
constexpr quintptr kPhaseMask = (1U << kPhaseBits) - 1;

quintptr idBelow(int phase, int decision = -1)
{
    return static_cast<quintptr>(phase + 1) | static_cast<quintptr>(decision + 1) << kPhaseBits;
}

int phaseRow(const QModelIndex& index)
{
    return index.internalId() == 0 ? index.row() : static_cast<int>(index.internalId() & kPhaseMask) - 1;
}

/// −1 of a phase.
int decisionRow(const QModelIndex& index)
{
    if (index.internalId() == 0)
        return -1;
    const auto above = static_cast<int>(index.internalId() >> kPhaseBits);
    return above == 0 ? index.row() : above - 1;
}

bool isTestRow(const QModelIndex& index)
{
    return (index.internalId() >> kPhaseBits) != 0;
}

/// Short times have a digit more: no phase takes 0 ms.
QString millisecondsText(std::chrono::nanoseconds time)
{
    const double milliseconds = std::chrono::duration<double, std::milli>(time).count();
    return QStringLiteral("%1 ms").arg(numberText(milliseconds, milliseconds < 1.0 ? 2 : 1));
}

}  // namespace

void DecisionsModel::setStep(std::optional<InspectedStep> step)
{
    beginResetModel();
    step_ = std::move(step);
    phases_ = step_ ? phasesOf(*step_) : std::vector<InspectedPhase>{};
    endResetModel();
}

void DecisionsModel::setLengthStyle(const LengthStyle& lengths)
{
    if (lengths == lengths_)
        return;
    beginResetModel();
    lengths_ = lengths;
    endResetModel();
}

void DecisionsModel::setShownPhase(std::optional<std::size_t> number)
{
    if (number == shown_)
        return;
    shown_ = number;
    if (!phases_.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, 0));
}

QModelIndex DecisionsModel::indexOfPhase(std::size_t number) const
{
    for (std::size_t row = 0; row < phases_.size(); ++row) {
        if (phases_[row].number == number)
            return index(static_cast<int>(row), 0);
    }
    return {};
}

const InspectedPhase* DecisionsModel::phaseAt(const QModelIndex& index) const
{
    return index.isValid() ? &phases_[static_cast<std::size_t>(phaseRow(index))] : nullptr;
}

const Decision* DecisionsModel::decisionAt(const QModelIndex& index) const
{
    const InspectedPhase* phase = phaseAt(index);
    const int row = phase == nullptr ? -1 : decisionRow(index);
    return row < 0 ? nullptr : &phase->decisions[static_cast<std::size_t>(row)];
}

const Test* DecisionsModel::testAt(const QModelIndex& index) const
{
    const Decision* decision = decisionAt(index);
    return decision == nullptr || !isTestRow(index) ? nullptr : &decision->tests[static_cast<std::size_t>(index.row())];
}

std::string_view DecisionsModel::parameterAt(const QModelIndex& index) const
{
    const Test* test = testAt(index);
    const TestWords* words = test == nullptr ? nullptr : wordsFor(test->name, aboutOf(*decisionAt(index)));
    return words == nullptr ? std::string_view{} : words->parameters.front();
}

QModelIndex DecisionsModel::index(int row, int column, const QModelIndex& parent) const
{
    if (row < 0 || column != 0 || row >= rowCount(parent))
        return {};
    if (!parent.isValid())
        return createIndex(row, 0, quintptr{0});
    return decisionRow(parent) < 0 ? createIndex(row, 0, idBelow(parent.row()))
                                   : createIndex(row, 0, idBelow(phaseRow(parent), decisionRow(parent)));
}

QModelIndex DecisionsModel::parent(const QModelIndex& index) const
{
    if (!index.isValid() || index.internalId() == 0)
        return {};
    const int phase = phaseRow(index);
    return isTestRow(index) ? createIndex(decisionRow(index), 0, idBelow(phase)) : createIndex(phase, 0, quintptr{0});
}

int DecisionsModel::rowCount(const QModelIndex& parent) const
{
    if (!parent.isValid())
        return static_cast<int>(phases_.size());
    if (isTestRow(parent))
        return 0;
    const Decision* decision = decisionAt(parent);
    return static_cast<int>(decision == nullptr ? phaseAt(parent)->decisions.size() : decision->tests.size());
}

int DecisionsModel::columnCount(const QModelIndex& /*parent*/) const
{
    return 1;
}

QVariant DecisionsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    switch (role) {
        case Qt::DisplayRole:
            return lineAt(index).plain();
        case kLineRole:
            return QVariant::fromValue(lineAt(index));
        case Qt::ToolTipRole:
            return tipAt(index);
        default:
            return {};
    }
}

DecisionContext DecisionsModel::contextOf(const InspectedPhase& phase, std::size_t decision) const
{
    return {phase.after.get(), setFreeBySplit(phase.decisions, decision), lengths_};
}

TextLine DecisionsModel::phaseLine(const InspectedPhase& phase) const
{
    TextLine line;
    const QString title = phaseTitle(phase.phase, phase.pass);
    if (!phase.number) {
        const bool comes = step_->planned == 0 || *phase.next < step_->planned;
        line.add(QStringLiteral("%1: %2").arg(title, comes ? tr("next at step %1").arg(stepText(*phase.next))
                                                           : tr("no more before the last pass")),
                 TextTone::Faint);
        return line;
    }
    if (phase.number == shown_)
        line.add(QStringLiteral("▶ "), TextTone::Mark);
    line.add(title, TextTone::Strong);
    line.add(QStringLiteral("  ") + phaseResult(phase.phase, phase.after->report.counts, phase.decisions));
    if (phase.time.count() > 0)
        line.add(QStringLiteral("  ") + millisecondsText(phase.time), TextTone::Faint);
    if (phase.number == shown_)
        line.add(QStringLiteral("  ") + tr("shown in 3D"), TextTone::Mark);
    return line;
}

TextLine DecisionsModel::lineAt(const QModelIndex& index) const
{
    const InspectedPhase& phase = *phaseAt(index);
    const Decision* decision = decisionAt(index);
    if (decision == nullptr)
        return phaseLine(phase);
    if (const Test* test = testAt(index))
        return testLine(*test, aboutOf(*decision), lengths_);
    return decisionLine(*decision, contextOf(phase, static_cast<std::size_t>(index.row())));
}

QString DecisionsModel::tipAt(const QModelIndex& index) const
{
    const Decision* decision = decisionAt(index);
    if (decision == nullptr)
        return phaseAt(index)->number ? tr("Enter or a double click shows the scan as it was after this phase.")
                                      : tr("This phase is not due at this step.");
    if (const Test* test = testAt(index)) {
        const QString meaning = meaningOf(*test, aboutOf(*decision));
        return parameterAt(index).empty() ? meaning : meaning + '\n' + tr("Enter or a double click shows it in Setup.");
    }
    QStringList lines{decisionHead(*decision)};
    for (const Test& test : decision->tests) {
        const TestText text = textOf(test, aboutOf(*decision), lengths_);
        lines << verdictMark(text.pass) + ' ' + text.text();
    }
    return lines.join('\n');
}

QString DecisionsModel::rowsAsText(const QModelIndexList& rows) const
{
    QString text = tr("Step\tPhase\tDecision\tCondition\tValue\tComparison\tLimit\tUnit\tHolds\n");
    if (!step_)
        return text;
    const QString step = stepText(step_->snapshot->report.step);
    const auto line = [&](const QStringList& cells) {
        QStringList all = cells;
        all.resize(8);
        text += step + '\t' + all.join('\t') + '\n';
    };
    const auto testCells = [&](const Test& test, const Decision& decision, QStringList cells) {
        const TestText words = textOf(test, aboutOf(decision), lengths_);
        line(cells << words.symbol << words.value << words.comparison << words.limit << words.unit
                   << (words.pass ? QStringLiteral("yes") : QStringLiteral("no")));
    };
    for (const QModelIndex& row : rows) {
        const InspectedPhase& phase = *phaseAt(row);
        const QString title = phaseTitle(phase.phase, phase.pass);
        const Decision* decision = decisionAt(row);
        if (decision == nullptr) {
            line({title, phase.number ? phaseResult(phase.phase, phase.after->report.counts, phase.decisions)
                                      : phaseLine(phase).plain()});
            continue;
        }
        const QModelIndex own = isTestRow(row) ? row.parent() : row;
        const DecisionContext context = contextOf(phase, static_cast<std::size_t>(own.row()));
        const QStringList head{title, decisionHead(*decision, context) + splitOutcome(*decision, context)};
        if (const Test* test = testAt(row)) {
            testCells(*test, *decision, head);
            continue;
        }
        if (decision->tests.empty())
            line(head);
        for (const Test& test : decision->tests)
            testCells(test, *decision, head);
    }
    return text;
}

}  // namespace planewright
