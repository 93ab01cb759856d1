// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "run_program.h"
#include "tests/test_program.h"

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct Place {
    double x, y, z;
};

/// The point that a ray from a place in a room meets: 6 m by 8 m, and 2.6 m high, with its origin in the middle of the
/// floor.
Place wallSeen(const Place& from, double azimuth, double elevation)
{
    const double ray[3]{std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                        std::sin(elevation)};
    const double low[3]{-3.0 - from.x, -4.0 - from.y, 0.0 - from.z};
    const double high[3]{3.0 - from.x, 4.0 - from.y, 2.6 - from.z};
    double range = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(ray[axis]) > 1e-12)
            range = std::min(range, (ray[axis] > 0.0 ? high[axis] : low[axis]) / ray[axis]);
    }
    return {range * ray[0], range * ray[1], range * ray[2]};
}

/// A scan of that room by a scanner that turns about the vertical, which stands turned by so much [rad].
QByteArray ptxScan(const Place& from, double turn)
{
    constexpr int kColumns = 120;
    constexpr int kRows = 121;
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    QByteArray text;
    const auto number = [](double value) { return QByteArray::number(value, 'f', 6); };
    text += QByteArray::number(kColumns) + "\n" + QByteArray::number(kRows) + "\n";
    text += number(from.x) + " " + number(from.y) + " " + number(from.z) + "\n1 0 0\n0 1 0\n0 0 1\n";
    text += number(c) + " " + number(s) + " 0 0\n" + number(-s) + " " + number(c) + " 0 0\n0 0 1 0\n";
    text += number(from.x) + " " + number(from.y) + " " + number(from.z) + " 1\n";
    for (int column = 0; column < kColumns; ++column) {
        for (int row = 0; row < kRows; ++row) {
            const double azimuth = 3.0 * kDegree * column;
            const Place seen = wallSeen(from, azimuth + turn, kDegree * (row - 60));
            const double x = c * seen.x + s * seen.y;
            const double y = -s * seen.x + c * seen.y;
            text += number(x) + " " + number(y) + " " + number(seen.z) + " 0.5\n";
        }
    }
    return text;
}

const Place kFirst{-1.0, -1.5, 1.2};
const Place kSecond{0.8, 1.0, 1.2};
constexpr double kSecondTurn = 0.3;

QByteArray twoScans()
{
    return ptxScan(kFirst, 0.0) + ptxScan(kSecond, kSecondTurn);
}

/// Rows of a planes CSV below its two header lines.
QList<QList<QByteArray>> rowsOf(const QByteArray& planes)
{
    QList<QList<QByteArray>> rows;
    for (const QByteArray& line : planes.split('\n').mid(2)) {
        if (!line.isEmpty())
            rows << line.split(',');
    }
    return rows;
}

}  // namespace

/// Clouds of points wherever a recording goes.
class CliCloudsTest : public QObject {
    Q_OBJECT

private slots:
    void extractFindsTheWallsInTheScansOwnFrame();
    void infoTellsWhatWasRecovered();
    void convertKeepsPosesAsStops();
    void aConvertedCloudGivesTheSamePlanes();
    void mapTakesTheScansAsStops();
    void aFolderOfScansIsStopsWithTheirPoses();
    void calibrateRefusesACloud();
    void validateNamesTheScanAndWhatIsWrong();
    void theOfficeHasItsPlanes();
};

void CliCloudsTest::extractFindsTheWallsInTheScansOwnFrame()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("room.ptx"), twoScans());

    const ProgramRun run = runProgram(
        {"extract", "room.ptx", "--scan", "0", "--preset", "precise", "--sensor", "utm-30lx", "--planes", "planes.csv"},
        folder.path());

    QVERIFY2(run.code == 0, run.err.constData());
    QVERIFY2(run.err.contains("imported as a scanner with the pitch axis (0 0 -1)"), run.err.constData());
    // Four walls, floor and ceiling, by their distances from the first place.
    QList<double> found;
    for (const QList<QByteArray>& row : rowsOf(bytesOf(folder.filePath("planes.csv"))))
        found << row[4].toDouble();
    std::sort(found.begin(), found.end());
    const QList<double> expected{1.2, 1.4, 2.0, 2.5, 4.0, 5.5};
    QCOMPARE(found.size(), expected.size());
    for (qsizetype i = 0; i < expected.size(); ++i)
        QVERIFY2(std::abs(found[i] - expected[i]) < 0.002, qPrintable(QString::number(found[i])));
    QCOMPARE(bytesOf(folder.filePath("planes.csv")).count(",floor\n"), 1);
    QCOMPARE(bytesOf(folder.filePath("planes.csv")).count(",ceiling\n"), 1);
    QCOMPARE(bytesOf(folder.filePath("planes.csv")).count(",wall\n"), 4);
}

void CliCloudsTest::infoTellsWhatWasRecovered()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("room.ptx"), twoScans());

    const ProgramRun run = runProgram({"info", "room.ptx", "--json"}, folder.path());

    QVERIFY2(run.code == 0, run.err.constData());
    const QJsonArray scans = QJsonDocument::fromJson(run.out).array();
    QCOMPARE(scans.size(), 2);
    const QJsonObject second = scans[1].toObject();
    QCOMPARE(second["slices"].toInt(), 120);
    QCOMPARE(second["beams"].toInt(), 121);
    QCOMPARE(second["returns"].toInt(), 120 * 121);
    QCOMPARE(second["bearing_step_deg"].toDouble(), 1.0);
    QCOMPARE(second["extra"].toObject()["recovered_axis"].toString(), QString("0 0 -1"));
    QCOMPARE(second["extra"].toObject()["recovered_beams"].toString(), QString("evenly spaced"));
    // Coordinates have six decimals and ranges whole millimetres.
    QVERIFY(second["extra"].toObject()["recovered_largest_off_mm"].toString().toDouble() < 0.51);
}

void CliCloudsTest::convertKeepsPosesAsStops()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("room.ptx"), twoScans());

    const ProgramRun run = runProgram({"convert", "room.ptx", "room.pwscan"}, folder.path());
    const ProgramRun mapped = runProgram(
        {"map", "room.pwscan", "--preset", "precise", "--sensor", "utm-30lx", "--poses", "poses.txt"}, folder.path());

    QVERIFY2(run.code == 0, run.err.constData());
    QVERIFY2(mapped.code == 0, mapped.err.constData());
    QCOMPARE(bytesOf(folder.filePath("poses.txt")).count('\n'), 3);
}

void CliCloudsTest::aConvertedCloudGivesTheSamePlanes()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("room.ptx"), ptxScan(kFirst, 0.0));
    const QStringList extract{"--preset", "precise", "--sensor", "utm-30lx", "--planes"};

    runProgram({"convert", "room.ptx", "room.pwscan"}, folder.path());
    runProgram({"convert", "room.ptx", "room.csv.gz"}, folder.path());
    for (const char* name : {"room.ptx", "room.pwscan", "room.csv.gz"}) {
        const ProgramRun run =
            runProgram(QStringList{"extract", name} + extract + QStringList{name + QString(".csv")}, folder.path());
        QVERIFY2(run.code == 0, run.err.constData());
    }

    QVERIFY(!bytesOf(folder.filePath("room.ptx.csv")).isEmpty());
    QCOMPARE(bytesOf(folder.filePath("room.pwscan.csv")), bytesOf(folder.filePath("room.ptx.csv")));
    QCOMPARE(bytesOf(folder.filePath("room.csv.gz.csv")), bytesOf(folder.filePath("room.ptx.csv")));
}

void CliCloudsTest::mapTakesTheScansAsStops()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("room.ptx"), twoScans());

    const ProgramRun run = runProgram({"map", "room.ptx", "--preset", "precise", "--sensor", "utm-30lx", "--poses",
                                       "poses.txt", "--planes", "map.csv"},
                                      folder.path());

    QVERIFY2(run.code == 0, run.err.constData());
    const QList<QByteArray> lines = bytesOf(folder.filePath("poses.txt")).trimmed().split('\n');
    QCOMPARE(lines.size(), 3);
    const QList<QByteArray> first = lines[1].split(' ');
    const QList<QByteArray> second = lines[2].split(' ');
    QCOMPARE(second.size(), 8);
    // From the first stop, which stands unturned, to the second.
    QVERIFY2(std::abs(second[1].toDouble() - first[1].toDouble() - 1.8) < 0.005, lines[2].constData());
    QVERIFY2(std::abs(second[2].toDouble() - first[2].toDouble() - 2.5) < 0.005, lines[2].constData());
    QVERIFY2(std::abs(second[6].toDouble() - std::sin(0.5 * kSecondTurn)) < 0.001, lines[2].constData());
    // The same six planes from both.
    QCOMPARE(rowsOf(bytesOf(folder.filePath("map.csv"))).size(), 6);
}

void CliCloudsTest::aFolderOfScansIsStopsWithTheirPoses()
{
    // A nodding scanner in the middle of the room, in 3DTK's frame: x right, y up, z ahead, in centimetres.
    QByteArray points;
    for (int slice = 0; slice < 60; ++slice) {
        const double pitch = kDegree * (20.0 + 2.0 * slice);
        for (int beam = 0; beam <= 160; ++beam) {
            const double bearing = kDegree * (10.0 + beam);
            const double x = std::cos(bearing);
            const double y = std::sin(bearing) * std::sin(pitch);
            const double z = -std::sin(bearing) * std::cos(pitch);
            const Place seen = wallSeen({0.0, 0.0, 1.2}, std::atan2(y, x), std::asin(z));
            points += QByteArray::number(100.0 * seen.x, 'f', 4) + " " + QByteArray::number(100.0 * seen.z, 'f', 4) +
                      " " + QByteArray::number(100.0 * seen.y, 'f', 4) + "\n";
        }
    }
    const QTemporaryDir folder;
    QDir(folder.path()).mkdir("scans");
    writeBytes(folder.filePath("scans/scan000.3d"), points);
    writeBytes(folder.filePath("scans/scan001.3d"), points);
    writeBytes(folder.filePath("scans/scan000.pose"), "0 0 0\n0 0 0\n");
    writeBytes(folder.filePath("scans/scan001.pose"), "0 0 2\n0 0 0\n");

    const ProgramRun info = runProgram({"info", "scans", "--json"}, folder.path());
    const ProgramRun map = runProgram(
        {"map", "scans", "--preset", "precise", "--sensor", "utm-30lx", "--planes", "map.csv"}, folder.path());

    QVERIFY2(info.code == 0, info.err.constData());
    const QJsonArray scans = QJsonDocument::fromJson(info.out).array();
    QCOMPARE(scans.size(), 2);
    QCOMPARE(scans[1].toObject()["name"].toString(), QString("scan001.3d"));
    QCOMPARE(scans[1].toObject()["beams"].toInt(), 161);
    QCOMPARE(scans[1].toObject()["slices"].toInt(), 60);
    // Coordinates have four decimals.
    QVERIFY(std::abs(scans[1].toObject()["pitch_first_deg"].toDouble() - 20.0) < 0.001);
    QVERIFY2(map.code == 0, map.err.constData());
    QVERIFY(!rowsOf(bytesOf(folder.filePath("map.csv"))).isEmpty());
}

void CliCloudsTest::calibrateRefusesACloud()
{
    const QTemporaryDir folder;
    writeBytes(folder.filePath("room.ptx"), ptxScan(kFirst, 0.0));

    const ProgramRun run = runProgram({"calibrate", "room.ptx", "--sensor", "utm-30lx"}, folder.path());

    QCOMPARE(run.code, 2);
    QVERIFY2(run.err.contains("room.ptx: this is an imported cloud"), run.err.constData());
}

void CliCloudsTest::validateNamesTheScanAndWhatIsWrong()
{
    const QTemporaryDir folder;
    QByteArray text = twoScans();
    text.chop(40);
    writeBytes(folder.filePath("room.ptx"), text);
    writeBytes(folder.filePath("good.ptx"), ptxScan(kFirst, 0.0));
    QDir(folder.path()).mkdir("nothing");

    const ProgramRun bad = runProgram({"validate", "room.ptx"}, folder.path());
    const ProgramRun good = runProgram({"validate", "good.ptx"}, folder.path());
    const ProgramRun empty = runProgram({"validate", "nothing"}, folder.path());

    QCOMPARE(bad.code, 3);
    QVERIFY2(bad.out.contains("get the whole file"), bad.out.constData());
    QCOMPARE(good.code, 0);
    QVERIFY(good.out.endsWith("good.ptx: valid\n"));
    QCOMPARE(empty.code, 3);
    QVERIFY2(empty.out.contains("nothing: there is no scan in this folder"), empty.out.constData());
}

void CliCloudsTest::theOfficeHasItsPlanes()
{
    const QString office = qEnvironmentVariable("PLANEWRIGHT_TEST_DATA") + "/pcl/office1.pcd";
    if (!QFile::exists(office))
        QSKIP("office1.pcd is not here; PLANEWRIGHT_TEST_DATA names the folder of the test data");
    const QTemporaryDir folder;

    const ProgramRun run =
        runProgram({"extract", office, "--preset", "precise", "--planes", folder.filePath("planes.csv")});

    QVERIFY2(run.code == 0, run.err.constData());
    QVERIFY2(run.err.contains("of a flat image"), run.err.constData());
    // It is known for a depth camera, whose steps of 75 mm at 5 m do not make planes of their own: of the wall there,
    // seen in more than half of the picture, no layers are left but two; by a laser's noise it would be a plane for
    // each step.
    const QList<QList<QByteArray>> planes = rowsOf(bytesOf(folder.filePath("planes.csv")));
    QVERIFY2(planes.size() >= 5 && planes.size() <= 30, QByteArray::number(planes.size()).constData());
    qsizetype ahead = 0;
    for (const QList<QByteArray>& cells : planes)
        ahead += std::abs(cells.at(2).toDouble()) > 0.95 && cells.at(4).toDouble() > 4.5 && cells.at(6).toInt() > 3000;
    QVERIFY2(ahead >= 1 && ahead <= 2, QByteArray::number(ahead).constData());
}

PLANEWRIGHT_TEST(CliCloudsTest)
#include "cli_clouds_test.moc"
