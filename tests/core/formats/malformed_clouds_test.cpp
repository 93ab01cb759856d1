// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fstream>

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

#include "core/formats/cloud_pcd.h"
#include "core/formats/cloud_ptx.h"
#include "core/formats/cloud_recording.h"
#include "core/formats/cloud_uos.h"
#include "tests/test_program.h"

namespace planewright {

namespace {

const QString kClouds = QStringLiteral(PLANEWRIGHT_SOURCE_DIR "/tests/core/formats/malformed_clouds");

QList<QStringList> cloudTable()
{
    QFile file(kClouds + "/expected.tsv");
    QList<QStringList> table;
    if (!file.open(QIODevice::ReadOnly))
        return table;
    for (const QString& line : QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts)) {
        if (!line.startsWith('#'))
            table << line.split('\t');
    }
    return table;
}

Result<void> recordingMadeOf(Result<CloudScan> cloud, const std::string& name)
{
    if (!cloud)
        return tl::unexpected{cloud.error()};
    return recordingOf(std::move(*cloud), name).map([](const CloudRecording&) {});
}

/// Reads a file of the folder to its end, all scans of it.
Result<void> readWhole(const std::string& name)
{
    const auto open = [&] { return std::ifstream{kClouds.toStdString() + "/" + name, std::ios::binary}; };
    std::ifstream in = open();
    if (name.ends_with(".pcd"))
        return recordingMadeOf(readCloudPcd(in, name), name);
    if (name.ends_with(".3d"))
        return recordingMadeOf(readCloudUos(in, name), name);
    if (name.ends_with(".pose"))
        return readPoseUos(in, name).map([](const Pose&) {});
    const auto scans = scansOfPtx(in, name);
    for (int scan = 0; scan < scans.value_or(1); ++scan) {
        std::ifstream again = open();
        if (auto one = recordingMadeOf(readCloudPtx(again, name, scan), name); !one)
            return one;
    }
    return scans.map([](int) {});
}

}  // namespace

/// Every file in the folder `malformed_clouds` is wrong, or unusual, in one way; `expected.tsv` says what each leads
/// to.
class MalformedCloudsTest : public QObject {
    Q_OBJECT

private slots:
    void everyFileHasARowAndEveryRowAFile();
    void whatIsWrongIsNamed_data();
    void whatIsWrongIsNamed();
};

void MalformedCloudsTest::everyFileHasARowAndEveryRowAFile()
{
    QStringList listed = QDir(kClouds).entryList(QDir::Files);
    listed.removeOne("expected.tsv");

    QStringList named;
    for (const QStringList& row : cloudTable()) {
        QCOMPARE(row.size(), 2);
        named << row[0];
    }
    named.sort();
    listed.sort();

    QCOMPARE(named, listed);
    QVERIFY(!named.isEmpty());
}

void MalformedCloudsTest::whatIsWrongIsNamed_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("message");
    for (const QStringList& row : cloudTable())
        QTest::newRow(qPrintable(row[0])) << row[0] << row[1];
}

void MalformedCloudsTest::whatIsWrongIsNamed()
{
    QFETCH(QString, file);
    QFETCH(QString, message);

    const Result<void> read = readWhole(file.toStdString());

    const QString said = read ? QString() : QString::fromStdString(read.error().message);
    if (!read)
        QCOMPARE(read.error().code, ErrorCode::Unreadable);
    QStringList parts = message.split('*');
    for (QString& part : parts)
        part = QRegularExpression::escape(part);
    const QRegularExpression expected(QRegularExpression::anchoredPattern(parts.join(".*")));
    QVERIFY2(expected.match(said).hasMatch(), qPrintable("said: " + said + "\nexpected: " + message));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::MalformedCloudsTest)
#include "malformed_clouds_test.moc"
