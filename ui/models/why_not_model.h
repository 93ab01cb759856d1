// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <QAbstractTableModel>

#include "ui/models/decision_text.h"

namespace planewright {

enum class WhyNotColumn { Condition, Value, Comparison, Limit, Verdict };
inline constexpr int kWhyNotColumns = 5;

/// All ways in which two planes become one, or a segment joins a plane, with all their conditions: a row for each way,
/// then one for each of its conditions. With its tone a cell's text comes by kLineRole.
class WhyNotModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void setAnswer(std::optional<WhyNot> answer);
    const std::optional<WhyNot>& answer() const { return answer_; }
    void setLengthStyle(const LengthStyle& lengths);

    /// A row that names a way.
    bool isWay(int row) const { return !rows_[static_cast<std::size_t>(row)].test; }
    /// The parameter that sets a condition's limit; empty where there is none.
    std::string_view parameterAt(int row) const;

    /// Rows as tab-separated text with headings, each with its way.
    QString rowsAsText(const QModelIndexList& rows) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Row {
        std::size_t way = 0;
        std::optional<std::size_t> test;
    };

    const Conditions& wayAt(int row) const { return answer_->ways[rows_[static_cast<std::size_t>(row)].way]; }
    const Test& testAt(int row) const { return wayAt(row).tests[*rows_[static_cast<std::size_t>(row)].test]; }
    TestAbout aboutAt(int row) const { return aboutOf(wayAt(row).name, wayAt(row).tests); }
    QString textAt(int row, WhyNotColumn column) const;
    TextTone toneAt(int row, WhyNotColumn column) const;

    std::optional<WhyNot> answer_;
    std::vector<Row> rows_;
    LengthStyle lengths_;
};

}  // namespace planewright
