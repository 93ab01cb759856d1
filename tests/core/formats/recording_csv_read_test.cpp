// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <clocale>
#include <sstream>

#include <QtTest>

#include "core/formats/recording_csv.h"
#include "core/types/angle.h"
#include "recording_text.h"
#include "tests/test_program.h"

using namespace planewright;
using std::chrono::microseconds;

namespace {

Result<ReadRecording> read(const std::string& text)
{
    std::istringstream in(text);
    return readRecordingCsv(in, "scan.csv");
}

RecordingProblems problemsOf(const std::string& text)
{
    std::istringstream in(text);
    return recordingProblems(in, "scan.csv");
}

/// Gives its text a few bytes at a time, as a pipe may, and then fails or ends.
class DribblingBuffer : public std::streambuf {
public:
    DribblingBuffer(std::string text, bool failsAtEnd) : text_(std::move(text)), failsAtEnd_(failsAtEnd) {}

protected:
    int_type underflow() override
    {
        if (next_ == text_.size()) {
            if (failsAtEnd_)
                throw std::runtime_error("the disk is gone");
            return traits_type::eof();
        }
        const std::size_t count = std::min<std::size_t>(3, text_.size() - next_);
        setg(text_.data() + next_, text_.data() + next_, text_.data() + next_ + count);
        next_ += count;
        return traits_type::to_int_type(*gptr());
    }

private:
    std::string text_;
    std::size_t next_ = 0;
    bool failsAtEnd_;
};

}  // namespace

class RecordingCsvReadTest : public QObject {
    Q_OBJECT

private slots:
    void readsEveryValueOfAPlainRecording();
    void readsTheOptionalColumns();
    void keepsUnknownKeysAndRangesOutsideTheLimits();
    void roundsTimesToMicroseconds();
    void readsAStreamThatGivesFewBytesAtATime();
    void aStreamThatFailsIsUnreadable();
    void aStreamThatWasNeverOpenIsUnreadable();
    void readsTheSameInEveryLocale();
    void aRowCutAnywhereIsDroppedAndNeverMisread();
    void holdsTheMostBeams();
    void refusesMoreBeamsThanTheMost();
    void refusesMoreSlicesThanTheMost();
    void refusesMoreRangesThanMemoryShouldHold();
    void listsEveryProblemOfAFile();
    void listsAHundredProblemsAndCountsTheRest();
    void goesOnBelowAWrongHeader();
};

void RecordingCsvReadTest::readsEveryValueOfAPlainRecording()
{
    const auto result = read(recordingText("0,0.000000,10.00,1023,1021,0\n2,0.050000,12.5,1000000,1,7"));

    QVERIFY(result.has_value());
    QVERIFY(result->warnings.empty());
    QVERIFY(!result->damaged);
    const ScanDescription& description = result->recording.description;
    QCOMPARE(description.scanner, std::string("UTM-30LX"));
    QCOMPARE(description.firstBearing, 0.0);
    QCOMPARE(description.bearingStep, degrees(0.25));
    QCOMPARE(description.beams, 3);
    QCOMPARE(description.rangeMin, 0.1);
    QCOMPARE(description.rangeMax, 30.0);
    QCOMPARE(description.pitchAxisOffset, 0.05);
    QCOMPARE(result->recording.slices.size(), std::size_t(2));
    const ScanSlice& slice = result->recording.slices[1];
    QCOMPARE(slice.step, 2);
    QCOMPARE(slice.time, microseconds(50000));
    QCOMPARE(slice.tilt, degrees(12.5));
    QVERIFY(!slice.tiltEnd);
    QVERIFY(!slice.ownBearing);
    QCOMPARE(slice.firstBearing, 0.0);
    QCOMPARE(slice.bearingStep, degrees(0.25));
    QCOMPARE(slice.ranges, (std::vector<double>{1000.0, 0.001, 0.007}));
}

void RecordingCsvReadTest::readsTheOptionalColumns()
{
    const auto both = read(
        recordingText("0,0,10,10.5,-0.125,1,2,3\n", "slice,time_s,pitch_deg,pitch_end_deg,bearing_start_deg,r0,r1,r2"));
    const auto bearing =
        read(recordingText("0,0,10,-0.125,1,2,3\n", "slice,time_s,pitch_deg,bearing_start_deg,r0,r1,r2"));
    const auto pitch = read(recordingText("0,0,10,10.5,1,2,3\n", "slice,time_s,pitch_deg,pitch_end_deg,r0,r1,r2"));

    QCOMPARE(both->recording.slices[0].tiltEnd, std::optional(degrees(10.5)));
    QCOMPARE(both->recording.slices[0].firstBearing, degrees(-0.125));
    QVERIFY(both->recording.slices[0].ownBearing);
    QVERIFY(!bearing->recording.slices[0].tiltEnd);
    QCOMPARE(bearing->recording.slices[0].firstBearing, degrees(-0.125));
    QCOMPARE(pitch->recording.slices[0].tiltEnd, std::optional(degrees(10.5)));
    QVERIFY(!pitch->recording.slices[0].ownBearing);
}

void RecordingCsvReadTest::keepsUnknownKeysAndRangesOutsideTheLimits()
{
    const auto result = read("#serial=H12 = 34\n#  place =  Flur \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80  \n" +
                             recordingText("0,0,10,50,40000,1000\n"));

    QVERIFY(result.has_value());
    const auto& extra = result->recording.description.extra;
    QCOMPARE(extra.size(), std::size_t(2));
    QCOMPARE(extra[0], (std::pair<std::string, std::string>("serial", "H12 = 34")));
    QCOMPARE(extra[1], (std::pair<std::string, std::string>("place", "Flur \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80")));
    QCOMPARE(result->warnings.size(), std::size_t(2));
    QCOMPARE(result->recording.slices[0].ranges, (std::vector<double>{0.05, 40.0, 1.0}));
}

void RecordingCsvReadTest::roundsTimesToMicroseconds()
{
    const auto result =
        read(recordingText("0,-0.0000014,0,0,0,0\n1,1700000000.123456,0,0,0,0\n2,1.7000000001234563e9,0,0,0,0\n"));

    QCOMPARE(result->recording.slices[0].time, microseconds(-1));
    QCOMPARE(result->recording.slices[1].time, microseconds(1'700'000'000'123'456));
    QCOMPARE(result->recording.slices[2].time, microseconds(1'700'000'000'123'456));
}

void RecordingCsvReadTest::readsAStreamThatGivesFewBytesAtATime()
{
    DribblingBuffer buffer("\xEF\xBB\xBF" + recordingText("0,0,10,1,2,3\n1,0,10,4,5,6\n"), false);
    std::istream in(&buffer);

    const auto result = readRecordingCsv(in, "pipe");

    QVERIFY(result.has_value());
    QCOMPARE(result->recording.slices.size(), std::size_t(2));
}

void RecordingCsvReadTest::aStreamThatFailsIsUnreadable()
{
    DribblingBuffer buffer(recordingText("0,0,10,1,2,3\n1,0,10,4,5,6\n"), true);
    std::istream in(&buffer);

    const auto result = readRecordingCsv(in, "scan.csv");

    QCOMPARE(result.error().code, ErrorCode::Unreadable);
    QCOMPARE(
        result.error().message,
        std::string("scan.csv: line 1: the file cannot be read; check that it is a file and that its disk is sound"));
}

void RecordingCsvReadTest::aStreamThatWasNeverOpenIsUnreadable()
{
    std::istringstream in;
    in.setstate(std::ios::failbit);

    const auto result = readRecordingCsv(in, "scan.csv");

    QCOMPARE(
        result.error().message,
        std::string("scan.csv: line 1: the file cannot be read; check that it is a file and that its disk is sound"));
}

void RecordingCsvReadTest::readsTheSameInEveryLocale()
{
    QVERIFY2(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr,
             "the locale de_DE.UTF-8 is missing: install locales-all");

    const auto result = read(recordingText("0,0.5,10.25,1,2,3\n"));
    std::setlocale(LC_ALL, "C");

    QCOMPARE(result->recording.slices[0].tilt, degrees(10.25));
    QCOMPARE(result->recording.slices[0].time, microseconds(500000));
}

void RecordingCsvReadTest::aRowCutAnywhereIsDroppedAndNeverMisread()
{
    const std::string last = "1,0.025000,11.16,1024,1022,7";
    const std::string before = recordingText("0,0.000000,10,1023,1021,0\n");
    for (std::size_t length = 0; length <= last.size(); ++length) {
        const auto result = read(before + last.substr(0, length));

        QVERIFY(result.has_value());
        const bool whole = length == 0 || length == last.size();
        QCOMPARE(result->damaged, !whole);
        QCOMPARE(result->recording.slices.size(), std::size_t(length == last.size() ? 2 : 1));
    }
}

void RecordingCsvReadTest::holdsTheMostBeams()
{
    std::string row = "0,0,90";
    for (int beam = 0; beam < kMaxBeams; ++beam)
        row += ",1000000";

    const auto result = read(recordingText(row + "\n", columnsOf(kMaxBeams), kMaxBeams));

    QVERIFY(result.has_value());
    QCOMPARE(result->recording.slices[0].ranges, std::vector<double>(std::size_t(kMaxBeams), 1000.0));
}

void RecordingCsvReadTest::refusesMoreBeamsThanTheMost()
{
    const auto said = read(recordingText("", columnsOf(65537), 65537));
    const auto listed = problemsOf(recordingText("", columnsOf(65537), 65537));

    QCOMPARE(said.error().message, std::string("scan.csv: line 5 (beams): '65537' is not allowed; give a whole number "
                                               "from 1 to 65536"));
    QCOMPARE(listed.problems.size(), std::size_t(2));
    QCOMPARE(listed.problems[1], std::string("scan.csv: line 9: more than 65536 beams; a recording cannot hold them"));
}

void RecordingCsvReadTest::refusesMoreSlicesThanTheMost()
{
    std::string rows;
    for (int step = 0; step < kMaxSlices; ++step)
        rows += std::to_string(step) + ",0,10,5\n";

    const auto most = read(recordingText(rows, columnsOf(1), 1));
    const auto more = read(recordingText(rows + "65536,0,10,5\n", columnsOf(1), 1));

    QCOMPARE(most->recording.slices.size(), std::size_t(kMaxSlices));
    QCOMPARE(more.error().message, std::string("scan.csv: line 65546: more than 65536 slices; split the recording"));
}

void RecordingCsvReadTest::refusesMoreRangesThanMemoryShouldHold()
{
    // 2,048 slices of 65,536 beams are the most; only their problems are asked for, which holds no slice.
    std::string row;
    for (int beam = 0; beam < kMaxBeams; ++beam)
        row += ",0";
    class RepeatedRows : public std::streambuf {
    public:
        RepeatedRows(std::string head, std::string row) : text_(std::move(head)), row_(std::move(row))
        {
            setg(text_.data(), text_.data(), text_.data() + text_.size());
        }

    protected:
        int_type underflow() override
        {
            text_ = std::to_string(step_++) + ",0,10" + row_ + "\n";
            setg(text_.data(), text_.data(), text_.data() + text_.size());
            return traits_type::to_int_type(*gptr());
        }

    private:
        std::string text_;
        std::string row_;
        int step_ = 0;
    };
    RepeatedRows buffer(recordingText("", columnsOf(kMaxBeams), kMaxBeams), row);
    std::istream in(&buffer);

    const RecordingProblems found = recordingProblems(in, "scan.csv");

    QCOMPARE(found.problems, (std::vector<std::string>{"scan.csv: line 2058: more than 134217728 ranges; split the "
                                                       "recording"}));
}

void RecordingCsvReadTest::listsEveryProblemOfAFile()
{
    const RecordingProblems found =
        problemsOf(recordingText("0,0,nan,1,-2,3\n1,1,10,1,2\n\n2,0.5,10,1,2,3\n2,2,10,1,x,y\n"));

    QCOMPARE(
        found.problems,
        (std::vector<std::string>{
            "scan.csv: line 10, column 3 (pitch_deg): 'nan' is not a finite number; give an angle in degrees, with a "
            "decimal point",
            "scan.csv: line 10, column 5 (r1): '-2' is not a range; give whole millimetres from 0 to 1000000, 0 for "
            "no return",
            "scan.csv: line 11: the row has 5 cells instead of 6; complete or remove the row",
            "scan.csv: line 12: there is a blank line between rows; remove it",
            "scan.csv: line 14, column 1 (slice): '2' does not rise above 2 of the row before; number the slices in "
            "the order of measurement",
            "scan.csv: line 14, column 5 (r1): 'x' is not a range; give whole millimetres from 0 to 1000000, 0 for "
            "no return",
            "scan.csv: line 14, column 6 (r2): 'y' is not a range; give whole millimetres from 0 to 1000000, 0 for "
            "no return"}));
    QCOMPARE(found.more, std::size_t(0));
}

void RecordingCsvReadTest::listsAHundredProblemsAndCountsTheRest()
{
    std::string row = "0,0,10";
    for (int beam = 0; beam < 150; ++beam)
        row += ",x";

    const RecordingProblems found = problemsOf(recordingText(row + "\n", columnsOf(150), 150));

    QCOMPARE(found.problems.size(), kMaxListedProblems);
    QCOMPARE(found.more, std::size_t(50));
}

void RecordingCsvReadTest::goesOnBelowAWrongHeader()
{
    std::string text = recordingText("0,0,10,1,2\n");
    text.replace(text.find("# beams = 3"), 11, "# beams = x");
    text.replace(text.find("# range_max_m = 30\n"), 19, "");

    const RecordingProblems found = problemsOf(text);

    QCOMPARE(found.problems, (std::vector<std::string>{
                                 "scan.csv: line 5 (beams): 'x' is not a number; give a whole number from 1 to 65536",
                                 "scan.csv: line 8: the header above lacks range_max_m; add '# key = value' for each",
                                 "scan.csv: line 9: the row has 5 cells instead of 6; complete or remove the row"}));
}

PLANEWRIGHT_TEST(RecordingCsvReadTest)
#include "recording_csv_read_test.moc"
