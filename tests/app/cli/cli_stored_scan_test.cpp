// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fstream>
#include <sstream>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "core/formats/parameter_events.h"
#include "core/formats/planes_csv.h"
#include "core/formats/pwscan_writer.h"
#include "core/formats/recording_pwscan.h"
#include "core/params/presets.h"
#include "core/pipeline/apply_edits.h"
#include "core/pipeline/plane_extractor.h"
#include "core/simulation/nodding_scanner.h"
#include "core/simulation/scenes.h"
#include "run_program.h"
#include "tests/core/formats/pwscan_sample.h"
#include "tests/test_program.h"

using namespace planewright;

/// What a .pwscan holds beside its slices, and what the program makes of it.
class CliStoredScanTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void storedParametersAreInForceFromTheirSteps();
    void untilPassesOverLaterParameters();
    void presetSaysOtherwise();
    void assignmentsChangeTheStoredParameters();
    void storedParametersThatAreNotKnownAreAnError();
    void lastScanUnlessOneIsChosen();
    void suspectSlicesAreNotUsed();
    void conversionKeepsWhatIsStored();
    void storedEditsAreApplied();
    void noEditsLeavesPlanesAsTheyWereFound();
    void editsOfOtherPlanesAreTold();

private:
    static void write(const QTemporaryDir& folder, const Recording& recording,
                      const std::optional<ScanNotes>& notes = std::nullopt);
    static QByteArray planesOf(const QTemporaryDir& folder, const QStringList& options = {});
    /// The planes file of an extraction that changes its parameters as the window does while the scan runs.
    QByteArray planesWith(const std::vector<ParametersFrom>& parameters, int until = 1000) const;
    ScanNotes notesWith(const std::vector<ParametersFrom>& parameters) const;

    Recording recording_;  // twelve planes, as a file gives it back
    Parameters precise_;
    Parameters coarse_;
};

void CliStoredScanTest::initTestCase()
{
    const QTemporaryDir folder;
    QCOMPARE(simulateTwelve(folder.path()).code, 0);
    std::ifstream in(folder.filePath("scan.csv").toStdString());
    recording_ = readRecordingCsv(in, "scan.csv")->recording;
    apply(methodPresets().front(), precise_);
    coarse_ = precise_;
    coarse_.noise.estimated = false;  // the noise that is told instead is in every covariance
    coarse_.noise.rangeConstant = 0.05;
}

void CliStoredScanTest::write(const QTemporaryDir& folder, const Recording& recording,
                              const std::optional<ScanNotes>& notes)
{
    std::ofstream out(folder.filePath("a.pwscan").toStdString(), std::ios::binary);
    QVERIFY(writeRecordingPwscan(out, recording, notes));
}

QByteArray CliStoredScanTest::planesOf(const QTemporaryDir& folder, const QStringList& options)
{
    const ProgramRun run = runProgram(
        QStringList{"extract", "a.pwscan", "--planes", "planes.csv", "--overwrite"} + options, folder.path());
    return run.code == 0 ? bytesOf(folder.filePath("planes.csv")) : "failed: " + run.err;
}

QByteArray CliStoredScanTest::planesWith(const std::vector<ParametersFrom>& parameters, int until) const
{
    PlaneExtractor extractor(sensorOf(recording_.description), parameters.front().parameters);
    std::size_t next = 1;
    for (const ScanSlice& slice : recording_.slices) {
        if (slice.step > until)
            break;
        for (; next < parameters.size() && parameters[next].step <= slice.step; ++next)
            extractor.setParameters(parameters[next].parameters);
        extractor.advance(slice);
    }
    std::ostringstream out;
    const auto found = extractor.finish();
    const EditedPlanes planes = applyEdits(*found, {}, recording_.description, parameters.back().parameters);
    if (!writePlanesCsv(out, planeResults(planes.planes, found->segments)))
        return {};
    return QByteArray::fromStdString(out.str());
}

ScanNotes CliStoredScanTest::notesWith(const std::vector<ParametersFrom>& parameters) const
{
    ScanNotes notes;
    notes.scan.state = ScanState::Complete;
    for (const ParametersFrom& from : parameters)
        notes.events.push_back(parametersEvent(from.step, from.parameters));
    return notes;
}

void CliStoredScanTest::storedParametersAreInForceFromTheirSteps()
{
    const QTemporaryDir folder;
    const std::vector<ParametersFrom> stored{{0, precise_}, {40, coarse_}};
    write(folder, recording_, notesWith(stored));

    const QByteArray planes = planesOf(folder);

    QCOMPARE(planes, planesWith(stored));
    QVERIFY(planes != planesWith({{0, precise_}}));
    QVERIFY(planes != planesWith({{0, coarse_}}));
}

void CliStoredScanTest::untilPassesOverLaterParameters()
{
    const QTemporaryDir folder;
    write(folder, recording_, notesWith({{0, precise_}, {40, coarse_}}));

    QCOMPARE(planesOf(folder, {"--until", "39"}), planesWith({{0, precise_}}, 39));
    QCOMPARE(planesOf(folder, {"--until", "40"}), planesWith({{0, precise_}, {40, coarse_}}, 40));
}

void CliStoredScanTest::presetSaysOtherwise()
{
    const QTemporaryDir folder;
    write(folder, recording_, notesWith({{0, coarse_}}));

    QVERIFY(planesOf(folder) == planesWith({{0, coarse_}}));
    QVERIFY(planesOf(folder, {"--preset", "precise"}) == planesWith({{0, precise_}}));
}

void CliStoredScanTest::assignmentsChangeTheStoredParameters()
{
    const QTemporaryDir folder;
    write(folder, recording_, notesWith({{0, precise_}, {40, coarse_}}));
    Parameters first = precise_;
    first.noise.rangeProportional = 0.01;
    Parameters second = coarse_;
    second.noise.rangeProportional = 0.01;

    const QByteArray planes = planesOf(folder, {"-P", "noise.range-proportional=0.01"});

    QCOMPARE(planes, planesWith({{0, first}, {40, second}}));
    QVERIFY(planes != planesOf(folder));
}

void CliStoredScanTest::storedParametersThatAreNotKnownAreAnError()
{
    const QTemporaryDir folder;
    ScanNotes notes = notesWith({{0, precise_}});
    notes.events[0].payload = R"({"format":"planewright-preset 1","parameters":{"planes.unheard-of":1}})";
    write(folder, recording_, notes);

    const ProgramRun run = runProgram({"extract", "a.pwscan"}, folder.path());
    const ProgramRun validation = runProgram({"validate", "a.pwscan"}, folder.path());

    QCOMPARE(run.code, 3);
    QVERIFY2(run.err.contains("a.pwscan: the parameters stored for step 0: ") && run.err.contains("or give --preset"),
             run.err);
    QCOMPARE(validation.code, 4);
    QVERIFY(planesOf(folder, {"--preset", "precise"}) == planesWith({{0, precise_}}));
}

void CliStoredScanTest::lastScanUnlessOneIsChosen()
{
    const QTemporaryDir folder;
    write(folder, recording_);
    auto writer = PwscanWriter::append(folder.filePath("a.pwscan").toStdString(), sampleScanRecord(4));
    for (const ScanSlice& slice : sampleRecording(2, 4).slices)
        QVERIFY(writer->write(slice));
    QVERIFY(writer->close(ScanState::Complete));

    const ProgramRun last = runProgram({"convert", "a.pwscan", "last.csv"}, folder.path());
    const ProgramRun missing = runProgram({"extract", "a.pwscan", "--scan", "3"}, folder.path());

    QCOMPARE(last.code, 0);
    QVERIFY(bytesOf(folder.filePath("last.csv")).contains("\n1,0.025000,11,1001,1002,1003,1004\n"));
    QCOMPARE(planesOf(folder, {"--scan", "1"}), planesWith({{0, precise_}}));
    QCOMPARE(missing.code, 2);
    QCOMPARE(missing.err, QByteArray("planewright-cli: a.pwscan: there is no scan 3; choose one of 1, 2\n"));
}

void CliStoredScanTest::suspectSlicesAreNotUsed()
{
    const QTemporaryDir folder;
    Recording wrong = recording_;
    wrong.slices[30].tilt = degrees(5.0);
    wrong.slices[30].angleSuspect = true;
    write(folder, wrong);
    Recording right = recording_;
    right.slices.erase(right.slices.begin() + 30);

    const ProgramRun run =
        runProgram({"extract", "a.pwscan", "--planes", "planes.csv", "--labels", "labels"}, folder.path());
    runProgram({"convert", "a.pwscan", "a.csv"}, folder.path());
    runProgram({"convert", "a.pwscan", "b.pwscan"}, folder.path());
    std::swap(recording_, right);
    const QByteArray expected = planesWith({{0, precise_}});
    std::swap(recording_, right);

    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QByteArray("planewright-cli: warning: a.pwscan: the angle of 1 slice is suspect; it is not "
                                 "used\n"));
    QCOMPARE(bytesOf(folder.filePath("planes.csv")), expected);
    QCOMPARE(bytesOf(folder.filePath("labels")).count('\n'), static_cast<int>(recording_.slices.size()) - 1);
    QVERIFY(!bytesOf(folder.filePath("a.csv")).contains("\n30,"));
    QVERIFY(readRecordingPwscan(folder.filePath("b.pwscan").toStdString())->read.recording.slices[30].angleSuspect);
}

void CliStoredScanTest::conversionKeepsWhatIsStored()
{
    const QTemporaryDir folder;
    ScanNotes notes = notesWith({{0, precise_}});
    notes.scan.name = "hall";
    notes.scan.startedUtc = "2026-03-01T08:30:00Z";
    notes.edits = {{1, {Edit::Kind::Rename, {0}, "floor", true}, false}};
    write(folder, recording_, notes);

    QCOMPARE(runProgram({"convert", "a.pwscan", "b.pwscan"}, folder.path()).code, 0);

    QCOMPARE(bytesOf(folder.filePath("b.pwscan")), bytesOf(folder.filePath("a.pwscan")));
}

void CliStoredScanTest::storedEditsAreApplied()
{
    const QTemporaryDir folder;
    ScanNotes notes;
    notes.edits = {{1, {Edit::Kind::Rename, {0}, "=ground, floor", true}, false},
                   {2, {Edit::Kind::Classify, {0}, "screed", true}, false},
                   {3, {Edit::Kind::Delete, {1}, {}, true}, false},
                   {4, {Edit::Kind::Delete, {2}, {}, true}, true},
                   {5, {Edit::Kind::Merge, {3, 4}, {}, true}, false}};
    write(folder, recording_, notes);

    const ProgramRun run = runProgram(
        {"extract", "a.pwscan", "--planes", "p.csv", "--planes", "p.json", "--labels", "labels", "--segments", "s.csv"},
        folder.path());
    const QByteArray planes = bytesOf(folder.filePath("p.csv"));
    const QJsonArray json = QJsonDocument::fromJson(bytesOf(folder.filePath("p.json"))).object()["planes"].toArray();
    const QByteArray labels = bytesOf(folder.filePath("labels"));

    QVERIFY2(run.code == 0 && run.err.isEmpty(), run.err);
    QVERIFY2(planes.contains(",\"'=ground, floor\",screed\n"), planes);
    QVERIFY(!planes.contains("\n1,"));
    QVERIFY(planes.contains("\n2,"));
    QVERIFY(!planes.contains("\n3,") && !planes.contains("\n4,"));
    QVERIFY(planes.contains("\n1000000,") && planes.contains(",merge:3+4,"));
    QCOMPARE(json[0].toObject()["name"].toString(), "=ground, floor");
    QCOMPARE(json[0].toObject()["class"].toString(), "screed");
    QVERIFY(QStringList({"wall", "ceiling"}).contains(json[1].toObject()["class"].toString()));
    QVERIFY(labels.contains(" 1000000 "));
    QVERIFY(!labels.contains(" 1 ") && !labels.contains(" 3 "));
    QVERIFY(bytesOf(folder.filePath("s.csv")).contains(",1000000\n"));
}

void CliStoredScanTest::noEditsLeavesPlanesAsTheyWereFound()
{
    const QTemporaryDir folder;
    ScanNotes notes;
    notes.edits = {{1, {Edit::Kind::Delete, {1}, {}, true}, false}};
    write(folder, recording_, notes);

    QCOMPARE(planesOf(folder, {"--no-edits"}), planesWith({{0, precise_}}));
    QVERIFY(planesOf(folder) != planesWith({{0, precise_}}));
}

void CliStoredScanTest::editsOfOtherPlanesAreTold()
{
    const QTemporaryDir folder;
    ScanNotes notes;
    notes.edits = {{1, {Edit::Kind::Rename, {400}, "gone", true}, false}};
    write(folder, recording_, notes);

    const ProgramRun run = runProgram({"extract", "a.pwscan", "--planes", "p.csv"}, folder.path());

    QCOMPARE(run.code, 0);
    QCOMPARE(run.err, QByteArray("planewright-cli: warning: a.pwscan: the naming of plane 400 is not applied: there is "
                                 "no plane 400\n"));
}

PLANEWRIGHT_TEST(CliStoredScanTest)
#include "cli_stored_scan_test.moc"
