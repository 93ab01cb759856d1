// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/filtered_table.h"

#include <algorithm>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/panels/filter_box.h"

namespace planewright {

namespace {

constexpr int kRowHeight = 28;  // [px], the least target

QTableView* makeView(const TableTexts& texts, QWidget* parent)
{
    auto* view = new QTableView(parent);
    view->setObjectName(texts.objectName);
    view->setAccessibleName(texts.accessibleName);
    view->setSelectionBehavior(QAbstractItemView::SelectRows);
    view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view->setSortingEnabled(true);
    view->setAlternatingRowColors(true);
    view->setShowGrid(false);
    view->setWordWrap(false);
    view->setTabKeyNavigation(false);  // Tab leaves the table; arrows move in it
    view->setMouseTracking(true);
    view->verticalHeader()->hide();
    view->verticalHeader()->setDefaultSectionSize(std::max(kRowHeight, view->fontMetrics().height() + 8));
    view->horizontalHeader()->setHighlightSections(false);
    view->horizontalHeader()->setSectionsMovable(true);
    view->horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
    view->horizontalHeader()->setMinimumSectionSize(kRowHeight);
    return view;
}

QLabel* makeInstead(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setObjectName(QStringLiteral("emptyText"));
    label->setAlignment(Qt::AlignCenter);
    label->setWordWrap(true);
    label->setTextFormat(Qt::RichText);
    label->setTextInteractionFlags(Qt::TextBrowserInteraction);
    label->setContentsMargins(12, 12, 12, 12);
    return label;
}

}  // namespace

FilteredTable::FilteredTable(QAbstractItemModel* model, std::span<const FilterKey> keys, const TableTexts& texts,
                             const std::vector<int>& defaultColumns, QWidget* parent)
    : QWidget(parent),
      top_(new QHBoxLayout),
      rows_(new FilterProxyModel(keys, this)),
      filter_(new FilterBox(
          texts.filterName, texts.filterPlaceholder, [this](const QString& query) { return setQuery(query); }, this)),
      stack_(new QStackedWidget(this)),
      view_(makeView(texts, this)),
      instead_(makeInstead(this)),
      footer_(new QLabel(this)),
      copyAction_(new QAction(tr("Copy rows"), this)),
      emptyText_(texts.emptyText),
      defaultColumns_(defaultColumns)
{
    rows_->setSourceModel(model);
    view_->setModel(rows_);
    view_->sortByColumn(0, Qt::AscendingOrder);
    stack_->addWidget(view_);
    stack_->addWidget(instead_);
    footer_->setObjectName(QStringLiteral("footer"));
    footer_->setAccessibleName(tr("Totals"));
    footer_->setWordWrap(true);
    footer_->hide();
    for (int column = 0; column < model->columnCount(); ++column)
        setColumnShown(column, std::find(defaultColumns.begin(), defaultColumns.end(), column) != defaultColumns.end());

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(6);
    top_->addWidget(filter_, 1, Qt::AlignTop);
    layout->addLayout(top_);
    layout->addWidget(stack_, 1);
    layout->addWidget(footer_);

    copyAction_->setObjectName(QStringLiteral("actCopyRows"));
    addTableAction(copyAction_, QKeySequence::Copy);
    view_->setContextMenuPolicy(Qt::ActionsContextMenu);
    view_->installEventFilter(this);
    connect(copyAction_, &QAction::triggered, this, [this] { QGuiApplication::clipboard()->setText(rowsAsText()); });
    connect(view_->horizontalHeader(), &QWidget::customContextMenuRequested, this, &FilteredTable::showColumnMenu);
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        if (!filtering_)
            emit chosenChanged();
    });
    connect(filter_, &FilterBox::applied, this, &FilteredTable::showWhatFits);
    // The proxy lets go of rows before its source has; only the source's own signal knows that none is left.
    for (const QAbstractItemModel* changing : {static_cast<QAbstractItemModel*>(rows_), model}) {
        connect(changing, &QAbstractItemModel::rowsInserted, this, &FilteredTable::showWhatFits);
        connect(changing, &QAbstractItemModel::rowsRemoved, this, &FilteredTable::showWhatFits);
    }
    connect(rows_, &QAbstractItemModel::modelReset, this, &FilteredTable::showWhatFits);
    connect(rows_, &QAbstractItemModel::dataChanged, this, &FilteredTable::rowsChanged);
    connect(instead_, &QLabel::linkActivated, this, [this](const QString& link) {
        if (link == QStringLiteral("clear"))
            filter_->setQuery({});
        else
            emit linkActivated(link);
    });
    showWhatFits();
}

std::optional<FilterProblem> FilteredTable::setQuery(const QString& query)
{
    filtering_ = true;
    auto problem = rows_->setQuery(query + ' ' + requirement_);
    filtering_ = false;
    emit filtered();
    return problem;
}

void FilteredTable::addTableAction(QAction* action, const QKeySequence& keys)
{
    actions_.push_back({action, keys});
    action->setIconText(action->text());
    action->setText(action->text() + '\t' + keys.toString(QKeySequence::NativeText));
    view_->addAction(action);
}

bool FilteredTable::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        const auto* pressed = static_cast<QKeyEvent*>(event);
        for (const TableAction& own : actions_) {
            if (own.keys != QKeySequence(pressed->keyCombination()))
                continue;
            event->accept();  // what is accepted here comes as a key and not as a shortcut of the window
            if (event->type() == QEvent::KeyPress)
                own.action->trigger();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void FilteredTable::setEmptyText(const QString& text)
{
    if (text == emptyText_)
        return;
    emptyText_ = text;
    showWhatFits();
}

void FilteredTable::setFooter(const QString& text)
{
    footer_->setText(text);
    footer_->setVisible(!text.isEmpty());
}

QString FilteredTable::footer() const
{
    return footer_->text();
}

QString FilteredTable::shownInstead() const
{
    return stack_->currentWidget() == instead_ ? instead_->text() : QString{};
}

void FilteredTable::setRequirement(const QString& query)
{
    requirement_ = query;
    filter_->apply();
}

void FilteredTable::showWhatFits()
{
    const bool isEmpty = rows_->rowCount() == 0;
    if (isEmpty) {
        const bool filtered = rows_->sourceModel()->rowCount() > 0 && !filter_->query().isEmpty();
        instead_->setText(filtered ? tr("Nothing matches <code>%1</code>. <a href=\"clear\">Clear filter</a>")
                                         .arg(filter_->query().toHtmlEscaped())
                                   : emptyText_);
    }
    stack_->setCurrentWidget(isEmpty ? static_cast<QWidget*>(instead_) : view_);
    emit rowsChanged();
}

std::vector<int> FilteredTable::chosenRows() const
{
    std::vector<int> chosen;
    for (const QModelIndex& index : view_->selectionModel()->selectedRows())
        chosen.push_back(rows_->mapToSource(index).row());
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

void FilteredTable::choose(const std::vector<int>& modelRows)
{
    QItemSelection selection;
    for (const int row : modelRows) {
        const QModelIndex index = rows_->mapFromSource(rows_->sourceModel()->index(row, 0));
        if (index.isValid())
            selection.select(index, index);
    }
    view_->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    if (!selection.isEmpty())
        view_->scrollTo(selection.first().topLeft());
}

QString FilteredTable::rowsAsText() const
{
    const QHeaderView* header = view_->horizontalHeader();
    std::vector<int> columns;
    for (int place = 0; place < header->count(); ++place) {
        const int column = header->logicalIndex(place);
        if (!header->isSectionHidden(column))
            columns.push_back(column);
    }
    QString text;
    const auto line = [&](const auto& cellOf) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            text += (i == 0 ? "" : "\t") + cellOf(columns[i]).simplified();
        text += '\n';
    };
    line([this](int column) { return rows_->headerData(column, Qt::Horizontal).toString(); });
    const bool all = !view_->selectionModel()->hasSelection();
    for (int row = 0; row < rows_->rowCount(); ++row) {
        if (all || view_->selectionModel()->isRowSelected(row))
            line([&](int column) {
                const QModelIndex index = rows_->index(row, column);
                const QString shown = index.data().toString();
                return shown.isEmpty() ? index.data(Qt::AccessibleTextRole).toString() : shown;
            });
    }
    return text;
}

void FilteredTable::setWidths(const QStringList& samples)
{
    constexpr int kPadding = 9;    // [px]
    constexpr int kSortMark = 12;  // [px]
    QFont bold = view_->font();
    bold.setBold(true);
    const QFontMetrics metrics(bold);
    const QFontMetrics heading(view_->horizontalHeader()->font());
    for (int column = 0; column < static_cast<int>(samples.size()); ++column) {
        const QString title = rows_->headerData(column, Qt::Horizontal).toString();
        const bool sorted = column == view_->horizontalHeader()->sortIndicatorSection();
        view_->setColumnWidth(column, std::max(metrics.horizontalAdvance(samples[column]),
                                               heading.horizontalAdvance(title) + (sorted ? kSortMark : 0)) +
                                          kPadding);
    }
}

void FilteredTable::setColumnShown(int column, bool shown)
{
    view_->setColumnHidden(column, !shown);
}

QByteArray FilteredTable::saveColumns() const
{
    return view_->horizontalHeader()->saveState();
}

bool FilteredTable::restoreColumns(const QByteArray& state)
{
    return view_->horizontalHeader()->restoreState(state);
}

void FilteredTable::showColumnMenu(const QPoint& place)
{
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("columnMenu"));
    const QAbstractItemModel* model = rows_->sourceModel();
    const int shownColumns = model->columnCount() - view_->horizontalHeader()->hiddenSectionCount();
    for (int column = 0; column < model->columnCount(); ++column) {
        const QString title = model->headerData(column, Qt::Horizontal).toString();
        const QString meaning = model->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
        QAction* action = menu.addAction(title.isEmpty() ? meaning : title);
        action->setToolTip(meaning);
        action->setCheckable(true);
        action->setChecked(isColumnShown(column));
        action->setEnabled(!isColumnShown(column) || shownColumns > 1);  // without any there would be no menu
        connect(action, &QAction::toggled, this, [this, column](bool shown) { setColumnShown(column, shown); });
    }
    menu.addSeparator();
    connect(menu.addAction(tr("Default columns")), &QAction::triggered, this, [this, model] {
        for (int column = 0; column < model->columnCount(); ++column)
            setColumnShown(column,
                           std::find(defaultColumns_.begin(), defaultColumns_.end(), column) != defaultColumns_.end());
    });
    menu.setToolTipsVisible(true);
    menu.exec(view_->horizontalHeader()->mapToGlobal(place));
}

}  // namespace planewright
