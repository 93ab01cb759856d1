// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/log_model.h"

#include <algorithm>
#include <array>

#include <QFont>

namespace planewright {

namespace {

constexpr std::array<FilterKey, 3> kLogKeys{{
    {"level", FilterKey::Kind::Text, static_cast<int>(LogColumn::Level)},
    {"source", FilterKey::Kind::Text, static_cast<int>(LogColumn::Source)},
    {"message", FilterKey::Kind::Text, static_cast<int>(LogColumn::Message)},
}};

QString levelText(LogSeverity level)
{
    static constexpr std::array<const char*, 4> kTexts{"debug", "info", "warning", "error"};
    return QString::fromLatin1(kTexts[static_cast<std::size_t>(level)]);
}

QString cellText(const LogEntry& entry, LogColumn column)
{
    switch (column) {
        case LogColumn::Time:
            return entry.time.toString(QStringLiteral("HH:mm:ss.zzz"));
        case LogColumn::Level:
            return levelText(entry.level);
        case LogColumn::Source:
            return entry.source;
        case LogColumn::Message:
            return entry.message;
    }
    return {};
}

}  // namespace

std::span<const FilterKey> logFilterKeys()
{
    return kLogKeys;
}

LogModel::LogModel(int mostLines, QObject* parent) : QAbstractTableModel(parent), mostLines_(mostLines) {}

void LogModel::append(const LogEntry& entry)
{
    if (rowCount() == mostLines_) {
        beginRemoveRows({}, 0, 0);
        entries_.pop_front();
        endRemoveRows();
    }
    beginInsertRows({}, rowCount(), rowCount());
    entries_.push_back(entry);
    endInsertRows();
}

void LogModel::clear()
{
    beginResetModel();
    entries_.clear();
    endResetModel();
}

QString LogModel::lastLines(int count) const
{
    QString text;
    for (int row = std::max(0, rowCount() - count); row < rowCount(); ++row) {
        const LogEntry& entry = entries_[static_cast<std::size_t>(row)];
        text += entry.time.toString(Qt::ISODateWithMs) + ' ' + levelText(entry.level) + ' ' + entry.source + ": " +
                entry.message + '\n';
    }
    return text;
}

int LogModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

int LogModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kLogColumns;
}

QVariant LogModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const LogEntry& entry = entries_[static_cast<std::size_t>(index.row())];
    const auto column = static_cast<LogColumn>(index.column());
    switch (role) {
        case Qt::DisplayRole:
            return cellText(entry, column);
        case Qt::ToolTipRole:
            return column == LogColumn::Message ? QVariant(entry.message) : QVariant();
        case kSortRole:
            if (column == LogColumn::Time)
                return entry.time;
            return column == LogColumn::Level ? QVariant(levelText(entry.level)) : QVariant(cellText(entry, column));
        case kPlainTextRole:
            return levelText(entry.level) + ' ' + entry.source + ' ' + entry.message;
        case Qt::FontRole:
            if (entry.level == LogSeverity::Error || entry.level == LogSeverity::Warning) {
                QFont font;
                font.setBold(true);
                return font;
            }
            return {};
        default:
            return {};
    }
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    static constexpr std::array<const char*, kLogColumns> kTitles{"Time", "Level", "Source", "Message"};
    if (orientation != Qt::Horizontal || section < 0 || section >= kLogColumns)
        return {};
    if (role == Qt::DisplayRole)
        return QString::fromLatin1(kTitles[static_cast<std::size_t>(section)]);
    return role == Qt::TextAlignmentRole ? QVariant(Qt::AlignLeft | Qt::AlignVCenter) : QVariant();
}

}  // namespace planewright
