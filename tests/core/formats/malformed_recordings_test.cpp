// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <fstream>

#include <QDir>
#include <QFile>
#include <QSet>
#include <QtTest>

#include "core/formats/recording_csv.h"
#include "tests/test_program.h"

using namespace planewright;

/// Every file in the folder `malformed` is wrong, or unusual, in one way; `expected.tsv` says what each one leads to.
class MalformedRecordingsTest : public QObject {
    Q_OBJECT

private slots:
    void everyFileHasARowAndEveryRowAFile();
    void readingGivesTheExitCodeAndTheMessage_data() { rows(); }
    void readingGivesTheExitCodeAndTheMessage();
    void validatingFindsTheSameProblem_data() { rows(); }
    void validatingFindsTheSameProblem();

private:
    static QList<QStringList> table();
    static void rows();
};

QList<QStringList> MalformedRecordingsTest::table()
{
    QFile file(MALFORMED_RECORDINGS "/expected.tsv");
    QList<QStringList> table;
    if (!file.open(QIODevice::ReadOnly))
        return table;
    for (const QString& line : QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts)) {
        if (!line.startsWith('#'))
            table << line.split('\t');
    }
    return table;
}

void MalformedRecordingsTest::rows()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("message");
    for (const QStringList& row : table())
        QTest::newRow(qPrintable(row[0])) << row[0] << row[1].toInt() << row[2];
}

void MalformedRecordingsTest::everyFileHasARowAndEveryRowAFile()
{
    const QStringList listed = QDir(MALFORMED_RECORDINGS).entryList({"*.csv", "*.csv.gz"}, QDir::Files);
    const QSet<QString> files{listed.begin(), listed.end()};

    QSet<QString> named;
    for (const QStringList& row : table()) {
        QCOMPARE(row.size(), 3);
        QVERIFY2(!named.contains(row[0]), qPrintable("two rows for " + row[0]));
        named << row[0];
    }

    QVERIFY2((files - named).isEmpty(), qPrintable("no row for " + (files - named).values().join(' ')));
    QVERIFY2((named - files).isEmpty(), qPrintable("no file for " + (named - files).values().join(' ')));
    QVERIFY(!files.isEmpty());
}

void MalformedRecordingsTest::readingGivesTheExitCodeAndTheMessage()
{
    QFETCH(QString, file);
    QFETCH(int, exitCode);
    QFETCH(QString, message);
    std::ifstream in((QString(MALFORMED_RECORDINGS "/") + file).toStdString(), std::ios::binary);

    const auto read = readRecordingCsv(in, file.toStdString());

    if (exitCode == 3) {
        QVERIFY(!read.has_value());
        QCOMPARE(read.error().code, ErrorCode::Unreadable);
        QCOMPARE(QString::fromStdString(read.error().message), message);
        return;
    }
    QVERIFY2(read.has_value(), read ? "" : read.error().message.c_str());
    QCOMPARE(read->damaged, exitCode == 4);
    QStringList warnings;
    for (const std::string& warning : read->warnings)
        warnings << QString::fromStdString(warning);
    QCOMPARE(warnings.join(' '), message);
    QVERIFY(!read->recording.slices.empty());
}

void MalformedRecordingsTest::validatingFindsTheSameProblem()
{
    QFETCH(QString, file);
    QFETCH(int, exitCode);
    QFETCH(QString, message);
    std::ifstream in((QString(MALFORMED_RECORDINGS "/") + file).toStdString(), std::ios::binary);

    const RecordingProblems found = recordingProblems(in, file.toStdString());

    QCOMPARE(!found.problems.empty(), exitCode == 3);
    if (exitCode == 3)
        QCOMPARE(QString::fromStdString(found.problems.front()), message);
    else
        QCOMPARE(found.damaged, exitCode == 4);
    QCOMPARE(found.more, std::size_t(0));
}

PLANEWRIGHT_TEST(MalformedRecordingsTest)
#include "malformed_recordings_test.moc"
