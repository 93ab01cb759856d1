// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/log_model.h"

#include <QAbstractItemModelTester>
#include <QtTest>

#include "tests/test_program.h"
#include "ui/models/filter_proxy_model.h"

namespace planewright {

class LogModelTest : public QObject {
    Q_OBJECT

private slots:
    void theOldestLinesGoFirst();
    void linesAreFoundByLevelAndSource();
    void aReportHasTheNewestLines();
};

namespace {

LogEntry entry(LogSeverity level, const char* source, const char* message)
{
    return {QDateTime({2026, 1, 2}, {3, 4, 5, 678}), level, QString::fromLatin1(source), QString::fromLatin1(message)};
}

}  // namespace

void LogModelTest::theOldestLinesGoFirst()
{
    LogModel model(2);
    const QAbstractItemModelTester tester(&model);

    for (const char* message : {"one", "two", "three"})
        model.append(entry(LogSeverity::Info, "file", message));

    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(model.index(0, static_cast<int>(LogColumn::Message)).data().toString(), QStringLiteral("two"));
    QCOMPARE(model.index(0, static_cast<int>(LogColumn::Time)).data().toString(), QStringLiteral("03:04:05.678"));
}

void LogModelTest::linesAreFoundByLevelAndSource()
{
    LogModel model;
    model.append(entry(LogSeverity::Warning, "scanner", "silent"));
    model.append(entry(LogSeverity::Info, "scanner", "found"));
    model.append(entry(LogSeverity::Warning, "file", "full"));
    FilterProxyModel rows(logFilterKeys());
    rows.setSourceModel(&model);

    QVERIFY(!rows.setQuery("level:warning source:scanner"));
    QCOMPARE(rows.rowCount(), 1);
    QVERIFY(!rows.setQuery("fu"));
    QCOMPARE(rows.rowCount(), 1);
}

void LogModelTest::aReportHasTheNewestLines()
{
    LogModel model;
    for (const char* message : {"one", "two", "three"})
        model.append(entry(LogSeverity::Error, "file", message));

    QCOMPARE(model.lastLines(2), QStringLiteral("2026-01-02T03:04:05.678 error file: two\n"
                                                "2026-01-02T03:04:05.678 error file: three\n"));
    model.clear();
    QCOMPARE(model.lastLines(2), QString());
}

}  // namespace planewright

PLANEWRIGHT_GUI_TEST(planewright::LogModelTest)
#include "log_model_test.moc"
