// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "app/cli/output_files.h"
#include "tests/test_program.h"

using namespace planewright;

namespace {

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(not there)");
}

void put(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

Result<void> writeText(OutputFile& file, const std::string& text)
{
    return file.write([&](std::ostream& out) -> Result<void> {
        out << text;
        return {};
    });
}

QStringList filesIn(const QTemporaryDir& folder)
{
    return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden | QDir::System, QDir::Name);
}

}  // namespace

class OutputFileTest : public QObject {
    Q_OBJECT

private slots:
    void appearsOnlyWhenPublished();
    void leavesNothingWhereItWasNotPublished();
    void existingFileNeedsOverwrite();
    void oldFileStandsUntilTheNewOneIsComplete();
    void fileThatAppearedMeanwhileIsNotReplaced();
    void replacingKeepsTheRights();
    void symbolicLinkIsFollowed();
    void symbolicLinkToAFileToComeIsFollowed();
    void symbolicLinksInARingAreAnError();
    void missingFolderIsAnError();
    void folderIsAnError();
    void fullDeviceIsAnErrorAtTheEnd();
    void manyBytesToAFullDeviceAreAnErrorAtOnce();
    void deviceIsWrittenDirectly();
    void twoOutputsToOneFileAreAnError();
    void oneDeviceMayTakeSeveralOutputs();
    void outputsMayNotReplaceTheInput();
    void failureOfOneTakesTheOthersBack();
    void tooManyOutputsAreAnError();
};

void OutputFileTest::appearsOnlyWhenPublished()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.csv");
    OutputFiles files{false};

    auto file = files.open(path.toStdString());
    QVERIFY(file);
    QVERIFY(writeText(**file, "hello"));
    QVERIFY(!QFile::exists(path));
    QVERIFY(files.publish());

    QCOMPARE(bytesOf(path), QByteArray("hello"));
    QCOMPARE(filesIn(folder), QStringList{"a.csv"});
}

void OutputFileTest::leavesNothingWhereItWasNotPublished()
{
    const QTemporaryDir folder;
    {
        OutputFiles files{false};
        auto file = files.open(folder.filePath("a.csv").toStdString());
        QVERIFY(file);
        QVERIFY(writeText(**file, "hello"));
    }

    QCOMPARE(filesIn(folder), QStringList{});
}

void OutputFileTest::existingFileNeedsOverwrite()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.csv");
    put(path, "old");
    OutputFiles files{false};

    const auto file = files.open(path.toStdString());

    QVERIFY(!file);
    QCOMPARE(file.error().code, ErrorCode::NotWritten);
    QCOMPARE(file.error().message,
             path.toStdString() + ": the file exists; give --overwrite to replace it, or another name");
    QCOMPARE(bytesOf(path), QByteArray("old"));
}

void OutputFileTest::oldFileStandsUntilTheNewOneIsComplete()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.csv");
    put(path, "old");
    OutputFiles files{true};

    auto file = files.open(path.toStdString());
    QVERIFY(file);
    QVERIFY(writeText(**file, "new"));
    QCOMPARE(bytesOf(path), QByteArray("old"));
    QVERIFY(files.publish());

    QCOMPARE(bytesOf(path), QByteArray("new"));
    QCOMPARE(filesIn(folder), QStringList{"a.csv"});
}

void OutputFileTest::fileThatAppearedMeanwhileIsNotReplaced()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.csv");
    {
        OutputFiles files{false};
        auto file = files.open(path.toStdString());
        QVERIFY(file);
        put(path, "somebody else's");
        const auto published = files.publish();
        QVERIFY(!published);
        QCOMPARE(published.error().code, ErrorCode::NotWritten);
    }

    QCOMPARE(bytesOf(path), QByteArray("somebody else's"));
    QCOMPARE(filesIn(folder), QStringList{"a.csv"});
}

void OutputFileTest::replacingKeepsTheRights()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.csv");
    put(path, "old");
    const auto rights = QFile::ReadOwner | QFile::WriteOwner | QFile::ReadUser | QFile::WriteUser;
    QVERIFY(QFile::setPermissions(path, rights));
    OutputFiles files{true};

    QVERIFY(files.open(path.toStdString()));
    QVERIFY(files.publish());

    QCOMPARE(QFile::permissions(path), rights);
}

void OutputFileTest::symbolicLinkIsFollowed()
{
    const QTemporaryDir folder;
    put(folder.filePath("real.csv"), "old");
    QVERIFY(QFile::link("real.csv", folder.filePath("link.csv")));
    OutputFiles files{true};

    auto file = files.open(folder.filePath("link.csv").toStdString());
    QVERIFY(file);
    QVERIFY(writeText(**file, "new"));
    QVERIFY(files.publish());

    QCOMPARE(bytesOf(folder.filePath("real.csv")), QByteArray("new"));
    QVERIFY(QFileInfo(folder.filePath("link.csv")).isSymLink());
}

void OutputFileTest::symbolicLinkToAFileToComeIsFollowed()
{
    const QTemporaryDir folder;
    QVERIFY(QFile::link("real.csv", folder.filePath("link.csv")));
    OutputFiles files{false};

    QVERIFY(files.open(folder.filePath("link.csv").toStdString()));
    QVERIFY(files.publish());

    QVERIFY(!QFileInfo(folder.filePath("real.csv")).isSymLink());
    QVERIFY(QFile::exists(folder.filePath("real.csv")));
}

void OutputFileTest::symbolicLinksInARingAreAnError()
{
    const QTemporaryDir folder;
    QVERIFY(QFile::link("b", folder.filePath("a")));
    QVERIFY(QFile::link("a", folder.filePath("b")));
    OutputFiles files{true};

    const auto file = files.open(folder.filePath("a").toStdString());

    QVERIFY(!file);
    QCOMPARE(file.error().code, ErrorCode::NotWritten);
}

void OutputFileTest::missingFolderIsAnError()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("no/such/a.csv").toStdString();
    OutputFiles files{false};

    const auto file = files.open(path);

    QVERIFY(!file);
    QCOMPARE(file.error().message, path + ": there is no such folder; create it first");
}

void OutputFileTest::folderIsAnError()
{
    const QTemporaryDir folder;
    OutputFiles files{true};

    const auto file = files.open(folder.path().toStdString());

    QVERIFY(!file);
    QCOMPARE(file.error().message, folder.path().toStdString() + ": this is a folder; give the name of a file in it");
}

void OutputFileTest::fullDeviceIsAnErrorAtTheEnd()
{
    OutputFiles files{false};

    auto file = files.open("/dev/full");
    QVERIFY(file);
    QVERIFY(writeText(**file, "a little"));
    const auto published = files.publish();

    QVERIFY(!published);
    QCOMPARE(published.error().code, ErrorCode::NotWritten);
    QCOMPARE(published.error().message,
             std::string("/dev/full: No space left on device; free some space or write to another disk"));
}

void OutputFileTest::manyBytesToAFullDeviceAreAnErrorAtOnce()
{
    OutputFiles files{false};

    auto file = files.open("/dev/full");
    QVERIFY(file);
    const auto written = writeText(**file, std::string(1 << 20, 'x'));

    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::NotWritten);
}

void OutputFileTest::deviceIsWrittenDirectly()
{
    OutputFiles files{false};

    auto file = files.open("/dev/null");
    QVERIFY(file);
    QVERIFY(writeText(**file, std::string(1 << 20, 'x')));

    QVERIFY(files.publish());
}

void OutputFileTest::twoOutputsToOneFileAreAnError()
{
    const QTemporaryDir folder;
    OutputFiles files{false};

    QVERIFY(files.open(folder.filePath("a.csv").toStdString()));
    const auto second = files.open((folder.path() + "/./a.csv").toStdString());

    QVERIFY(!second);
    QCOMPARE(second.error().code, ErrorCode::Usage);
}

void OutputFileTest::oneDeviceMayTakeSeveralOutputs()
{
    OutputFiles files{false};

    QVERIFY(files.open("/dev/null"));
    QVERIFY(files.open("/dev/null"));
}

void OutputFileTest::outputsMayNotReplaceTheInput()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("scan.csv");
    put(path, "precious");
    QVERIFY(QFile::link("scan.csv", folder.filePath("link.csv")));
    OutputFiles files{true};
    files.protect(path.toStdString());

    const auto file = files.open(folder.filePath("link.csv").toStdString());

    QVERIFY(!file);
    QCOMPARE(file.error().code, ErrorCode::Usage);
    QCOMPARE(bytesOf(path), QByteArray("precious"));
}

void OutputFileTest::failureOfOneTakesTheOthersBack()
{
    const QTemporaryDir folder;
    const QString taken = folder.filePath("b.csv");
    {
        OutputFiles files{false};
        QVERIFY(files.open(folder.filePath("a.csv").toStdString()));
        QVERIFY(files.open(taken.toStdString()));
        QVERIFY(files.open(folder.filePath("c.csv").toStdString()));
        put(taken, "somebody else's");
        QVERIFY(!files.publish());
    }

    QCOMPARE(filesIn(folder), QStringList{"b.csv"});
    QCOMPARE(bytesOf(taken), QByteArray("somebody else's"));
}

void OutputFileTest::tooManyOutputsAreAnError()
{
    OutputFiles files{false};
    for (int i = 0; i < 64; ++i)
        QVERIFY(files.open("/dev/null"));

    const auto file = files.open("/dev/null");

    QVERIFY(!file);
    QCOMPARE(file.error().code, ErrorCode::Usage);
}

PLANEWRIGHT_TEST(OutputFileTest)
#include "output_file_test.moc"
