// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <span>
#include <vector>

#include <QKeySequence>
#include <QTableView>
#include <QWidget>

#include "ui/models/filter_proxy_model.h"

class QAction;
class QLabel;
class QStackedWidget;
class QHBoxLayout;

namespace planewright {

class FilterBox;

/// What a table is called and begins with.
struct TableTexts {
    QString objectName;      ///< of the view
    QString accessibleName;  ///< of the view
    QString filterName;      ///< accessible name of the filter
    QString filterPlaceholder;
    QString emptyText;  ///< while the model has no row; may have links
};

/// A table with a filter above and a line of text below: sorts by its headings, whose menu chooses columns, copies rows
/// as tab-separated text, and says why nothing is to be seen.
class FilteredTable : public QWidget {
    Q_OBJECT

public:
    /// Columns not listed are hidden at first. Model and keys must live as long as this.
    FilteredTable(QAbstractItemModel* model, std::span<const FilterKey> keys, const TableTexts& texts,
                  const std::vector<int>& defaultColumns, QWidget* parent = nullptr);

    QTableView* view() const { return view_; }
    FilterProxyModel* rows() const { return rows_; }
    FilterBox* filter() const { return filter_; }
    /// "Copy rows", `actCopyRows`, Ctrl+C while the table has the keyboard.
    QAction* copyAction() const { return copyAction_; }
    /// Adds an action with keys that mean it while the table has the keyboard, whatever else they mean in the window:
    /// shortcuts of both would be ambiguous, and neither would be done.
    void addTableAction(QAction* action, const QKeySequence& keys);
    /// The line of the filter, for what a panel adds behind it.
    QHBoxLayout* top() const { return top_; }

    void setEmptyText(const QString& text);
    void setFooter(const QString& text);
    QString footer() const;
    /// The text that stands in the table's place, or nothing.
    QString shownInstead() const;

    /// A query that always holds beside the one typed.
    void setRequirement(const QString& query);

    /// Rows of the model that are chosen, from the top.
    std::vector<int> chosenRows() const;
    void choose(const std::vector<int>& modelRows);

    /// The chosen rows, or all rows if none is, as tab-separated text with the headings of the visible columns.
    QString rowsAsText() const;

    /// Makes each column as wide as its heading and a text about as wide as is usual in it.
    void setWidths(const QStringList& samples);
    void setColumnShown(int column, bool shown);
    bool isColumnShown(int column) const { return !view_->isColumnHidden(column); }
    /// Which columns are shown, their order, widths and sorting.
    QByteArray saveColumns() const;
    bool restoreColumns(const QByteArray& state);

signals:
    /// Someone has chosen; not told where a filter only hides what is chosen.
    void chosenChanged();
    /// A query is in force; rows that it brings back are not chosen.
    void filtered();
    /// A link of the empty text other than "clear".
    void linkActivated(const QString& link);
    /// Rows that are seen have changed.
    void rowsChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct TableAction {
        QAction* action;
        QKeySequence keys;
    };

    std::optional<FilterProblem> setQuery(const QString& query);
    void showColumnMenu(const QPoint& place);
    void showWhatFits();

    QHBoxLayout* top_;
    FilterProxyModel* rows_;
    FilterBox* filter_;
    QStackedWidget* stack_;
    QTableView* view_;
    QLabel* instead_;
    QLabel* footer_;
    QAction* copyAction_;
    QString emptyText_;
    QString requirement_;
    std::vector<int> defaultColumns_;
    std::vector<TableAction> actions_;
    bool filtering_ = false;
};

}  // namespace planewright
