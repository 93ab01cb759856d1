// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/map_edit.h"

#include <fstream>
#include <sstream>

#include <QTemporaryDir>
#include <QTest>

#include "core/formats/pwscan_project.h"
#include "core/formats/recording_pwscan.h"
#include "pwscan_sample.h"
#include "tests/test_program.h"

using namespace planewright;

class MapEditTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void everyKindComesBack_data();
    void everyKindComesBack();
    void whatIsNoPayloadIsRefused_data();
    void whatIsNoPayloadIsRefused();
    void editsAreThereWhenTheFileIsOpenedAgain();
    void editsOfPlanesAndOfTheMapStandBesideEachOther();
    void aBadEditIsNamedAndLeftOut();
    void whatIsWrittenWithAScanIsOfThatScan();

private:
    QTemporaryDir folder_;
    std::string path_;
};

namespace {

WrittenScan threeSlices()
{
    WrittenScan scan{sampleRecording(3, 5), {}};
    scan.notes.scan = sampleScanRecord(5);
    scan.notes.scan.state = ScanState::Complete;
    return scan;
}

MapEdit matchOf(int scan, PlaneId plane, std::optional<SeenPlane> as)
{
    MapEdit edit;
    edit.kind = MapEdit::Kind::Match;
    edit.scan = scan;
    edit.plane = plane;
    edit.as = as;
    return edit;
}

}  // namespace

void MapEditTest::init()
{
    path_ = folder_.filePath("two.pwscan").toStdString();
    std::ofstream out(path_, std::ios::binary | std::ios::trunc);
    QVERIFY(writeScansPwscan(out, 2, [](std::size_t) { return threeSlices(); }));
}

void MapEditTest::everyKindComesBack_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("payload");
    QTest::newRow("omit") << "omit-stop"
                          << R"({"on":true})";
    QTest::newRow("take in again") << "omit-stop"
                                   << R"({"on":false})";
    QTest::newRow("before another") << "order-stop"
                                    << R"({"before":7})";
    QTest::newRow("last") << "order-stop"
                          << R"({"before":null})";
    QTest::newRow("the same plane") << "match-plane"
                                    << R"({"plane":3,"as":{"scan":2,"plane":1000000005}})";
    QTest::newRow("its own") << "match-plane"
                             << R"({"plane":3,"as":null})";
    QTest::newRow("a pose") << "stop-odometry"
                            << R"({"pose":[1.5,-2.25,0,0.6,0,0,0.8]})";
    QTest::newRow("a floor") << "place-floor"
                             << R"({"pose":[1.5,-2.25,3.2,0.6,0,0,0.8]})";
    QTest::newRow("a floor left to odometry") << "place-floor"
                                              << R"({"pose":null})";
    QTest::newRow("no pose") << "stop-odometry"
                             << R"({"pose":null})";
}

void MapEditTest::everyKindComesBack()
{
    QFETCH(QString, kind);
    QFETCH(QString, payload);

    const auto edit = readMapEditJson(4, kind.toStdString(), payload.toStdString(), "here");

    QVERIFY2(edit, edit ? "" : edit.error().message.c_str());
    QCOMPARE(edit->scan, 4);
    QVERIFY(isMapEditKind(kind.toStdString()));
    QCOMPARE(QString::fromStdString(std::string{name(edit->kind)}), kind);
    QCOMPARE(QString::fromStdString(mapEditJson(*edit)), payload);
}

void MapEditTest::whatIsNoPayloadIsRefused_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("payload");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* what, const char* kind, const QString& payload, const char* message) {
        QTest::newRow(what) << kind << payload << QString("here: ") + message;
    };
    row("an edit of planes", "rename", R"({"planes":[3],"text":""})", "there is no edit 'rename'");
    row("no object", "omit-stop", "[]", "the payload is not that of 'omit-stop'");
    row("nothing in it", "omit-stop", "{}", "the payload of 'omit-stop' lacks something");
    row("a word for a switch", "omit-stop", R"({"on":"yes"})",
        "'on' does not belong into the payload of this edit, or is of a wrong type");
    row("something else", "omit-stop", R"({"why":true})",
        "'why' does not belong into the payload of this edit, or is of a wrong type");
    row("something more", "omit-stop", R"({"on":true,"why":1})", "the payload is not that of 'omit-stop'");
    row("half a scan", "order-stop", R"({"before":1.5})", "'before' is no number of a scan");
    row("a negative plane", "match-plane", R"({"plane":-1,"as":null})", "'plane' is no plane number");
    row("a plane beyond int", "match-plane", R"({"plane":2147483648,"as":null})", "'plane' is no plane number");
    row("only one plane", "match-plane", R"({"plane":1})", "the payload of 'match-plane' lacks something");
    row("a plane of no scan", "match-plane", R"({"plane":1,"as":{"plane":2}})", "'as' is no plane of a scan");
    row("a floor of six", "place-floor", R"({"pose":[0,0,0,1,0,0]})", "'pose' is not [x,y,z,qw,qx,qy,qz]");
    row("a pose of six", "stop-odometry", R"({"pose":[0,0,0,1,0,0]})", "'pose' is not [x,y,z,qw,qx,qy,qz]");
    row("no rotation", "stop-odometry", R"({"pose":[0,0,0,0,0,0,0]})", "'pose' is not [x,y,z,qw,qx,qy,qz]");
    row("too far", "stop-odometry", R"({"pose":[1e7,0,0,1,0,0,0]})", "'pose' is not [x,y,z,qw,qx,qy,qz]");
    row("a key twice", "omit-stop", R"({"on":true,"on":false})", "the key 'on' is there twice; remove one of the two");
    row("a large payload", "omit-stop", QString(" ").repeated(4097), "the payload is larger than 4096 bytes");
}

void MapEditTest::whatIsNoPayloadIsRefused()
{
    QFETCH(QString, kind);
    QFETCH(QString, payload);
    QFETCH(QString, message);

    const auto edit = readMapEditJson(1, kind.toStdString(), payload.toStdString(), "here");

    QVERIFY(!edit);
    QVERIFY(edit.error().code == ErrorCode::Unreadable);
    QCOMPARE(QString::fromStdString(edit.error().message), message);
}

void MapEditTest::editsAreThereWhenTheFileIsOpenedAgain()
{
    int first = 0;
    {
        auto project = PwscanProject::open(path_);
        QVERIFY(project);
        const auto seq = project->append(matchOf(2, 3, SeenPlane{1, 5}));
        QVERIFY(seq);
        first = *seq;
        QVERIFY(project->append(matchOf(1, 4, std::nullopt)));
        QVERIFY(project->setUndone(first, true));
        // A scan that is not there, a plane that cannot be.
        QVERIFY(project->append(matchOf(9, 3, std::nullopt)).error().code == ErrorCode::Usage);
        QVERIFY(project->append(matchOf(1, kNoPlane, std::nullopt)).error().code == ErrorCode::Usage);
    }

    const auto edits = mapEditsOfPwscan(path_);

    QVERIFY(edits);
    QCOMPARE(edits->edits.size(), std::size_t(2));
    QCOMPARE(edits->edits.front().seq, first);
    QVERIFY(edits->edits.front().undone);
    QCOMPARE(edits->edits.front().edit.as->plane, 5);
    const auto inForce = editsInForce(edits->edits);
    QCOMPARE(inForce.size(), std::size_t(1));
    QCOMPARE(inForce.front().scan, 1);
    QCOMPARE(inForce.front().plane, 4);
    QVERIFY(!inForce.front().as);
}

void MapEditTest::editsOfPlanesAndOfTheMapStandBesideEachOther()
{
    auto project = PwscanProject::open(path_);
    QVERIFY(project);
    const auto hidden = project->append(1, Edit{Edit::Kind::Hide, {3}, {}, true});
    const auto matched = project->append(matchOf(1, 3, std::nullopt));

    QVERIFY(hidden && matched && *matched > *hidden);
    QCOMPARE(project->edits(1)->size(), std::size_t(1));
    QCOMPARE(project->mapEdits()->size(), std::size_t(1));
    const auto read = readRecordingPwscan(path_, 1);
    QVERIFY(read);
    QVERIFY2(!read->read.damaged, "an edit of the map is no edit of planes that cannot be read");
    QCOMPARE(read->notes.edits.size(), std::size_t(1));
    QVERIFY(!pwscanProblems(path_).damaged);
}

void MapEditTest::aBadEditIsNamedAndLeftOut()
{
    std::ofstream out(path_, std::ios::binary | std::ios::trunc);
    QVERIFY(writeScansPwscan(out, 1, [](std::size_t) {
        WrittenScan scan = threeSlices();
        scan.notes.mapEdits.push_back({0, matchOf(1, kNoPlane, std::nullopt), false});
        scan.notes.mapEdits.push_back({0, matchOf(1, 2, std::nullopt), false});
        return scan;
    }));
    out.close();

    const auto edits = mapEditsOfPwscan(path_);
    const RecordingProblems problems = pwscanProblems(path_);

    QVERIFY(edits);
    QCOMPARE(edits->edits.size(), std::size_t(1));
    QCOMPARE(edits->problems.size(), std::size_t(1));
    QVERIFY(problems.damaged);
    QCOMPARE(edits->problems.front(), problems.warnings.front());
    QVERIFY2(problems.warnings.front().ends_with("edit 1: 'plane' is no plane number; it is not applied"),
             problems.warnings.front().c_str());
}

void MapEditTest::whatIsWrittenWithAScanIsOfThatScan()
{
    std::ofstream out(path_, std::ios::binary | std::ios::trunc);
    QVERIFY(writeScansPwscan(out, 2, [](std::size_t number) {
        WrittenScan scan = threeSlices();
        scan.notes.mapEdits.push_back({0, matchOf(77, static_cast<PlaneId>(number), std::nullopt), number == 0});
        return scan;
    }));
    out.close();

    const auto edits = mapEditsOfPwscan(path_);

    QVERIFY(edits);
    QCOMPARE(edits->edits.size(), std::size_t(2));
    QCOMPARE(edits->edits[0].edit.scan, 1);
    QVERIFY(edits->edits[0].undone);
    QCOMPARE(edits->edits[1].edit.scan, 2);
    QCOMPARE(edits->edits[1].edit.plane, 1);
}

PLANEWRIGHT_TEST(MapEditTest)
#include "map_edit_test.moc"
