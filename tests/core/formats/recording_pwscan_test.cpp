// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/recording_pwscan.h"

#include <fstream>
#include <sstream>

#include <QTemporaryDir>
#include <QTest>

#include "core/formats/parameter_events.h"
#include "core/formats/pwscan_writer.h"
#include "pwscan_sample.h"
#include "tests/test_program.h"

using namespace planewright;

class RecordingPwscanTest : public QObject {
    Q_OBJECT

private slots:
    void aRecordingComesBackAsItWas();
    void theSameRecordingGivesTheSameBytes();
    void tablesAreThoseOfTheFormat();
    void unknownKeysKeepTheirOrder();
    void eventsAndEditsComeWithTheScan();
    void lastScanIsReadUnlessOneIsChosen();
    void aLastScanWithoutSlicesHidesNoOther();
    void aScanThatIsNotThereIsWrongUsage();
    void aRangeBeyondTheFormatIsNotWritten();
    void anotherNumberOfBeamsIsOurOwnFault();
    void severalScansStandInOneFile();
    void aScanThatCannotBeGivenEndsTheWriting();
    void aMissingFileIsSaidToBeMissing();
    void namesThatMeanSomethingToSqliteAreFiles();

private:
    std::string write(const QTemporaryDir& folder, const Recording& recording,
                      const std::optional<ScanNotes>& notes = std::nullopt, const char* name = "a.pwscan");
};

std::string RecordingPwscanTest::write(const QTemporaryDir& folder, const Recording& recording,
                                       const std::optional<ScanNotes>& notes, const char* name)
{
    const std::string path = (folder.path() + "/" + name).toStdString();
    std::ofstream out(path, std::ios::binary);
    const auto written = writeRecordingPwscan(out, recording, notes);
    if (!written)
        qFatal("%s", written.error().message.c_str());
    return path;
}

void RecordingPwscanTest::aRecordingComesBackAsItWas()
{
    const QTemporaryDir folder;
    Recording recording = sampleRecording(3, 4);
    recording.description.extra = {{"serial", "H123"}};
    recording.slices[0].ranges = {0.0, 1.001, 1000.0, 31.0};  // a range outside the limits stays
    recording.slices[1].tiltEnd = degrees(11.25);
    recording.slices[1].tiltCommanded = degrees(11.0);
    recording.slices[1].angleSuspect = true;
    recording.slices[2].step = 7;
    recording.slices[2].time = std::chrono::microseconds{-1};
    recording.slices[0].time = recording.slices[1].time = std::chrono::microseconds{-12'345'678};
    recording.slices[2].firstBearing = degrees(0.125);
    recording.slices[2].ownBearing = true;
    recording.slices[2].timeSuspect = recording.slices[2].retaken = true;

    const auto read = readRecordingPwscan(write(folder, recording));

    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QVERIFY(!read->read.damaged);
    QVERIFY(read->read.warnings.empty());
    const ScanDescription& description = read->read.recording.description;
    QCOMPARE(description.scanner, std::string("UTM-30LX"));
    QCOMPARE(description.bearingStep, degrees(0.25));
    QCOMPARE(description.beams, 4);
    QCOMPARE(description.rangeMin, 0.1);
    QCOMPARE(description.rangeMax, 30.0);
    QCOMPARE(description.pitchAxisOffset, 0.05);
    QCOMPARE(description.extra, recording.description.extra);
    QCOMPARE(read->read.recording.slices.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) {
        const ScanSlice& slice = read->read.recording.slices[i];
        const ScanSlice& was = recording.slices[i];
        QCOMPARE(slice.step, was.step);
        QVERIFY(slice.time == was.time);
        QCOMPARE(slice.tilt, was.tilt);
        QVERIFY(slice.tiltEnd == was.tiltEnd);
        QVERIFY(slice.tiltCommanded == was.tiltCommanded);
        QCOMPARE(slice.firstBearing, was.firstBearing);
        QCOMPARE(slice.ownBearing, was.ownBearing);
        QCOMPARE(slice.bearingStep, was.bearingStep);
        QCOMPARE(slice.ranges, was.ranges);
        QCOMPARE(slice.angleSuspect, was.angleSuspect);
        QCOMPARE(slice.timeSuspect, was.timeSuspect);
        QCOMPARE(slice.retaken, was.retaken);
    }
}

void RecordingPwscanTest::theSameRecordingGivesTheSameBytes()
{
    std::ostringstream first, second;

    QVERIFY(writeRecordingPwscan(first, sampleRecording(40, 721)));
    QVERIFY(writeRecordingPwscan(second, sampleRecording(40, 721)));

    QVERIFY(!first.str().empty());
    QVERIFY(first.str() == second.str());
}

void RecordingPwscanTest::tablesAreThoseOfTheFormat()
{
    const QTemporaryDir folder;
    const std::string path = write(folder, sampleRecording(1, 2));

    // 1000 mm and 1001 mm, the lowest byte first; crc32 of these bytes by another implementation.
    runSql(path,
           "CREATE TEMP TABLE fact(holds INTEGER CHECK(holds));"
           "INSERT INTO fact SELECT application_id = 0x50575343 FROM pragma_application_id;"
           "INSERT INTO fact SELECT user_version = 1 FROM pragma_user_version;"
           "INSERT INTO fact SELECT hex(ranges) = 'E8030000E9030000' FROM slice;"
           "INSERT INTO fact SELECT crc32 = 2915978187 FROM slice;"
           "INSERT INTO fact SELECT state = 'complete' AND extra = '{}' AND pitch_deg = 10 FROM scan, slice;");
}

void RecordingPwscanTest::unknownKeysKeepTheirOrder()
{
    const QTemporaryDir folder;
    Recording recording = sampleRecording(1, 2);
    recording.description.extra = {{"zebra", "last \"quoted\""}, {"ant", "1"}, {"möwe", "ß"}};

    const auto read = readRecordingPwscan(write(folder, recording));

    QVERIFY(read);
    QCOMPARE(read->read.recording.description.extra, recording.description.extra);
}

void RecordingPwscanTest::eventsAndEditsComeWithTheScan()
{
    const QTemporaryDir folder;
    ScanNotes notes;
    notes.scan = sampleScanRecord(2, "hall");
    notes.scan.state = ScanState::Partial;
    notes.scan.pose = Pose{{0.0, 0.0, 0.0, 1.0}, {1.0, 2.0, 3.0}};
    notes.scan.plannedSlices = 137;
    Parameters parameters;
    parameters.planes.minSegments = 7;
    notes.events = {parametersEvent(3, parameters),
                    {ScanEvent::Kind::Mark, std::nullopt, std::chrono::microseconds{5}, "door"}};
    notes.edits = {{1, {Edit::Kind::Merge, {3, 7}, {}, true}, true},
                   {2, {Edit::Kind::Rename, {3}, "east", true}, false}};

    const auto read = readRecordingPwscan(write(folder, sampleRecording(2, 2), notes));

    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QCOMPARE(read->notes.scan.name, std::string("hall"));
    QVERIFY(read->notes.scan.state == ScanState::Partial);
    QCOMPARE(*read->notes.scan.plannedSlices, 137);
    QCOMPARE(read->notes.scan.pose->translation.z(), 3.0);
    QCOMPARE(read->notes.scan.pose->rotation.z(), 1.0);
    const auto changed = readParameterEvents(read->notes.events, "a.pwscan");
    QVERIFY(changed);
    QCOMPARE(changed->size(), std::size_t(1));
    QCOMPARE(changed->front().step, 3);
    QCOMPARE(changed->front().parameters.planes.minSegments, 7);
    QCOMPARE(read->notes.events[1].payload, std::string("door"));
    QCOMPARE(read->notes.edits.size(), std::size_t(2));
    QVERIFY(read->notes.edits[0].undone);
    QCOMPARE(editsInForce(read->notes.edits).size(), std::size_t(1));
    QCOMPARE(editsInForce(read->notes.edits)[0].text, std::string("east"));
}

void RecordingPwscanTest::lastScanIsReadUnlessOneIsChosen()
{
    const QTemporaryDir folder;
    const std::string path = write(folder, sampleRecording(2, 2));
    runSql(
        path,
        "INSERT INTO scan SELECT 5, 'second', 0, '', 'complete', scanner, bearing_start_deg, bearing_step_deg, beams, "
        "range_min_m, range_max_m, pitch_axis_offset_m, NULL, '{}', NULL, NULL, NULL, NULL, NULL, NULL, NULL FROM "
        "scan; INSERT INTO slice SELECT 5, 9, time_us, pitch_deg, NULL, NULL, NULL, 0, ranges, crc32 FROM slice "
        "WHERE step = 0");

    const auto last = readRecordingPwscan(path);
    const auto first = readRecordingPwscan(path, 1);
    const auto scans = scansOfPwscan(path);

    QVERIFY2(last, last ? "" : last.error().message.c_str());
    QCOMPARE(last->notes.scan.name, std::string("second"));
    QCOMPARE(last->read.recording.slices.size(), std::size_t(1));
    QCOMPARE(last->read.recording.slices[0].step, 9);
    QCOMPARE(first->read.recording.slices.size(), std::size_t(2));
    QCOMPARE(scans->size(), std::size_t(2));
    QCOMPARE(scans->back().id, 5);
}

/// Programs that were killed before their first slice.
void RecordingPwscanTest::aLastScanWithoutSlicesHidesNoOther()
{
    const QTemporaryDir folder;
    const std::string path = write(folder, sampleRecording(3, 4));
    for (int i = 0; i < 2; ++i)
        QVERIFY(PwscanWriter::append(path, sampleScanRecord(4, "killed")));

    const auto last = readRecordingPwscan(path);
    const auto chosen = readRecordingPwscan(path, 3);

    QVERIFY2(last, last ? "" : last.error().message.c_str());
    QCOMPARE(last->notes.scan.id, 1);
    QCOMPARE(last->read.recording.slices.size(), std::size_t(3));
    QVERIFY(!chosen);
    QCOMPARE(chosen.error().code, ErrorCode::Unreadable);
    QVERIFY(chosen.error().message.find("scan 3 has no slice") != std::string::npos);
}

void RecordingPwscanTest::aScanThatIsNotThereIsWrongUsage()
{
    const QTemporaryDir folder;

    const auto read = readRecordingPwscan(write(folder, sampleRecording(2, 2)), 2);

    QVERIFY(!read);
    QVERIFY(read.error().code == ErrorCode::Usage);
    QVERIFY(read.error().message.ends_with("a.pwscan: there is no scan 2; choose one of 1"));
}

void RecordingPwscanTest::aRangeBeyondTheFormatIsNotWritten()
{
    Recording recording = sampleRecording(1, 2);
    recording.slices[0].ranges[1] = 1000.001;
    std::ostringstream out;

    const auto written = writeRecordingPwscan(out, recording);

    QVERIFY(!written);
    QVERIFY(written.error().code == ErrorCode::NotWritten);
    QCOMPARE(written.error().message,
             std::string("slice 0 has a range above 1000000 mm, which a recording cannot hold; limit the ranges"));
    QVERIFY(out.str().empty());
}

void RecordingPwscanTest::anotherNumberOfBeamsIsOurOwnFault()
{
    Recording recording = sampleRecording(1, 2);
    recording.slices[0].ranges.pop_back();
    std::ostringstream out;

    const auto written = writeRecordingPwscan(out, recording);

    QVERIFY(!written);
    QVERIFY(written.error().code == ErrorCode::Internal);
}

void RecordingPwscanTest::severalScansStandInOneFile()
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("a.pwscan").toStdString();
    std::ofstream out(path, std::ios::binary);
    const auto scanOf = [](std::size_t number) -> Result<WrittenScan> {
        WrittenScan scan{sampleRecording(2 + static_cast<int>(number), 3), {}};
        scan.notes.scan.state = ScanState::Complete;
        scan.notes.scan.name = "stop " + std::to_string(number);
        scan.notes.scan.floor = static_cast<int>(number) / 2;
        scan.notes.scan.pose = Pose{Eigen::Quaterniond::Identity(), {1.0 * static_cast<double>(number), 0.0, 0.0}};
        return scan;
    };

    QVERIFY(writeScansPwscan(out, 3, scanOf));
    out.close();

    const auto scans = scansOfPwscan(path);
    QVERIFY(scans);
    QCOMPARE(scans->size(), std::size_t(3));
    QCOMPARE(scans->at(2).id, 3);
    QCOMPARE(scans->at(2).name, std::string("stop 2"));
    QCOMPARE(scans->at(2).floor, 1);
    QCOMPARE(scans->at(2).pose->translation.x(), 2.0);
    QCOMPARE(readRecordingPwscan(path, 2)->read.recording.slices.size(), std::size_t(3));
    QVERIFY(pwscanProblems(path).problems.empty());
}

void RecordingPwscanTest::aScanThatCannotBeGivenEndsTheWriting()
{
    std::ostringstream out;

    const auto written = writeScansPwscan(
        out, 2, [](std::size_t) -> Result<WrittenScan> { return fail(ErrorCode::Unreadable, "gone.csv: gone"); });

    QVERIFY(!written);
    QCOMPARE(written.error().message, std::string("gone.csv: gone"));
    QVERIFY(out.str().empty());
}

void RecordingPwscanTest::aMissingFileIsSaidToBeMissing()
{
    const auto read = readRecordingPwscan("/nowhere/a.pwscan");

    QVERIFY(!read);
    QCOMPARE(read.error().message,
             std::string("/nowhere/a.pwscan: there is no such file, or it is empty; check its name and folder"));
}

void RecordingPwscanTest::namesThatMeanSomethingToSqliteAreFiles()
{
    const QTemporaryDir folder;
    for (const char* name : {"file:x?mode=memory&y#z.pwscan", ":memory:", "a%20b ü.pwscan"}) {
        const auto read = readRecordingPwscan(write(folder, sampleRecording(2, 2), std::nullopt, name));

        QVERIFY2(read, name);
    }
}

PLANEWRIGHT_TEST(RecordingPwscanTest)
#include "recording_pwscan_test.moc"
