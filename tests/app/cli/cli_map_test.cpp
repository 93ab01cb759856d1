// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <optional>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/formats/pwscan_project.h"
#include "run_program.h"
#include "tests/test_program.h"

class CliMapTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void aBuildingHasAScanForEachStop();
    void theMapIsTrue();
    void planesTellWhichStopsSawThem();
    void theStopsComeAsOneProject();
    void resultsOfExtractionsAreStopsToo();
    void withoutOutputsThereIsATable();
    void odometryMayComeFromAFile();
    void floorsAreOneBuildingWhereTheyAreSaidToBe();
    void eachFloorHasAPlanOfItsOwn();
    void parametersOfMapsAreTakenByMap();
    void editsOfTheMapAreHonoured();
    void floorsStandWhereTheyWerePlacedByHand();
    void whatCannotBeMappedIsNamed_data();
    void whatCannotBeMappedIsNamed();
    void theSameStopsGiveTheSameBytes();

private:
    ProgramRun run(const QStringList& arguments) const { return runProgram(arguments, folder_.path()); }
    QString path(const QString& name) const { return folder_.filePath(name); }
    QList<QList<double>> poses(const QString& name) const;

    QTemporaryDir folder_;
};

/// The numbers of a trajectory's lines.
QList<QList<double>> CliMapTest::poses(const QString& name) const
{
    QList<QList<double>> all;
    for (const QByteArray& line : bytesOf(path(name)).split('\n')) {
        if (line.isEmpty() || line.startsWith('#'))
            continue;
        QList<double> numbers;
        for (const QByteArray& number : line.split(' '))
            numbers += number.toDouble();
        all += numbers;
    }
    return all;
}

void CliMapTest::initTestCase()
{
    const ProgramRun made = run({"simulate", "building", "--floors", "1", "--stops", "20", "--seed", "3", "-o",
                                 "floor.pwscan", "--truth", "true.csv", "--truth-poses", "true.txt"});
    QVERIFY2(made.code == 0, made.err);
}

void CliMapTest::aBuildingHasAScanForEachStop()
{
    const ProgramRun info = run({"info", "floor.pwscan"});

    QCOMPARE(info.code, 0);
    for (int stop = 1; stop <= 20; ++stop)
        QVERIFY(info.out.contains("stop " + QByteArray::number(stop)));
    QCOMPARE(poses("true.txt").size(), 20);
    QCOMPARE(run({"simulate", "building", "-o", "x.csv"}).code, 2);
    QCOMPARE(run({"simulate", "building", "--floors", "3", "--stops", "2", "-o", "x.pwscan"}).code, 2);
    QCOMPARE(run({"simulate", "office", "--stops", "2", "-o", "x.pwscan"}).code, 2);
    QCOMPARE(run({"simulate", "office", "--floors", "2", "-o", "x.pwscan"}).code, 2);
    QVERIFY(!QFile::exists(path("x.pwscan")));
}

/// Stops stand 3 m apart. Over the first half of the way planes put them right to two centimetres where odometry is off
/// by decimetres.
void CliMapTest::theMapIsTrue()
{
    const ProgramRun made = run({"map", "floor.pwscan", "--poses", "poses.txt", "--overwrite"});
    QVERIFY2(made.code == 0, made.err);

    const auto truth = poses("true.txt");
    const auto found = poses("poses.txt");

    QVERIFY(found.size() > 10);
    for (int i = 0; i <= 10; ++i) {
        QCOMPARE(found[i][0], static_cast<double>(i));
        const double off = std::hypot(found[i][1] - truth[i][1], found[i][2] - truth[i][2], found[i][3] - truth[i][3]);
        QVERIFY2(off < 0.02, qPrintable(QString::number(off)));
    }
}

void CliMapTest::planesTellWhichStopsSawThem()
{
    const ProgramRun made =
        run({"map", "floor.pwscan", "--planes", "m.csv", "--planes", "m.json", "--planes", "m.obj", "--overwrite"});
    QVERIFY2(made.code == 0, made.err);

    const QByteArray csv = bytesOf(path("m.csv"));
    QVERIFY(csv.contains(",name,class,stops\n"));
    bool isShared = false;
    for (const QByteArray& line : csv.split('\n'))
        isShared = isShared || (line.contains(",floor,0 1 2 3 4 5 6 7 8 "));
    QVERIFY2(isShared, "stops in a row see the floor");
    QVERIFY(bytesOf(path("m.json")).contains("\"stops\":[0,1,2,3,4,5,6,7,8,"));
    QVERIFY(bytesOf(path("m.obj")).contains("plane_0"));
    // They are planes as any: compare reads them.
    const ProgramRun compared = run({"compare", "m.csv", "true.csv", "--json"});
    QVERIFY2(compared.code == 0, compared.err);
}

void CliMapTest::theStopsComeAsOneProject()
{
    for (int scan = 1; scan <= 2; ++scan)
        QCOMPARE(run({"convert", "floor.pwscan", QString("s%1.csv").arg(scan), "--scan", QString::number(scan)}).code,
                 0);

    const ProgramRun made = run({"map", "s1.csv", "s2.csv", "--odometry", "two.txt", "-o", "two.pwscan"});

    QCOMPARE(made.code, 3);  // there is no such trajectory
    const auto truth = poses("true.txt");
    QByteArray text;
    for (int i = 0; i < 2; ++i) {
        for (const double number : truth[i])
            text += QByteArray::number(number, 'g', 10) + ' ';
        text.back() = '\n';
    }
    writeBytes(path("two.txt"), text);
    const ProgramRun again = run({"map", "s1.csv", "s2.csv", "--odometry", "two.txt", "-o", "two.pwscan"});
    QVERIFY2(again.code == 0, again.err);
    const ProgramRun fromProject = run({"map", "two.pwscan"});
    QCOMPARE(fromProject.code, 0);
    QVERIFY(fromProject.out.contains("two.pwscan, scan 2"));
    QCOMPARE(run({"validate", "two.pwscan"}).code, 0);
}

/// The planes that extract has written give the map that the recordings give.
void CliMapTest::resultsOfExtractionsAreStopsToo()
{
    QStringList results;
    for (int scan = 1; scan <= 20; ++scan) {
        results += QString("r%1.json").arg(scan);
        QCOMPARE(run({"extract", "floor.pwscan", "--scan", QString::number(scan), "-P", "likelihood.chance-planes=200",
                      "--planes", results.back()})
                     .code,
                 0);
    }
    QCOMPARE(run({"map", "floor.pwscan", "--odometry", "true.txt", "--poses", "from-scans.txt"}).code, 0);

    const ProgramRun made =
        run(QStringList{"map"} + results + QStringList{"--odometry", "true.txt", "--poses", "from-results.txt"});

    QVERIFY2(made.code == 0, made.err);
    const auto fromScans = poses("from-scans.txt");
    const auto fromResults = poses("from-results.txt");
    QCOMPARE(fromResults.size(), fromScans.size());
    for (int i = 0; i < fromScans.size(); ++i) {
        for (int j = 0; j < 8; ++j)
            QVERIFY(std::abs(fromResults[i][j] - fromScans[i][j]) < 1e-4);  // files have nine digits
    }
    const ProgramRun project = run(QStringList{"map"} + results + QStringList{"-o", "none.pwscan"});
    QCOMPARE(project.code, 2);
    QVERIFY(project.err.contains("no slices"));
}

void CliMapTest::withoutOutputsThereIsATable()
{
    const ProgramRun made = run({"map", "floor.pwscan"});

    QCOMPARE(made.code, 0);
    QCOMPARE(made.out.count('\n'), 21);
    QVERIFY(made.out.contains("first"));
    QVERIFY(made.out.contains("planes"));
}

void CliMapTest::odometryMayComeFromAFile()
{
    writeBytes(path("one.txt"), "0 0 0 0 0 0 0 1\n");

    const ProgramRun made = run({"map", "floor.pwscan", "--odometry", "one.txt"});

    QCOMPARE(made.code, 3);
    QCOMPARE(made.err, QByteArray("planewright-cli: one.txt: has 1 poses, but there are 20 stops; give one for each "
                                  "scan, in their order\n"));
    QCOMPARE(run({"map", "floor.pwscan", "--odometry", "true.txt"}).code, 0);
}

void CliMapTest::floorsAreOneBuildingWhereTheyAreSaidToBe()
{
    const ProgramRun made = run({"simulate", "building", "--floors", "2", "--stops", "2", "-o", "two-floors.pwscan",
                                 "--truth-poses", "floors.txt"});
    QVERIFY2(made.code == 0, made.err);
    const ProgramRun unsaid = run({"map", "two-floors.pwscan", "--planes", "building.csv"});
    QCOMPARE(unsaid.code, 2);
    QVERIFY(unsaid.err.contains("--floor-poses"));

    // Each floor has one stop: its frame. The trajectory says where these are.
    const ProgramRun said = run(
        {"map", "two-floors.pwscan", "--floor-poses", "floors.txt", "--poses", "p.txt", "--planes", "building.csv"});

    QVERIFY2(said.code == 0, said.err);
    const auto given = poses("floors.txt");
    const auto found = poses("p.txt");
    QCOMPARE(found.size(), 2);
    for (int i = 0; i < 8; ++i)
        QVERIFY(std::abs(found[1][i] - given[1][i]) < 1e-6);
    // Storeys are 3.2 m high: the floor of the second lies 3.2 m above that of the first, 1.1 m below the scanner.
    std::optional<double> lowest;
    std::optional<double> highest;
    for (const QByteArray& line : bytesOf(path("building.csv")).split('\n')) {
        if (!line.contains(",floor,"))
            continue;
        const QList<QByteArray> cells = line.split(',');
        const double height = cells[4].toDouble() * (cells[3].toDouble() > 0.0 ? 1.0 : -1.0);
        lowest = std::min(lowest.value_or(height), height);
        highest = std::max(highest.value_or(height), height);
    }
    QVERIFY(lowest && std::abs(*highest - *lowest - 3.2) < 0.03);
}

/// Floors have the same walls; their plans have the stop of that floor alone.
void CliMapTest::eachFloorHasAPlanOfItsOwn()
{
    const ProgramRun made = run({"map", "two-floors.pwscan", "--floor-poses", "floors.txt", "--floor-plan", "plan.svg",
                                 "--floor-plan", "plan.dxf"});

    QVERIFY2(made.code == 0, made.err);
    for (int floor = 0; floor < 2; ++floor) {
        const QByteArray svg = bytesOf(path(QString("plan-floor-%1.svg").arg(floor)));
        QVERIFY(svg.contains("Plan 1:100"));
        QCOMPARE(svg.count("class=\"stop\""), 1);
        QVERIFY(svg.contains('>' + QByteArray::number(floor) + "</text>"));
        QVERIFY(svg.count("wall cut") > 4);
        QVERIFY(bytesOf(path(QString("plan-floor-%1.dxf").arg(floor))).contains("  0\nLINE\n"));
    }
    QVERIFY(!QFile::exists(path("plan.svg")));
    QCOMPARE(run({"map", "floor.pwscan", "--floor-plan", "one.svg"}).code, 0);
    QVERIFY(bytesOf(path("one.svg")).count("class=\"stop\"") > 10);
}

/// Where no stop may be compared with another, each but the first rests on odometry alone.
void CliMapTest::parametersOfMapsAreTakenByMap()
{
    const ProgramRun made = run({"map", "floor.pwscan", "-P", "map.least-pairs=50", "-P", "segments.min-points=5"});
    const ProgramRun usual = run({"map", "floor.pwscan"});

    QVERIFY2(made.code == 0, made.err);
    QCOMPARE(made.out.count("odometry alone"), 19);
    QVERIFY(usual.out.count("odometry alone") < 19);
    QCOMPARE(run({"extract", "floor.pwscan", "-P", "map.least-pairs=50"}).code, 2);
}

/// A stop is taken out, and planes of another are their own; a project made of that has it applied.
void CliMapTest::editsOfTheMapAreHonoured()
{
    QVERIFY(QFile::copy(path("floor.pwscan"), path("edited.pwscan")));
    {
        auto project = planewright::PwscanProject::open(path("edited.pwscan").toStdString());
        QVERIFY(project);
        planewright::MapEdit edit;
        edit.scan = 5;
        QVERIFY(project->append(edit));
        edit.kind = planewright::MapEdit::Kind::Match;
        edit.scan = 3;
        edit.plane = 99;
        QVERIFY(project->append(edit));
        edit.plane = 0;
        QVERIFY(project->append(edit));
    }
    const auto lines = [](const ProgramRun& made) { return made.out.split('\n'); };

    const ProgramRun edited = run({"map", "edited.pwscan"});
    const ProgramRun plain = run({"map", "edited.pwscan", "--no-edits"});
    const ProgramRun project = run({"map", "edited.pwscan", "-o", "applied.pwscan"});
    const ProgramRun applied = run({"map", "applied.pwscan"});

    QVERIFY2(edited.code == 0, edited.err);
    QCOMPARE(lines(edited).size(), 21);
    QVERIFY(!edited.out.contains("edited.pwscan, scan 5\n"));
    QVERIFY(edited.err.contains("edited.pwscan, scan 3, P99: this plane is not in the map"));
    QCOMPARE(lines(plain).size(), 22);
    QVERIFY(!plain.err.contains("P99"));
    QVERIFY2(project.code == 0, project.err);
    QVERIFY2(applied.code == 0, applied.err);
    QCOMPARE(lines(applied).size(), 21);
    QVERIFY(applied.err.contains("applied.pwscan, scan 3, P99: this plane is not in the map"));
    QCOMPARE(run({"validate", "edited.pwscan"}).code, 0);
}

void CliMapTest::floorsStandWhereTheyWerePlacedByHand()
{
    QVERIFY(run({"simulate", "building", "--floors", "2", "--stops", "6", "-o", "placed.pwscan", "--truth-poses",
                 "placed.txt"})
                .code == 0);
    QVERIFY(run({"map", "placed.pwscan"}).err.contains("--floor-poses"));
    {
        auto project = planewright::PwscanProject::open(path("placed.pwscan").toStdString());
        QVERIFY(project);
        planewright::MapEdit edit;
        edit.kind = planewright::MapEdit::Kind::Floor;
        edit.scan = 4;  // the first of the upper floor
        edit.place = planewright::Pose{Eigen::Quaterniond::Identity(), {10.0, 20.0, 3.5}};
        QVERIFY(project->append(edit));
    }

    const ProgramRun placed = run({"map", "placed.pwscan", "--poses", "placed-poses.txt", "-o", "kept.pwscan"});
    const ProgramRun kept = run({"map", "kept.pwscan", "--poses", "kept-poses.txt"});

    QVERIFY2(placed.code == 0, placed.err);
    QVERIFY2(kept.code == 0, kept.err);
    QVERIFY(bytesOf(path("placed-poses.txt")).contains("\n3 10 20 3.5 0 0 0 1\n"));
    QCOMPARE(bytesOf(path("kept-poses.txt")), bytesOf(path("placed-poses.txt")));
    QVERIFY(run({"map", "placed.pwscan", "--no-edits"}).err.contains("--floor-poses"));
}

void CliMapTest::whatCannotBeMappedIsNamed_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("code");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char* name, const QStringList& options, int code, const char* message) {
        QTest::newRow(name) << options << code << QByteArray(message);
    };
    row("no input", {}, 2, "INPUT is required");
    row("missing", {"gone.pwscan"}, 3, "gone.pwscan");
    row("kind of input", {"planes.txt"}, 2, "planes.txt");
    row("kind of planes", {"floor.pwscan", "--planes", "m.xyz"}, 2, "m.xyz");
    row("kind of plan", {"floor.pwscan", "--floor-plan", "m.png"}, 2, "m.png");
    row("kind of project", {"floor.pwscan", "-o", "m.csv"}, 2, "m.csv");
    row("over its input", {"floor.pwscan", "-o", "floor.pwscan", "--overwrite"}, 2, "floor.pwscan");
    row("no covariance", {"bare.json"}, 3, "has no covariance");
    row("scale", {"floor.pwscan", "--plan-scale", "0"}, 2, "--plan-scale");
}

void CliMapTest::whatCannotBeMappedIsNamed()
{
    QFETCH(QStringList, options);
    QFETCH(int, code);
    QFETCH(QByteArray, message);

    writeBytes(path("bare.json"),
               R"({"format":"planewright-planes 1","planes":[{"id":0,"nx":0,"ny":0,"nz":1,"d":2}]})");

    const ProgramRun made = run(QStringList{"map"} + options);

    QCOMPARE(made.code, code);
    QVERIFY2(made.err.contains(message), made.err);
    QCOMPARE(made.err.count('\n'), 1);
}

void CliMapTest::theSameStopsGiveTheSameBytes()
{
    for (const char* name : {"a.json", "b.json"})
        QCOMPARE(run({"map", "floor.pwscan", "--planes", name}).code, 0);

    QCOMPARE(bytesOf(path("a.json")), bytesOf(path("b.json")));
}

PLANEWRIGHT_TEST(CliMapTest)
#include "cli_map_test.moc"
