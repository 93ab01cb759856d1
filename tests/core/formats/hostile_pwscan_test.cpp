// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fstream>
#include <random>
#include <sstream>

#include <QTemporaryDir>
#include <QTest>

#include "core/formats/pwscan_project.h"
#include "core/formats/recording_pwscan.h"
#include "pwscan_sample.h"
#include "tests/test_program.h"

using namespace planewright;

/// Recordings that somebody has spoiled, in one way each.
class HostilePwscanTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsNoRecordingIsRefused_data();
    void whatIsNoRecordingIsRefused();
    void aBadRowIsNamedAndLeftOut_data();
    void aBadRowIsNamedAndLeftOut();
    void aScanWithoutAGoodSliceIsUnreadable();
    void whatIsNoDatabaseIsRefused_data();
    void whatIsNoDatabaseIsRefused();
    void aTruncatedFileNeverCrashesTheReader();
    void flippedBitsNeverCrashTheReader();
    void aBillionRowsAreNotRead();
    void hugeValuesAreNotLoaded();

private:
    std::string spoiled(const QTemporaryDir& folder, const std::string& sql);
    std::string bytes() const;
};

std::string HostilePwscanTest::bytes() const
{
    std::ostringstream out;
    ScanNotes notes;
    notes.scan.state = ScanState::Complete;
    notes.events = {{ScanEvent::Kind::Mark, 1, std::nullopt, "door"}};
    notes.edits = {{1, {Edit::Kind::Rename, {0}, "wall", true}, false}};
    const auto written = writeRecordingPwscan(out, sampleRecording(12, 400), notes);
    if (!written)
        qFatal("%s", written.error().message.c_str());
    return out.str();
}

std::string HostilePwscanTest::spoiled(const QTemporaryDir& folder, const std::string& sql)
{
    const std::string path = folder.filePath("a.pwscan").toStdString();
    std::ofstream(path, std::ios::binary) << bytes();
    runSql(path, sql);
    return path;
}

void HostilePwscanTest::whatIsNoRecordingIsRefused_data()
{
    QTest::addColumn<QString>("sql");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* what, const char* sql, const char* message) {
        QTest::newRow(what) << sql << message;
    };
    row("another application", "PRAGMA application_id = 7",
        "this is a database, but no recording; give a file that was recorded as .pwscan");
    row("no version", "PRAGMA user_version = 0", "the recording says no version of its format; get a sound copy");
    row("a negative version", "PRAGMA user_version = -3",
        "the recording says no version of its format; get a sound copy");
    row("no slices", "DROP TABLE slice", "there is no table 'slice'; get a sound copy");
    row("a view for a table", "ALTER TABLE slice RENAME TO other; CREATE VIEW slice AS SELECT * FROM other",
        "there is a view 'slice', which no recording has; get a sound copy");
    row("a view beside the tables", "CREATE VIEW more AS SELECT 1",
        "there is a view 'more', which no recording has; get a sound copy");
    row("a trigger", "CREATE TRIGGER t AFTER INSERT ON edit BEGIN DELETE FROM slice; END",
        "there is a trigger 't', which no recording has; get a sound copy");
    row("a virtual table",
        "DROP TABLE event; CREATE VIRTUAL TABLE event USING fts4(scan_id, step, time_us, kind, payload)",
        "there is a table 'event', which no recording has; get a sound copy");
    row("an index", "CREATE INDEX i ON slice(crc32)", "there is a index 'i', which no recording has; get a sound copy");
    row("a column less", "ALTER TABLE edit DROP COLUMN undone",
        "table 'edit' lacks the column 'undone'; get a sound copy");
    row("a column more", "ALTER TABLE edit ADD COLUMN more",
        "table 'edit' has the unknown column 'more'; get a sound copy");
    row("a generated column",
        "DROP TABLE setting; CREATE TABLE setting(scan_id INTEGER, key TEXT NOT NULL, value TEXT AS (key), PRIMARY "
        "KEY(scan_id, key))",
        "table 'setting' has 'value' where the column 'value' belongs; get a sound copy");
    row("another key", "DROP TABLE setting; CREATE TABLE setting(scan_id INTEGER, key TEXT, value TEXT)",
        "table 'setting' has 'scan_id' where the column 'scan_id' belongs; get a sound copy");
    row("no scan", "DELETE FROM scan", "there is no scan in it; record one with --append");
    row("no beams", "UPDATE scan SET beams = 0",
        "scan 1: beams is no whole number from 1 to 65536; the scan is not used");
    row("a billion beams", "UPDATE scan SET beams = 1000000000",
        "scan 1: beams is no whole number from 1 to 65536; the scan is not used");
    row("text for a number", "UPDATE scan SET range_max_m = 'far'",
        "scan 1: range_max_m is no number within its limits; the scan is not used");
    row("an infinite limit", "UPDATE scan SET range_max_m = 9e999",
        "scan 1: range_max_m is no number within its limits; the scan is not used");
    row("a bearing step of zero", "UPDATE scan SET bearing_step_deg = 0",
        "scan 1: bearing_step_deg is no number within its limits; the scan is not used");
    row("extra that is no JSON", "UPDATE scan SET extra = '{'",
        "scan 1: extra is no JSON object of a recording; the scan is not used");
    row("extra that nests deep", "UPDATE scan SET extra = '{\"a\":' || replace(hex(zeroblob(5000)), '00', '[') || '}'",
        "scan 1: extra is no JSON object of a recording; the scan is not used");
    row("a name that is no text", "UPDATE scan SET name = x'00ff'",
        "scan 1: name is no plain text; the scan is not used");
    row("a name with a line end", "UPDATE scan SET name = 'a' || char(10) || 'b'",
        "scan 1: name is no plain text; the scan is not used");
}

void HostilePwscanTest::whatIsNoRecordingIsRefused()
{
    QFETCH(QString, sql);
    QFETCH(QString, message);
    const QTemporaryDir folder;
    const std::string path = spoiled(folder, sql.toStdString());

    const auto read = readRecordingPwscan(path);
    const RecordingProblems found = pwscanProblems(path);

    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::Unreadable);
    QCOMPARE(QString::fromStdString(read.error().message), QString::fromStdString(path) + ": " + message);
    QCOMPARE(found.problems.size(), std::size_t(1));
    QCOMPARE(found.problems.front(), read.error().message);
}

void HostilePwscanTest::aBadRowIsNamedAndLeftOut_data()
{
    QTest::addColumn<QString>("sql");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* what, const char* sql, const char* message) {
        QTest::newRow(what) << sql << message;
    };
    row("a wrong check sum", "UPDATE slice SET crc32 = crc32 + 1 WHERE step = 5",
        "scan 1, step 5: crc32 is not the check sum of the ranges; the slice is not used");
    row("a check sum that is text", "UPDATE slice SET crc32 = 'x' WHERE step = 5",
        "scan 1, step 5: crc32 is not the check sum of the ranges; the slice is not used");
    row("too few bytes", "UPDATE slice SET ranges = x'0102' WHERE step = 5",
        "scan 1, step 5: ranges has 2 bytes instead of 1600; the slice is not used");
    row("ranges that are text", "UPDATE slice SET ranges = 'far away' WHERE step = 5",
        "scan 1, step 5: ranges has -1 bytes instead of 1600; the slice is not used");
    row("too far", "UPDATE slice SET ranges = zeroblob(1596) || x'41420F00', crc32 = 1643216838 WHERE step = 5",
        "scan 1, step 5: ranges has -1 bytes instead of 1600; the slice is not used");
    row("a negative step", "UPDATE slice SET step = -5 WHERE step = 5",
        "scan 1, step -5: step is no whole number from 0 to 1000000000; the slice is not used");
    row("a step beyond the limit", "UPDATE slice SET step = 4000000000 WHERE step = 11",
        "scan 1, step 4000000000: step is no whole number from 0 to 1000000000; the slice is not used");
    row("a step that is text", "UPDATE slice SET step = 'five' WHERE step = 5",
        "scan 1, step ?: step is no whole number from 0 to 1000000000; the slice is not used");
    row("time that runs backwards", "UPDATE slice SET time_us = 1 WHERE step = 5",
        "scan 1, step 5: time_us is earlier than that of the slice before; the slice is not used");
    row("time beyond its limits", "UPDATE slice SET time_us = -9223372036854775807 WHERE step = 5",
        "scan 1, step 5: time_us is no whole number within its limits; the slice is not used");
    row("an infinite pitch", "UPDATE slice SET pitch_deg = 9e999 WHERE step = 5",
        "scan 1, step 5: pitch_deg is no angle from -360 to 360 degrees; the slice is not used");
    row("a pitch that is text", "UPDATE slice SET pitch_deg = 'steep' WHERE step = 5",
        "scan 1, step 5: pitch_deg is no angle from -360 to 360 degrees; the slice is not used");
    row("an end pitch out of limits", "UPDATE slice SET pitch_end_deg = 360.5 WHERE step = 5",
        "scan 1, step 5: pitch_end_deg is no angle from -360 to 360 degrees; the slice is not used");
    row("a commanded pitch that is a blob", "UPDATE slice SET pitch_commanded_deg = x'00' WHERE step = 5",
        "scan 1, step 5: pitch_commanded_deg is no angle from -360 to 360 degrees; the slice is not used");
    row("a bearing that is text", "UPDATE slice SET bearing_start_deg = 'left' WHERE step = 5",
        "scan 1, step 5: bearing_start_deg is no angle from -360 to 360 degrees; the slice is not used");
    row("flags that are text", "UPDATE slice SET flags = 'none' WHERE step = 5",
        "scan 1, step 5: flags is no whole number; the slice is not used");
}

void HostilePwscanTest::aBadRowIsNamedAndLeftOut()
{
    QFETCH(QString, sql);
    QFETCH(QString, message);
    const QTemporaryDir folder;
    const std::string path = spoiled(folder, sql.toStdString());

    const auto read = readRecordingPwscan(path);
    const RecordingProblems found = pwscanProblems(path);

    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QVERIFY(read->read.damaged);
    QCOMPARE(read->read.recording.slices.size(), std::size_t(11));
    QCOMPARE(read->read.slicesLeftOut, 1);
    QCOMPARE(QString::fromStdString(read->read.warnings.at(0)), QString::fromStdString(path) + ": " + message);
    QVERIFY(found.damaged);
    QVERIFY(found.problems.empty());
    QCOMPARE(found.warnings, read->read.warnings);
}

void HostilePwscanTest::aScanWithoutAGoodSliceIsUnreadable()
{
    const QTemporaryDir folder;
    const std::string path = spoiled(folder, "UPDATE slice SET crc32 = 0");

    const auto read = readRecordingPwscan(path);

    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::Unreadable);
    QVERIFY(
        read.error().message.ends_with("scan 1, step 0: crc32 is not the check sum of the ranges; the slice is not "
                                       "used"));
    QCOMPARE(pwscanProblems(path).problems.size(), std::size_t(1));
}

void HostilePwscanTest::whatIsNoDatabaseIsRefused_data()
{
    QTest::addColumn<QByteArray>("contents");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("text") << QByteArray("# format = nodding-laser-csv 1\n");
    QTest::newRow("zeros") << QByteArray(100'000, '\0');
    QTest::newRow("header alone") << QByteArray("SQLite format 3\0", 16);
    QTest::newRow("header and noise") << QByteArray("SQLite format 3\0", 16) + QByteArray(8192, '\x5a');
}

void HostilePwscanTest::whatIsNoDatabaseIsRefused()
{
    QFETCH(QByteArray, contents);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    std::ofstream(path, std::ios::binary) << contents.toStdString();

    const auto read = readRecordingPwscan(path);
    const auto project = PwscanProject::open(path);

    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::Unreadable);
    QVERIFY(!project);
}

/// Reads a file in all ways, and holds what comes back against what it must be.
static void readInEveryWay(const std::string& path)
{
    const auto read = readRecordingPwscan(path);
    if (read) {
        int last = -1;
        for (const ScanSlice& slice : read->read.recording.slices) {
            QVERIFY(slice.step > last);
            QCOMPARE(slice.ranges.size(), static_cast<std::size_t>(read->read.recording.description.beams));
            last = slice.step;
        }
    } else
        QVERIFY(read.error().code == ErrorCode::Unreadable && !read.error().message.empty());
    pwscanProblems(path);
    if (const auto project = PwscanProject::open(path)) {
        (void)project->scans();
        (void)project->edits(1);
        (void)project->setting(1, "view");
    }
}

void HostilePwscanTest::aTruncatedFileNeverCrashesTheReader()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    const std::string whole = bytes();
    for (std::size_t size = 1; size < whole.size(); size += 511) {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << whole.substr(0, size);
        readInEveryWay(path);
    }
}

void HostilePwscanTest::flippedBitsNeverCrashTheReader()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    const std::string whole = bytes();
    const int cases = qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG") ? 100'000 : 2'000;
    for (int seed = 0; seed < cases; ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        std::string spoilt = whole;
        // Most flips hit ranges, which check sums guard; half of them are sent where the pages' structure is.
        for (unsigned flips = 1 + random() % 8; flips > 0; --flips) {
            const std::size_t page = random() % (whole.size() / 4096) * 4096;
            const std::size_t place = random() % 2 == 0 ? random() % whole.size() : page + random() % 128;
            spoilt[place] = static_cast<char>(spoilt[place] ^ (1 << random() % 8));
        }
        std::ofstream(path, std::ios::binary | std::ios::trunc) << spoilt;

        readInEveryWay(path);
    }
}

/// A table whose rows a reader would sort, or count, for hours: more rows than a recording may hold, of one beam.
void HostilePwscanTest::aBillionRowsAreNotRead()
{
    const QTemporaryDir folder;
    const std::string path =
        spoiled(folder,
                "DELETE FROM slice; UPDATE scan SET beams = 1; "
                "WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 70000) "
                "INSERT INTO slice SELECT 1, i, i, 10, NULL, NULL, NULL, 0, x'e8030000', 818481298 FROM n; "
                "WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 1100000) "
                "INSERT INTO edit SELECT i + 10, 2, 'delete', '', 0 FROM n");

    const auto read = readRecordingPwscan(path);

    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QCOMPARE(read->read.recording.slices.size(), std::size_t(65536));
    QVERIFY(read->read.damaged);
    QCOMPARE(read->read.warnings.size(), std::size_t(2));
    QVERIFY(
        read->read.warnings[0].ends_with("scan 1: there are more slices than a recording may hold; the first 65536 "
                                         "are used"));
    QVERIFY(
        read->read.warnings[1].ends_with("there are more edits than a recording may hold; the first 1000000 are "
                                         "used"));
}

/// 400 MB of values where a few bytes belong, of which SQLite may hold one at a time, to compare its key.
void HostilePwscanTest::hugeValuesAreNotLoaded()
{
    const QTemporaryDir folder;
    const std::string path = spoiled(folder,
                                     "UPDATE slice SET ranges = zeroblob(100000000) WHERE step = 3;"
                                     "UPDATE slice SET pitch_deg = zeroblob(100000000) WHERE step = 5;"
                                     "UPDATE slice SET crc32 = zeroblob(100000000) WHERE step = 7;"
                                     "UPDATE edit SET payload = zeroblob(100000000)");
    sqlite3_memory_highwater(1);

    const auto read = readRecordingPwscan(path);

    const auto most = sqlite3_memory_highwater(0);
    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QCOMPARE(read->read.recording.slices.size(), std::size_t(9));
    QVERIFY(read->read.warnings.size() == 4);
    QVERIFY2(most < 150'000'000, qPrintable(QString::number(most)));
}

PLANEWRIGHT_TEST(HostilePwscanTest)
#include "hostile_pwscan_test.moc"
