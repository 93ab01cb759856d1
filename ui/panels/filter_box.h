// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <optional>

#include <QLineEdit>
#include <QWidget>

#include "ui/models/row_filter.h"

namespace planewright {

class ProblemLabel;
class UnderlinedEdit;

/// A line for queries that shows what is wrong with one by a wavy line under the place and a sentence below: never by a
/// dialog.
class FilterBox : public QWidget {
    Q_OBJECT

public:
    /// What takes a query and gives what is wrong with it.
    using Taker = std::function<std::optional<FilterProblem>(const QString&)>;

    FilterBox(const QString& name, const QString& placeholder, Taker taker, QWidget* parent = nullptr);

    QString query() const;
    void setQuery(const QString& query);
    QLineEdit* edit() const;

    /// The sentence shown, or nothing.
    QString problem() const;

    /// Asks the taker again, as when it looks through something else.
    void apply();

signals:
    /// A query that the taker took.
    void applied(const QString& query);

private:
    UnderlinedEdit* edit_;
    ProblemLabel* reason_;
    Taker taker_;
};

}  // namespace planewright
