// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <span>

#include <QAbstractTableModel>
#include <QDateTime>
#include <QString>

#include "ui/models/row_filter.h"

namespace planewright {

enum class LogSeverity { Debug, Info, Warning, Error };

/// One line of the log.
struct LogEntry {
    QDateTime time;  ///< local
    LogSeverity level = LogSeverity::Info;
    QString source;  ///< scanner, extraction, file, …
    QString message;
};

enum class LogColumn { Time, Level, Source, Message };
inline constexpr int kLogColumns = 4;
std::span<const FilterKey> logFilterKeys();

/// What the program has to say, newest last; the oldest lines go when there are too many.
class LogModel : public QAbstractTableModel {
    Q_OBJECT

public:
    explicit LogModel(int mostLines = 10'000, QObject* parent = nullptr);

    void append(const LogEntry& entry);
    void clear();

    /// The newest lines as text, one a line, for a report.
    QString lastLines(int count) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::deque<LogEntry> entries_;
    int mostLines_;
};

}  // namespace planewright
