// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <clocale>
#include <limits>
#include <sstream>

#include <QtTest>

#include "core/formats/recording_csv.h"
#include "core/types/angle.h"
#include "recording_text.h"
#include "tests/test_program.h"

using namespace planewright;
using std::chrono::microseconds;

namespace {

std::string writtenText(const Recording& recording, bool gzip = false)
{
    std::ostringstream out;
    const auto done = writeRecordingCsv(out, recording, gzip);
    return done ? out.str() : done.error().message;
}

Recording readText(const std::string& text)
{
    std::istringstream in(text);
    auto read = readRecordingCsv(in, "scan.csv");
    return read ? std::move(read->recording) : Recording{};
}

Recording smallRecording()
{
    Recording recording;
    recording.description = {"UTM-30LX", 0.0, degrees(0.25), 3, 0.1, 30.0, 0.05, {}};
    ScanSlice slice;
    slice.tilt = degrees(10.0);
    slice.bearingStep = degrees(0.25);
    slice.ranges = {1.023, 1.021, 0.0};
    recording.slices.push_back(slice);
    slice.step = 3;
    slice.time = microseconds(75001);
    slice.tilt = degrees(11.16);
    slice.ranges = {29.9994, 29.9995, 7.0};
    recording.slices.push_back(slice);
    return recording;
}

}  // namespace

class RecordingCsvWriteTest : public QObject {
    Q_OBJECT

private slots:
    void writesWhatTheFormatSays();
    void writesTheSameInEveryLocale();
    void writesTheOptionalColumnsWhereTheyAreUsed();
    void writesTimesWithSixDecimals_data();
    void writesTimesWithSixDecimals();
    void rangesThatAreNoneBecomeZero();
    void refusesARangeBeyondTheFormat();
    void refusesASliceOfOtherLength();
    void aNameCannotBeginALineOfItsOwn();
    void whatWasReadIsWrittenByteByByteTheSecondTime();
    void everyKeptDigitOfARecordingSurvives();
    void compressedTextReadsBackAndHasNoTimeInIt();
    void aFullDiskIsNotSilent();
};

void RecordingCsvWriteTest::writesWhatTheFormatSays()
{
    QCOMPARE(writtenText(smallRecording()),
             recordingText("0,0.000000,10,1023,1021,0\n3,0.075001,11.16,29999,30000,7000\n"));
}

void RecordingCsvWriteTest::writesTheSameInEveryLocale()
{
    const std::string expected = writtenText(smallRecording());
    QVERIFY2(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr,
             "the locale de_DE.UTF-8 is missing: install locales-all");
    const std::locale before = std::locale::global(std::locale("de_DE.UTF-8"));

    const std::string german = writtenText(smallRecording());
    std::locale::global(before);

    QCOMPARE(german, expected);
}

void RecordingCsvWriteTest::writesTheOptionalColumnsWhereTheyAreUsed()
{
    Recording recording = smallRecording();
    recording.slices[0].tiltEnd = degrees(10.5);
    recording.slices[1].ownBearing = true;
    recording.slices[1].firstBearing = degrees(0.125);

    QCOMPARE(writtenText(recording),
             recordingText("0,0.000000,10,10.5,0,1023,1021,0\n3,0.075001,11.16,11.16,0.125,29999,30000,7000\n",
                           "slice,time_s,pitch_deg,pitch_end_deg,bearing_start_deg,r0,r1,r2"));
}

void RecordingCsvWriteTest::writesTimesWithSixDecimals_data()
{
    QTest::addColumn<qint64>("time");
    QTest::addColumn<QString>("text");
    QTest::newRow("zero") << qint64(0) << "0.000000";
    QTest::newRow("a microsecond") << qint64(1) << "0.000001";
    QTest::newRow("before zero") << qint64(-25000) << "-0.025000";
    QTest::newRow("a clock of today") << qint64(1'795'000'000'123'456) << "1795000000.123456";
}

void RecordingCsvWriteTest::writesTimesWithSixDecimals()
{
    QFETCH(qint64, time);
    QFETCH(QString, text);
    Recording recording = smallRecording();
    recording.slices.resize(1);
    recording.slices[0].time = microseconds(time);

    const std::string written = writtenText(recording);

    QCOMPARE(written, recordingText("0," + text.toStdString() + ",10,1023,1021,0\n"));
    QCOMPARE(readText(written).slices.at(0).time, microseconds(time));
}

void RecordingCsvWriteTest::rangesThatAreNoneBecomeZero()
{
    Recording recording = smallRecording();
    recording.slices.resize(1);
    recording.slices[0].ranges = {-1.0, std::numeric_limits<double>::quiet_NaN(), 1000.0004};

    QCOMPARE(writtenText(recording), recordingText("0,0.000000,10,0,0,1000000\n"));
}

void RecordingCsvWriteTest::refusesARangeBeyondTheFormat()
{
    Recording recording = smallRecording();
    recording.slices[1].ranges[2] = 1000.0005;

    QCOMPARE(writtenText(recording),
             std::string("slice 3 has a range above 1000000 mm, which a recording cannot hold; limit the ranges"));
}

void RecordingCsvWriteTest::refusesASliceOfOtherLength()
{
    Recording recording = smallRecording();
    recording.slices[1].ranges.pop_back();
    std::ostringstream out;

    const auto done = writeRecordingCsv(out, recording, false);

    QCOMPARE(done.error().code, ErrorCode::Internal);
    QCOMPARE(done.error().message, std::string("slice 3 has 2 beams instead of 3"));
    QVERIFY(out.str().empty());
}

void RecordingCsvWriteTest::aNameCannotBeginALineOfItsOwn()
{
    Recording recording = smallRecording();
    recording.description.scanner = "UTM\n# beams = 9\r\x7F";
    recording.description.extra = {{"place", "Fl\xC3\xBCr\tA"}};

    const std::string text = writtenText(recording);

    QVERIFY(text.find("# scanner = UTM # beams = 9  \n") != std::string::npos);
    QVERIFY(text.find("# pitch_axis_offset_m = 0.05\n# place = Fl\xC3\xBCr A\nslice,") != std::string::npos);
}

void RecordingCsvWriteTest::whatWasReadIsWrittenByteByByteTheSecondTime()
{
    // Digits beyond the ninth, numbers in other forms, spreadsheets' commas: gone after the first time.
    const std::string foreign =
        "\xEF\xBB\xBF# beams=2,,\r\n# range_max_m = 5.60,,\r\n# range_min_m = 2e-2,,\r\n# bearing_step_deg = "
        "0.3515625,,\r\n# bearing_start_deg = -29.53125,,\r\n# pitch_axis_offset_m = +0.08,,\r\n# format = "
        "nodding-laser-csv 1,,\r\n# owner = me,,\r\nslice,time_s,pitch_deg,bearing_start_deg,r0,r1\r\n"
        "5,1.5,119.991079123456,0.123456789123,0001,7\r\n7,1.5000004,35.0,0,0,0\r\n";
    const std::string readable = QString::fromStdString(foreign).replace("+0.08", "0.08").toStdString();

    const std::string once = writtenText(readText(readable));
    const std::string twice = writtenText(readText(once));

    QCOMPARE(once, std::string("# format = nodding-laser-csv 1\n# bearing_start_deg = -29.53125\n# bearing_step_deg = "
                               "0.3515625\n# beams = 2\n# range_min_m = 0.02\n# range_max_m = 5.6\n# "
                               "pitch_axis_offset_m = 0.08\n# owner = me\nslice,time_s,pitch_deg,bearing_start_deg,r0,"
                               "r1\n5,1.500000,119.991079,0.123456789,1,7\n7,1.500000,35,0,0,0\n"));
    QCOMPARE(twice, once);
    QVERIFY(readText(foreign).slices.empty());  // a plus sign is no number
}

void RecordingCsvWriteTest::everyKeptDigitOfARecordingSurvives()
{
    std::string rows;
    for (int step = 0; step < 2000; ++step) {
        const int tail = 100000 + step * 7919 % 900000;  // six digits behind the point
        rows += std::to_string(step) + ",0.000000," + std::to_string(step % 180) + "." +
                std::to_string(tail / 10 * 10 + 1) + "," + std::to_string(step * 499) + ",1,2\n";
    }
    const std::string text = recordingText(rows);

    QCOMPARE(writtenText(readText(text)), text);
}

void RecordingCsvWriteTest::compressedTextReadsBackAndHasNoTimeInIt()
{
    const Recording recording = smallRecording();

    const std::string compressed = writtenText(recording, true);

    // RFC 1952: magic, deflate, no flags, time 0, no extra flags, system 255 = unknown.
    QCOMPARE(compressed.substr(0, 10), std::string("\x1F\x8B\x08\0\0\0\0\0\0\xFF", 10));
    QCOMPARE(writtenText(recording, true), compressed);
    QCOMPARE(writtenText(readText(compressed)), writtenText(recording));
}

void RecordingCsvWriteTest::aFullDiskIsNotSilent()
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);

    for (const bool gzip : {false, true}) {
        const auto done = writeRecordingCsv(out, smallRecording(), gzip);

        QCOMPARE(done.error().code, ErrorCode::NotWritten);
        QCOMPARE(done.error().message,
                 std::string("could not be written; check the free space and that writing is permitted"));
    }
}

PLANEWRIGHT_TEST(RecordingCsvWriteTest)
#include "recording_csv_write_test.moc"
