// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/panels/log_panel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

#include "ui/panels/filtered_table.h"

namespace planewright {

namespace {
constexpr int kReportLines = 200;
}

LogPanel::LogPanel(LogModel& model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      table_(new FilteredTable(&model, logFilterKeys(),
                               {.objectName = QStringLiteral("logTable"),
                                .accessibleName = tr("Log"),
                                .filterName = tr("Filter the log"),
                                .filterPlaceholder = tr("Filter: level:warning source:scanner"),
                                .emptyText = tr("All quiet.")},
                               {0, 1, 2, 3}, this)),
      copy_(new QPushButton(tr("Copy for bug report"), this))
{
    setObjectName(QStringLiteral("logPanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(table_);
    setFocusProxy(table_->view());
    table_->top()->addWidget(copy_, 0, Qt::AlignTop);
    copy_->setObjectName(QStringLiteral("copyBugReport"));
    copy_->setAccessibleName(copy_->text());
    copy_->setToolTip(
        tr("Copies versions, renderer, scanner and the last %1 lines; no contents of files").arg(kReportLines));
    copy_->hide();

    QTableView* view = table_->view();
    view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view->horizontalHeader()->setStretchLastSection(true);
    table_->setWidths({QStringLiteral("00:00:00.000"), QStringLiteral("warning"), QStringLiteral("extraction"), {}});
    view->sortByColumn(-1, Qt::AscendingOrder);  // as they came

    connect(copy_, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(bugReport()); });
    connect(table_->rows(), &QAbstractItemModel::rowsAboutToBeInserted, this, [this] {
        const QScrollBar* bar = table_->view()->verticalScrollBar();
        follows_ = bar->value() == bar->maximum();
    });
    connect(table_->rows(), &QAbstractItemModel::rowsInserted, this, [this] {
        if (follows_)
            table_->view()->scrollToBottom();
    });
}

void LogPanel::setReportHead(std::function<QString()> head)
{
    head_ = std::move(head);
    copy_->setVisible(static_cast<bool>(head_));
}

QString LogPanel::bugReport() const
{
    return (head_ ? head_() : QString{}) + '\n' + model_.lastLines(kReportLines);
}

}  // namespace planewright
