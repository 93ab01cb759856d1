// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright::architecture {

/// packaging/check-packages against this build, with lists that are wrong on purpose.
class PackageCheckTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void aPackageThatNoListNamesIsReportedWithItsFile();
    void aListedPackageThatNothingUsesIsReported();

private:
    /// Puts `packages-build.txt` into a folder of its own, changed by a pair of texts.
    void writeBuildList(const QByteArray& before, const QByteArray& after);
    /// Output of the check on the lists written.
    QByteArray check(int expectedExit);

    std::unique_ptr<QTemporaryDir> lists_;
};

void PackageCheckTest::init()
{
    lists_ = std::make_unique<QTemporaryDir>();
    QVERIFY(lists_->isValid());
    for (const char* name : {"packages-build.txt", "packages-test.txt", "packages-benchmark.txt"})
        QVERIFY(QFile::copy(QString(PLANEWRIGHT_SOURCE_DIR "/packaging/") + name, lists_->filePath(name)));
}

void PackageCheckTest::writeBuildList(const QByteArray& before, const QByteArray& after)
{
    QFile list(lists_->filePath("packages-build.txt"));
    QVERIFY(list.open(QIODevice::ReadOnly));
    QByteArray text = list.readAll();
    list.close();
    QVERIFY(text.contains(before));
    text.replace(before, after);
    QVERIFY(list.remove());
    QVERIFY(list.open(QIODevice::WriteOnly));
    QCOMPARE(list.write(text), text.size());
}

QByteArray PackageCheckTest::check(int expectedExit)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(PLANEWRIGHT_SOURCE_DIR "/packaging/check-packages",
                  {PLANEWRIGHT_BINARY_DIR, "--lists", lists_->path()});
    const bool ended = process.waitForFinished(300'000);
    const QByteArray output = process.readAll();
    [&] { QVERIFY2(ended && process.exitCode() == expectedExit, output); }();
    return output;
}

void PackageCheckTest::aPackageThatNoListNamesIsReportedWithItsFile()
{
    writeBuildList("\nlibexpected-dev\n", "\n");

    const QByteArray output = check(1);

    const QRegularExpression line("^/usr/.*expected.* -> libexpected-dev -> missing from packaging/packages-build.txt$",
                                  QRegularExpression::MultilineOption);
    QVERIFY2(line.match(QString::fromUtf8(output)).hasMatch(), output);
}

void PackageCheckTest::aListedPackageThatNothingUsesIsReported()
{
    writeBuildList("\ncmake\n", "\ncmake\nplanewright-no-such-package\n");

    const QByteArray output = check(1);

    QVERIFY2(output.contains("packages-build.txt: planewright-no-such-package -> nothing uses it"), output);
}

}  // namespace planewright::architecture

PLANEWRIGHT_TEST(planewright::architecture::PackageCheckTest)
#include "package_check_test.moc"
