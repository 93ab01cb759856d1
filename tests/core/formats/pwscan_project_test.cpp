// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/pwscan_project.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>

#include "core/formats/parameter_events.h"
#include "core/formats/pwscan_writer.h"
#include "core/formats/recording_pwscan.h"
#include "pwscan_sample.h"
#include "tests/test_program.h"

using namespace planewright;

class PwscanProjectTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void editsAreThereWhenTheFileIsOpenedAgain();
    void undoneEditsStayInTheFile();
    void namesAreStoredClean();
    void anEditThatCannotBeIsRefused();
    void settingsOfTheFileAndOfAScanAreApart();
    void aSettingIsReplacedAndNotAdded();
    void aFileThatCannotBeWrittenIsReadOnly();
    void aFolderThatCannotBeWrittenHoldsAReadableRecording();
    void aBrokenOffRecordingOnSuchMediaIsAClearError();
    void aNewerVersionIsReadOnly();
    void aFileThatIsHeldIsReadOnlyOrAClearError();
    void parametersOfAnotherExtractionAreStored();
    void eventsAreThoseOfTheScan();
    void editsAreTakenWhileTheScanRuns();

private:
    QTemporaryDir folder_;
    std::string path_;
    int number_ = 0;
};

namespace {

/// Root may do what permissions forbid; for as long as this lives the process has nobody's rights.
class NobodysRights {
public:
    NobodysRights()
    {
        if (::geteuid() == 0)
            changed_ = ::seteuid(65534) == 0;
    }
    ~NobodysRights()
    {
        if (changed_ && ::seteuid(0) != 0)
            std::abort();
    }

private:
    bool changed_ = false;
};

namespace fs = std::filesystem;

/// Changes permissions while it lives.
class Permissions {
public:
    Permissions(fs::path path, fs::perms now) : path_(std::move(path)), before_(fs::status(path_).permissions())
    {
        fs::permissions(path_, now);
    }
    ~Permissions() { fs::permissions(path_, before_); }

private:
    fs::path path_;
    fs::perms before_;
};

constexpr fs::perms kReadable = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read;
constexpr fs::perms kSearchable = kReadable | fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;

std::string messageOf(const auto& result)
{
    return result ? std::string{} : result.error().message;
}

}  // namespace

void PwscanProjectTest::init()
{
    fs::permissions(folder_.path().toStdString(), fs::perms::all);
    const fs::path own = fs::path(folder_.path().toStdString()) / std::to_string(number_++);
    fs::create_directory(own);
    path_ = own / "a.pwscan";
    std::ofstream out(path_, std::ios::binary);
    QVERIFY(writeRecordingPwscan(out, sampleRecording(3, 4)));
}

void PwscanProjectTest::editsAreThereWhenTheFileIsOpenedAgain()
{
    {
        auto project = PwscanProject::open(path_);
        QVERIFY2(project, messageOf(project).c_str());
        QCOMPARE(project->readOnlyBecause(), std::string());
        QVERIFY(project->readOnlyCause() == ReadOnlyCause::None);
        QCOMPARE(*project->append(1, {Edit::Kind::Rename, {3}, "north wall", true}), 1);
        QCOMPARE(*project->append(1, {Edit::Kind::Hide, {3, 4}, {}, false}), 2);
    }

    const auto edits = PwscanProject::open(path_)->edits(1);

    QVERIFY(edits);
    QCOMPARE(edits->size(), std::size_t(2));
    QVERIFY(edits->at(0).edit.kind == Edit::Kind::Rename);
    QCOMPARE(edits->at(0).edit.text, std::string("north wall"));
    QVERIFY(edits->at(1).edit.kind == Edit::Kind::Hide);
    QCOMPARE(edits->at(1).edit.planes, (std::vector<PlaneId>{3, 4}));
    QVERIFY(!edits->at(1).edit.on);
    QCOMPARE(readRecordingPwscan(path_)->notes.edits.size(), std::size_t(2));
}

void PwscanProjectTest::undoneEditsStayInTheFile()
{
    auto project = PwscanProject::open(path_);
    const int seq = *project->append(1, {Edit::Kind::Delete, {3}, {}, true});

    QVERIFY(project->setUndone(seq, true));
    QVERIFY(project->edits(1)->front().undone);
    QCOMPARE(editsInForce(*project->edits(1)).size(), std::size_t(0));

    QVERIFY(project->setUndone(seq, false));
    QVERIFY(!project->edits(1)->front().undone);
    QVERIFY(!project->setUndone(seq + 1, true));
}

void PwscanProjectTest::namesAreStoredClean()
{
    auto project = PwscanProject::open(path_);
    QVERIFY(project->append(1, {Edit::Kind::Rename, {3}, " wall\n\x1b[31m \u202Eevil\u202C ", true}));

    QCOMPARE(project->edits(1)->front().edit.text, std::string("wall [31m evil"));
}

void PwscanProjectTest::anEditThatCannotBeIsRefused()
{
    auto project = PwscanProject::open(path_);

    QVERIFY(project->append(1, {Edit::Kind::Merge, {3}, {}, true}).error().code == ErrorCode::Usage);
    QVERIFY(project->append(1, {Edit::Kind::Rename, {}, "x", true}).error().code == ErrorCode::Usage);
    QVERIFY(project->append(1, {Edit::Kind::Delete, {-1}, {}, true}).error().code == ErrorCode::Usage);
    QVERIFY(messageOf(project->append(9, {Edit::Kind::Delete, {1}, {}, true})).ends_with("there is no scan 9"));
    QCOMPARE(project->edits(1)->size(), std::size_t(0));
}

void PwscanProjectTest::settingsOfTheFileAndOfAScanAreApart()
{
    auto project = PwscanProject::open(path_);
    QVERIFY(project->setSetting(std::nullopt, "view", "file's"));
    QVERIFY(project->setSetting(1, "view", "scan's"));

    QCOMPARE(**project->setting(std::nullopt, "view"), std::string("file's"));
    QCOMPARE(**project->setting(1, "view"), std::string("scan's"));
    QVERIFY(!project->setting(1, "layers")->has_value());
}

void PwscanProjectTest::aSettingIsReplacedAndNotAdded()
{
    auto project = PwscanProject::open(path_);
    for (const char* value : {"one", "two", "three"}) {
        QVERIFY(project->setSetting(std::nullopt, "view", value));
        QVERIFY(project->setSetting(1, "view", value));
    }

    QCOMPARE(**project->setting(std::nullopt, "view"), std::string("three"));
    runSql(path_,
           "CREATE TEMP TABLE fact(holds INTEGER CHECK(holds)); INSERT INTO fact SELECT count(*) = 2 FROM setting");
    QVERIFY(project->setSetting(1, std::string(201, 'k'), "x").error().code == ErrorCode::Usage);
    QVERIFY(project->setSetting(1, "k", std::string((1 << 20) + 1, 'x')).error().code == ErrorCode::Usage);
}

void PwscanProjectTest::aFileThatCannotBeWrittenIsReadOnly()
{
    QVERIFY(PwscanProject::open(path_)->append(1, {Edit::Kind::Delete, {3}, {}, true}));
    const Permissions readable(path_, kReadable);
    const NobodysRights rights;

    auto project = PwscanProject::open(path_);

    QVERIFY2(project, messageOf(project).c_str());
    QVERIFY(!project->readOnlyBecause().empty());
    QVERIFY(project->readOnlyCause() == ReadOnlyCause::NotWritable);
    QCOMPARE(project->edits(1)->size(), std::size_t(1));
    QVERIFY(project->append(1, {Edit::Kind::Delete, {4}, {}, true}).error().code == ErrorCode::NotWritten);
    QVERIFY(project->setUndone(1, true).error().code == ErrorCode::NotWritten);
    QVERIFY(project->setSetting(1, "a", "b").error().code == ErrorCode::NotWritten);
}

/// As a disk from another machine that is mounted read-only, with a recording that was in WAL mode when it was copied.
void PwscanProjectTest::aFolderThatCannotBeWrittenHoldsAReadableRecording()
{
    runSql(path_, "PRAGMA journal_mode=WAL");
    const Permissions file(path_, kReadable);
    const Permissions folder(fs::path(path_).parent_path(), kSearchable);
    const NobodysRights rights;

    const auto read = readRecordingPwscan(path_);
    const auto project = PwscanProject::open(path_);

    QVERIFY2(read, messageOf(read).c_str());
    QCOMPARE(read->read.recording.slices.size(), std::size_t(3));
    QVERIFY2(project, messageOf(project).c_str());
    QVERIFY(!project->readOnlyBecause().empty());
}

void PwscanProjectTest::aBrokenOffRecordingOnSuchMediaIsAClearError()
{
    const std::string copy = fs::path(path_).parent_path() / "copy.pwscan";
    {
        auto writer = PwscanWriter::append(path_, sampleScanRecord(4));
        QVERIFY(writer->write(sampleRecording(1, 4).slices[0]));
        fs::copy(path_, copy);
        fs::copy(path_ + "-wal", copy + "-wal");
    }
    const Permissions file(copy, kReadable);
    const Permissions wal(copy + "-wal", kReadable);
    const Permissions folder(fs::path(path_).parent_path(), kSearchable);
    const NobodysRights rights;

    const auto read = readRecordingPwscan(copy);

    QVERIFY(!read);
    QVERIFY2(read.error().message.ends_with("copy both files to a folder of your own"), read.error().message.c_str());
}

void PwscanProjectTest::aNewerVersionIsReadOnly()
{
    runSql(path_, "ALTER TABLE slice ADD COLUMN temperature REAL; PRAGMA user_version = 2");

    auto project = PwscanProject::open(path_);

    QVERIFY2(project, messageOf(project).c_str());
    QCOMPARE(project->readOnlyBecause(),
             std::string("the recording is of a newer version; change it with a newer version of the program"));
    QVERIFY(project->readOnlyCause() == ReadOnlyCause::NewerVersion);
    QVERIFY(!project->append(1, {Edit::Kind::Delete, {4}, {}, true}));
    QCOMPARE(project->scans()->size(), std::size_t(1));
    QVERIFY(readRecordingPwscan(path_));
}

void PwscanProjectTest::aFileThatIsHeldIsReadOnlyOrAClearError()
{
    sqlite3* other = nullptr;
    sqlite3_open(path_.c_str(), &other);

    sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr);
    const auto whileWriting = PwscanProject::open(path_);
    sqlite3_exec(other, "ROLLBACK; BEGIN EXCLUSIVE", nullptr, nullptr, nullptr);
    const auto whileHeld = PwscanProject::open(path_);
    sqlite3_close(other);

    QVERIFY2(whileWriting, messageOf(whileWriting).c_str());
    QVERIFY(whileWriting->readOnlyBecause().starts_with("another program is writing to it"));
    QVERIFY(whileWriting->readOnlyCause() == ReadOnlyCause::HeldElsewhere);
    QVERIFY(!whileHeld);
    QVERIFY2(messageOf(whileHeld).ends_with("another program holds the file; close it there, or try again"),
             messageOf(whileHeld).c_str());
}

void PwscanProjectTest::parametersOfAnotherExtractionAreStored()
{
    auto project = PwscanProject::open(path_);
    Parameters again;
    again.planes.minSlices = 9;

    QVERIFY(project->appendParameters(1, again));
    QVERIFY(!project->appendParameters(2, again));

    const auto stored = readParameterEvents(readRecordingPwscan(path_)->notes.events, path_);
    QVERIFY(stored);
    QCOMPARE(stored->size(), std::size_t(1));
    QCOMPARE(stored->front().step, 0);
    QCOMPARE(stored->front().parameters.planes.minSlices, 9);
}

void PwscanProjectTest::eventsAreThoseOfTheScan()
{
    auto writer = PwscanWriter::append(path_, sampleScanRecord(4));
    QVERIFY(writer->write(ScanEvent{ScanEvent::Kind::Fault, 1, {}, "The scanner is silent."}));
    QVERIFY(writer->write(ScanEvent{ScanEvent::Kind::Recovered, 1, {}, {}}));
    QVERIFY(writer->close(ScanState::Complete));
    // Somebody else's: of a kind that nobody knows, and at a step that there cannot be.
    runSql(path_, "INSERT INTO event(scan_id, step, kind, payload) VALUES(2, 1, 'eclipse', ''), (2, -4, 'fault', '')");
    const auto project = PwscanProject::open(path_);

    const auto events = project->events(2);

    QVERIFY(events);
    QCOMPARE(events->size(), std::size_t(2));
    QCOMPARE(events->front().kind, ScanEvent::Kind::Fault);
    QCOMPARE(events->front().step, std::optional{1});
    QCOMPARE(events->front().payload, std::string("The scanner is silent."));
    QCOMPARE(events->back().kind, ScanEvent::Kind::Recovered);
    QCOMPARE(project->events(1)->size(), std::size_t(0));
}

void PwscanProjectTest::editsAreTakenWhileTheScanRuns()
{
    auto writer = PwscanWriter::append(path_, sampleScanRecord(4));
    const Recording recording = sampleRecording(2, 4);
    QVERIFY(writer->write(recording.slices[0]));

    auto project = PwscanProject::open(path_);
    QVERIFY(project->append(writer->scan(), {Edit::Kind::Lock, {0}, {}, true}));
    QVERIFY(writer->write(recording.slices[1]));
    QVERIFY(writer->close(ScanState::Complete));

    QCOMPARE(project->edits(2)->size(), std::size_t(1));
    QCOMPARE(readRecordingPwscan(path_)->read.recording.slices.size(), std::size_t(2));
}

PLANEWRIGHT_TEST(PwscanProjectTest)
#include "pwscan_project_test.moc"
