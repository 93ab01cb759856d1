// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>
#include <vector>

#include <QAbstractItemModel>
#include <QString>

#include "ui/models/model_roles.h"

namespace planewright {

/// A word that queries may ask for, and the cell that answers.
struct FilterKey {
    enum class Kind { Number, Text };
    const char* name;
    Kind kind;
    int column;
    int role = kSortRole;
};

/// What is wrong with a query, and where.
struct FilterProblem {
    int position = 0;  ///< first character
    int length = 0;
    QString reason;  ///< a sentence
};

/// A query over the rows of a table: `class:wall area>2 E<1 born<50` and plain text; a row has to fulfil all of it.
///
/// Numbers go with < <= > >= = and !=, in the unit of the column's heading, with a decimal point. Texts go with a
/// colon: one of the cell's words begins with it. Plain text is found anywhere in the row's words. Capitals do not
/// matter; what contains blanks goes in quotes: `name:"left wall"`. What a row does not know fulfils nothing.
class RowFilter {
public:
    RowFilter() = default;

    /// Reads a query; gives what is wrong with it, and then the filter is as it was.
    std::optional<FilterProblem> setQuery(const QString& query, std::span<const FilterKey> keys);

    bool acceptsAll() const { return terms_.empty(); }
    bool accepts(const QAbstractItemModel& model, int row, const QModelIndex& parent) const;

private:
    enum class Comparison { Less, LessEqual, Greater, GreaterEqual, Equal, Unequal };
    struct Term {
        std::optional<FilterKey> key;  ///< none for plain text
        Comparison comparison = Comparison::Equal;
        double number = 0.0;
        QString text;
    };
    friend class FilterReader;

    static bool holds(const Term& term, double value);

    std::vector<Term> terms_;
};

}  // namespace planewright
