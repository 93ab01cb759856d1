// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

namespace {

const QString kFolder = QStringLiteral(PLANEWRIGHT_SOURCE_DIR "/tests/core/formats/malformed");

}  // namespace

/// The table of malformed recordings beside the reader's tests, through the program.
class CliMalformedTest : public QObject {
    Q_OBJECT

private slots:
    void extractGivesTheExitCodeAndTheMessage_data() { rows(); }
    void extractGivesTheExitCodeAndTheMessage();
    void validateGivesTheExitCode_data() { rows(); }
    void validateGivesTheExitCode();

private:
    static void rows();
};

void CliMalformedTest::rows()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("message");
    for (const QByteArray& line : bytesOf(kFolder + "/expected.tsv").split('\n')) {
        const QList<QByteArray> cells = line.split('\t');
        if (cells.size() == 3 && !line.startsWith('#'))
            QTest::newRow(cells[0].constData()) << QString(cells[0]) << cells[1].toInt() << QString::fromUtf8(cells[2]);
    }
}

void CliMalformedTest::extractGivesTheExitCodeAndTheMessage()
{
    QFETCH(QString, file);
    QFETCH(int, code);
    QFETCH(QString, message);
    const QTemporaryDir folder;
    const QString planes = folder.filePath("planes.csv");

    const ProgramRun run = runProgram({"extract", file, "--sensor", "utm-30lx", "--planes", planes}, kFolder);

    QCOMPARE(run.code, code);
    if (code == 3) {
        QCOMPARE(QString::fromUtf8(run.err), "planewright-cli: " + message + "\n");
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{});
    } else {
        QCOMPARE(QString::fromUtf8(run.err),
                 message.isEmpty() ? QString() : "planewright-cli: warning: " + message + "\n");
        QVERIFY(bytesOf(planes).startsWith("# format = planewright-planes 1\n"));
    }
}

void CliMalformedTest::validateGivesTheExitCode()
{
    QFETCH(QString, file);
    QFETCH(int, code);
    QFETCH(QString, message);

    const ProgramRun run = runProgram({"validate", file}, kFolder);

    QCOMPARE(run.code, code);
    QVERIFY2(QString::fromUtf8(run.out).contains(message), run.out);
}

PLANEWRIGHT_TEST(CliMalformedTest)
#include "cli_malformed_test.moc"
