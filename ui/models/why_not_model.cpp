// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/why_not_model.h"

#include <algorithm>

#include "ui/models/model_roles.h"

namespace planewright {

namespace {

/// "Merge: 2 of 5 conditions fail"
QString wayText(const Conditions& way)
{
    const auto failed =
        std::count_if(way.tests.begin(), way.tests.end(), [](const Test& test) { return !test.pass(); });
    const auto all = way.tests.size();
    const QString title = wayTitle(way.name);
    if (failed == 0)
        return all == 1 ? QStringLiteral("%1: its condition holds").arg(title)
                        : QStringLiteral("%1: all %2 conditions hold").arg(title).arg(all);
    return QStringLiteral("%1: %2 of %3 fail").arg(title).arg(failed).arg(all);
}

}  // namespace

void WhyNotModel::setAnswer(std::optional<WhyNot> answer)
{
    beginResetModel();
    answer_ = std::move(answer);
    rows_.clear();
    if (answer_) {
        for (std::size_t way = 0; way < answer_->ways.size(); ++way) {
            rows_.push_back({way, std::nullopt});
            for (std::size_t test = 0; test < answer_->ways[way].tests.size(); ++test)
                rows_.push_back({way, test});
        }
    }
    endResetModel();
}

void WhyNotModel::setLengthStyle(const LengthStyle& lengths)
{
    if (lengths == lengths_)
        return;
    beginResetModel();
    lengths_ = lengths;
    endResetModel();
}

std::string_view WhyNotModel::parameterAt(int row) const
{
    if (isWay(row))
        return {};
    const TestWords* words = wordsFor(testAt(row).name, aboutAt(row));
    return words == nullptr ? std::string_view{} : words->parameters.front();
}

QString WhyNotModel::rowsAsText(const QModelIndexList& rows) const
{
    QString text = tr("Way\tCondition\tValue\tComparison\tLimit\tHolds\n");
    for (const QModelIndex& index : rows) {
        const int row = index.row();
        const bool pass = isWay(row) ? wayAt(row).pass() : testAt(row).pass();
        QStringList cells{wayTitle(wayAt(row).name)};
        for (const WhyNotColumn column :
             {WhyNotColumn::Condition, WhyNotColumn::Value, WhyNotColumn::Comparison, WhyNotColumn::Limit})
            cells << (isWay(row) ? QString{} : textAt(row, column));
        text += (cells << (pass ? QStringLiteral("yes") : QStringLiteral("no"))).join('\t') + '\n';
    }
    return text;
}

int WhyNotModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int WhyNotModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kWhyNotColumns;
}

QString WhyNotModel::textAt(int row, WhyNotColumn column) const
{
    if (isWay(row)) {
        const Conditions& way = wayAt(row);
        return column == WhyNotColumn::Condition ? wayText(way) + ' ' + verdictMark(way.pass()) : QString{};
    }
    const TestText text = textOf(testAt(row), aboutAt(row), lengths_);
    const auto withUnit = [&text](const QString& number) {
        return text.unit.isEmpty() ? number : number + (text.unit == QStringLiteral("°") ? "" : " ") + text.unit;
    };
    switch (column) {
        case WhyNotColumn::Condition:
            return text.symbol;
        case WhyNotColumn::Value:
            return withUnit(text.value);
        case WhyNotColumn::Comparison:
            return text.comparison;
        case WhyNotColumn::Limit:
            return withUnit(text.limit);
        case WhyNotColumn::Verdict:
            break;
    }
    return verdictMark(text.pass);
}

TextTone WhyNotModel::toneAt(int row, WhyNotColumn column) const
{
    if (isWay(row))
        return TextTone::Strong;
    const bool pass = testAt(row).pass();
    if (column == WhyNotColumn::Verdict)
        return pass ? TextTone::Pass : TextTone::Fail;
    return !pass && column == WhyNotColumn::Value ? TextTone::Fail : TextTone::Plain;
}

QVariant WhyNotModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const int row = index.row();
    const auto column = static_cast<WhyNotColumn>(index.column());
    switch (role) {
        case Qt::DisplayRole:
            return textAt(row, column);
        case kLineRole: {
            TextLine line;
            line.add(textAt(row, column), toneAt(row, column));
            return QVariant::fromValue(line);
        }
        case Qt::AccessibleTextRole:
            return column == WhyNotColumn::Verdict && !isWay(row)
                       ? (testAt(row).pass() ? tr("holds") : tr("does not hold"))
                       : textAt(row, column);
        case Qt::TextAlignmentRole:
            return static_cast<int>(column == WhyNotColumn::Condition ? Qt::AlignLeft | Qt::AlignVCenter
                                    : column == WhyNotColumn::Value   ? Qt::AlignRight | Qt::AlignVCenter
                                    : column == WhyNotColumn::Limit   ? Qt::AlignLeft | Qt::AlignVCenter
                                                                      : Qt::AlignCenter);
        case Qt::ToolTipRole:
            if (isWay(row))
                return tr("One of the ways; it is taken when all its conditions hold and its turn comes.");
            return meaningOf(testAt(row), aboutAt(row)) +
                   (parameterAt(row).empty() ? QString{} : '\n' + tr("Enter or a double click shows it in Setup."));
        default:
            return {};
    }
}

QVariant WhyNotModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (static_cast<WhyNotColumn>(section)) {
        case WhyNotColumn::Condition:
            return tr("Condition");
        case WhyNotColumn::Value:
            return tr("Value");
        case WhyNotColumn::Limit:
            return tr("Limit");
        case WhyNotColumn::Comparison:
        case WhyNotColumn::Verdict:
            break;
    }
    return QString{};
}

}  // namespace planewright
