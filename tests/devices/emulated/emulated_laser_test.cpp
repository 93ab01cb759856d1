// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_laser.h"

#include <cmath>
#include <numbers>

#include <QtTest>

#include "devices/emulated/emulated_laser_faults.h"
#include "tests/devices/emulated/laser_rig.h"
#include "tests/devices/scip/scip_text.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;
using Time = std::chrono::nanoseconds;

class EmulatedLaserTest : public QObject {
    Q_OBJECT

private slots:
    void answersAsARealUtm30lxDoes_data();
    void answersAsARealUtm30lxDoes();
    void framesHaveTheSizesOfRealOnes_data();
    void framesHaveTheSizesOfRealOnes();
    void mistakesHaveTheirStatus_data();
    void mistakesHaveTheirStatus();
    void requestsMayEndWithAnyLineEnd();
    void severalRequestsAreQueuedButNotTwoOfAKind();
    void tellsTheTimeInTimeModeOnly();
    void theNewProtocolLeavesTimeModeAtQuit();
    void aResetSetsTheClockToZero();
    void newModelsStartAnewWhenAskedTwice();
    void scip1IsLeftWhenAskedFor();
    void aScanIsMeasuredAfterTheRequestAndLeavesWhenItIsMeasured();
    void scansComeEveryTurnWithStampsOfStep0();
    void countsRunDownAndTheLaserGoesOff();
    void theIntervalLeavesTurnsOut();
    void quitEndsTheStreamBehindTheScanOnItsWay();
    void theLatestScanWasMeasuredBefore();
    void beamsSeeTheWallAtTheirMoments();
    void clustersGiveTheNearestRange();
    void intensitiesFallWithRange();
    void whatDoesNotComeBackHasTheModelsCode_data();
    void whatDoesNotComeBackHasTheModelsCode();
    void simulatedFaultsComeAndGo();
    void aClockThatDriftsRunsFast();
    void nextOutputIsNeverLate();
    void whoeverReadsTooLateHasMissedTheOldest();
    void unknownModelsAreRefused();
};

namespace {

/// The scans among bytes, each ending with its empty line.
std::vector<ScipFrame> scansIn(const std::string& bytes)
{
    return only<ScipFrame>(decode(bytes));
}

}  // namespace

void EmulatedLaserTest::answersAsARealUtm30lxDoes_data()
{
    QTest::addColumn<QString>("request");
    QTest::addColumn<QString>("reply");
    const auto row = [](const char* request, const char* reply) {
        QTest::newRow(request) << QString{request} << QString{reply};
    };
    row("VV",
        "VV\n00P\nVEND:Hokuyo Automatic Co.,Ltd.;[\nPROD:SOKUIKI Sensor TOP-URG UTM-30LX;P\n"
        "FIRM:P.1.05(17/Apr./2009);M\nPROT:SCIP 2.0;N\nSERI:00903971;:\n\n");
    row("PP",
        "PP\n00P\nMODL:UTM-30LX(Hokuyo Automatic Co.,Ltd.);U\nDMIN:23;7\nDMAX:60000;J\nARES:1440;^\nAMIN:0;?\n"
        "AMAX:1080;Z\nAFRT:540;0\nSCAN:2400;U\n\n");
    row("II",
        "II\n00P\nMODL:UTM-30LX(Hokuyo Automatic Co.,Ltd.);U\nLASR:ON;9\n"
        "SCSP:Initial(2400[rpm])<-Default setting by user;1\nMESM:CLASSIC;^\nSBPS:USB Full Speed;P\nTIME:4991D0;d\n"
        "STAT:Sensor works well.;8\n\n");
    row("BM", "BM\n02R\n\n");
    row("CR00", "CR00\n04T\n\n");
    row("QT", "QT\n00P\n\n");
    row("TM0", "TM0\n00P\n\n");
    row("ME0000108001101", "ME0000108001101\n00P\n\n");
    row("QT;a1", "QT;a1\n00P\n\n");
}

void EmulatedLaserTest::answersAsARealUtm30lxDoes()
{
    QFETCH(QString, request);
    QFETCH(QString, reply);
    EmulatedLaserOptions options = laserOptions();
    options.serial = "00903971";
    options.uptime = 4'821'456ms;
    LaserRig rig{options};

    QCOMPARE(rig.ask(request.toStdString()), reply.toStdString());
}

void EmulatedLaserTest::framesHaveTheSizesOfRealOnes_data()
{
    QTest::addColumn<QString>("request");
    QTest::addColumn<int>("bytes");
    QTest::addColumn<int>("lines");
    QTest::newRow("all") << "MD0000108000001" << 3372 << 51;
    QTest::newRow("intensities") << "ME0000108000001" << 6717 << 102;
    QTest::newRow("half a turn") << "MD0180090000001" << 2258 << 34;
}

void EmulatedLaserTest::framesHaveTheSizesOfRealOnes()
{
    QFETCH(QString, request);
    QFETCH(int, bytes);
    QFETCH(int, lines);
    LaserRig rig{laserOptions()};
    rig.ask(request.toStdString());

    const std::string scan = rig.hear(1s);

    QCOMPARE(static_cast<int>(scan.size()), bytes);
    QCOMPARE(static_cast<int>(std::count(scan.begin(), scan.end(), '\n')), 3 + lines + 1);
    QCOMPARE(scansIn(scan).size(), std::size_t(1));
}

void EmulatedLaserTest::mistakesHaveTheirStatus_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("request");
    QTest::addColumn<QString>("status");
    const auto row = [](const char* model, const char* request, const char* status) {
        QTest::addRow("%s %s", model, request) << QString{model} << QString{request} << QString{status};
    };
    row("UTM-30LX", "XY", "0E");
    row("UTM-30LX", "SCIP2.0", "0E");
    row("UTM-30LX", "RB", "0E");
    row("UTM-30LX", "ND0000108000000", "0E");
    row("UTM-30LX", "MD00001080", "0C");
    row("UTM-30LX", "VV1", "0D");
    row("UTM-30LX", "VV;12345678901234567", "0G");
    row("UTM-30LX", "VV;a#", "0H");
    row("UTM-30LX", "MDa000108000000", "01");
    row("UTM-30LX", "MD0000b08000000", "02");
    row("UTM-30LX", "MD00001080c0000", "03");
    row("UTM-30LX", "MD0000108100000", "04");
    row("UTM-30LX", "MD0010000900000", "05");
    row("UTM-30LX", "MD000010800000d", "07");
    row("UTM-30LX", "MD0000108000e00", "06");
    row("UTM-30LX", "TM1", "04");
    row("UTM-30LX", "TM2", "03");
    row("UTM-30LX", "TM3", "01");
    row("UTM-30LX", "SS019200", "04");
    row("UTM-30LX", "SS01920x", "01");
    row("UTM-30LX", "HS2", "01");
    row("UTM-30LX", "HS1", "00");
    row("UTM-30LX", "DB09", "01");
    row("UST-20LX", "ND0000108000000", "0F");
    row("UST-20LX", "CR01", "04");
    row("UST-20LX", "RB", "01");
    row("URG-04LX", "BM", "00");
    row("URG-04LX", "GD0044072501", "10");
    row("URG-04LX", "GD0043072501", "04");
    row("URG-04LX", "CR00", "03");
    row("URG-04LX", "CR05", "00");
    row("URG-04LX", "CR11", "02");
    row("URG-04LX", "SS019200", "03");
    row("URG-04LX", "SS115200", "00");
    row("URG-04LX", "SS115201", "02");
}

void EmulatedLaserTest::mistakesHaveTheirStatus()
{
    QFETCH(QString, model);
    QFETCH(QString, request);
    QFETCH(QString, status);
    LaserRig rig{laserOptions(model.toStdString())};
    const std::string line = request.toStdString();

    QCOMPARE(rig.ask(line), line + '\n' + withPlainSum(status.toStdString()) + "\n\n");
}

void EmulatedLaserTest::requestsMayEndWithAnyLineEnd()
{
    LaserRig rig{laserOptions()};

    rig.send("BM\rQT\r\n\n\nTM");
    rig.send("0\n");

    QCOMPARE(rig.hear(20ms), std::string{"BM\n02R\n\nQT\n00P\n\nTM0\n00P\n\n"});
}

void EmulatedLaserTest::severalRequestsAreQueuedButNotTwoOfAKind()
{
    LaserRig rig{laserOptions()};

    rig.send("BM\nQT\nBM\n");

    QCOMPARE(rig.hear(20ms), std::string{"BM\n02R\n\nQT\n00P\n\nBM\n0Bb\n\n"});
    QCOMPARE(rig.ask("BM"), std::string{"BM\n00P\n\n"});
}

void EmulatedLaserTest::tellsTheTimeInTimeModeOnly()
{
    EmulatedLaserOptions options = laserOptions();
    options.uptime = 16'000'000ms;
    LaserRig rig{options};
    rig.send("TM0\nTM1\n");

    QCOMPARE(rig.hear(50ms), std::string{"TM0\n00P\n\nTM1\n0Bb\n\n"});  // two of a kind
    rig.now = 0ms;
    LaserRig other{options};
    QCOMPARE(other.ask("TM0"), std::string{"TM0\n00P\n\n"});
    QCOMPARE(other.ask("TM0"), std::string{"TM0\n02R\n\n"});
    QCOMPARE(other.ask("TM1"), "TM1\n00P\n" + withPlainSum(plainNumber(16'000'020, 4)) + "\n\n");
    QCOMPARE(other.ask("QT"), std::string{"QT\n0Ee\n\n"});
    QCOMPARE(other.ask("BM"), std::string{"BM\n0Ee\n\n"});
    QCOMPARE(other.ask("TM2"), std::string{"TM2\n00P\n\n"});
    QCOMPARE(other.ask("BM"), std::string{"BM\n00P\n\n"});
}

void EmulatedLaserTest::theNewProtocolLeavesTimeModeAtQuit()
{
    LaserRig rig{laserOptions("UST-20LX")};

    QCOMPARE(rig.ask("TM0"), std::string{"TM0\n00P\n\n"});
    QCOMPARE(rig.ask("TM0"), std::string{"TM0\n00P\n\n"});
    QCOMPARE(rig.ask("BM"), std::string{"BM\n10Q\n\n"});
    QCOMPARE(rig.ask("QT"), std::string{"QT\n00P\n\n"});
    QCOMPARE(rig.ask("TM1"), std::string{"TM1\n04T\n\n"});
}

void EmulatedLaserTest::aResetSetsTheClockToZero()
{
    for (const char* const reset : {"RS", "RT"}) {
        LaserRig rig{laserOptions()};
        rig.ask("MD0000108000000");

        QCOMPARE(rig.ask(reset), std::string{reset} + "\n00P\n\n");

        QVERIFY(rig.hear(1s).empty());
        rig.ask("TM0");
        QCOMPARE(rig.ask("TM1"), "TM1\n00P\n" + withPlainSum(plainNumber(1000, 4)) + "\n\n");
    }
}

void EmulatedLaserTest::newModelsStartAnewWhenAskedTwice()
{
    LaserRig rig{laserOptions("UST-20LX")};

    QCOMPARE(rig.ask("RB"), std::string{"RB\n01Q\n\n"});
    rig.now += 2s;
    QCOMPARE(rig.ask("RB"), std::string{"RB\n01Q\n\n"});
    QCOMPARE(rig.ask("RB"), std::string{});
    rig.now += 2s;
    QCOMPARE(rig.ask("VV"), std::string{});
    rig.now += 1s;
    QCOMPARE(rig.ask("BM"), std::string{"BM\n02R\n\n"});
}

void EmulatedLaserTest::scip1IsLeftWhenAskedFor()
{
    LaserRig rig{laserOptions("URG-04LX", {{"laser-scip1", 0}})};

    QCOMPARE(rig.ask("QT"), std::string{"QT\nE\n\n"});
    QCOMPARE(rig.ask("SCIP2.0"), std::string{"SCIP2.0\n0\n\n"});
    QCOMPARE(rig.ask("QT"), std::string{"QT\n00P\n\n"});
}

void EmulatedLaserTest::aScanIsMeasuredAfterTheRequestAndLeavesWhenItIsMeasured()
{
    // Turns begin at 11 ms, 36 ms, ...; the one of 36 ms is the first after the request.
    LaserRig rig{laserOptions()};
    rig.now = 12ms;

    rig.ask("MD0000108000000");
    QVERIFY(rig.hear(36ms + 18'750us).empty());
    const std::string scan = rig.hear(60ms);

    QCOMPARE(scan.size(), std::size_t(3372));
    QVERIFY(rig.lastAt == 36ms + 18'750us + 2'248us);  // 3372 bytes of 1.5 MB/s
    QCOMPARE(scansIn(scan)[0].stamp, 60'000U + 24U);   // 60 s at the first word, at 12 ms
}

void EmulatedLaserTest::scansComeEveryTurnWithStampsOfStep0()
{
    LaserRig rig{laserOptions()};
    rig.ask("MD0000108000000");

    const auto scans = scansIn(rig.hear(1s));

    QCOMPARE(scans.size(), std::size_t(39));  // of those that begin at 11 ms and later, the last at 961 ms
    for (std::size_t i = 0; i < scans.size(); ++i) {
        QCOMPARE(scans[i].echo, std::string{"MD0000108000000"});
        QCOMPARE(scans[i].stamp, static_cast<std::uint32_t>(60'011 + 25 * i));
    }
}

void EmulatedLaserTest::countsRunDownAndTheLaserGoesOff()
{
    LaserRig rig{laserOptions()};
    rig.ask("MD0500058000003;x y");

    const auto scans = scansIn(rig.hear(1s));

    QCOMPARE(scans.size(), std::size_t(3));
    QCOMPARE(scans[0].echo, std::string{"MD0500058000002;x y"});
    QCOMPARE(scans[1].echo, std::string{"MD0500058000001;x y"});
    QCOMPARE(scans[2].echo, std::string{"MD0500058000000;x y"});
    QCOMPARE(rig.ask("BM"), std::string{"BM\n00P\n\n"});
}

void EmulatedLaserTest::theIntervalLeavesTurnsOut()
{
    LaserRig rig{laserOptions()};
    rig.ask("MD0500058000300");

    const auto scans = scansIn(rig.hear(1s));

    QCOMPARE(scans.size(), std::size_t(10));
    QCOMPARE(scans[1].stamp - scans[0].stamp, 100U);
}

void EmulatedLaserTest::quitEndsTheStreamBehindTheScanOnItsWay()
{
    LaserRig rig{laserOptions()};
    rig.ask("MD0000108000000");
    rig.hear(30ms);  // the scan of 11 ms is measured and on its way

    rig.send("QT\n");
    const std::string rest = rig.hear(1s);

    QCOMPARE(scansIn(rest).size(), std::size_t(1));
    QVERIFY(rest.ends_with("\n\nQT\n00P\n\n"));
}

void EmulatedLaserTest::theLatestScanWasMeasuredBefore()
{
    LaserRig rig{laserOptions()};
    rig.now = 54'749us;  // the scan of 36 ms ends at 54.75 ms

    const std::string before = rig.ask("GD0000108000");
    QCOMPARE(scansIn(before).size(), std::size_t(1));
    QVERIFY(before.starts_with("GD0000108000\n00P\n"));
    rig.now = 79'750us;
    const auto after = scansIn(rig.ask("GE0000108000"));

    QCOMPARE(scansIn(before)[0].stamp, 60'000U - 44U);
    QCOMPARE(after[0].stamp, 60'000U + 6U);
    QCOMPARE(after[0].intensities.size(), std::size_t(1081));
    rig.ask("QT");
    QCOMPARE(rig.ask("GD0000108000"), std::string{"GD0000108000\n10Q\n\n"});
}

void EmulatedLaserTest::beamsSeeTheWallAtTheirMoments()
{
    // It nods down from level at 11 ms, when the first beam of the first turn is measured.
    const auto pitch = [](Time at) {
        return 0.5 * std::numbers::pi - 3.0 * std::chrono::duration<double>(at - 11ms).count();
    };
    LaserRig rig{laserOptions(), pitch};
    rig.ask("MD0000108000001");

    const ScipFrame scan = scansIn(rig.hear(1s)).at(0);

    for (const int step : {300, 400, 540, 700, 800}) {
        const double bearing = 0.5 * std::numbers::pi + (step - 540) * std::numbers::pi / 720.0;
        const double seconds = step * 0.025 / 1440.0;
        const double range = 4000.0 / std::sin(bearing) / std::cos(3.0 * seconds);
        QVERIFY2(std::abs(scan.ranges[static_cast<std::size_t>(step)] - range) <= 0.51,
                 qPrintable(QString::number(step)));
    }
    QCOMPARE(scan.ranges[0], 1U);
}

void EmulatedLaserTest::clustersGiveTheNearestRange()
{
    LaserRig rig{laserOptions()};
    rig.ask("MD0540054800001");
    const auto single = scansIn(rig.hear(1s)).at(0).ranges;
    rig.ask("MD0540054804001");
    const auto grouped = scansIn(rig.hear(2s)).at(0).ranges;

    QVERIFY((grouped == std::vector<std::uint32_t>{single[0], single[4], single[8]}));
    QVERIFY(single[1] > single[0] || single[4] > single[0]);
}

void EmulatedLaserTest::intensitiesFallWithRange()
{
    LaserRig rig{laserOptions()};
    rig.ask("ME0000108000001");

    const ScipFrame scan = scansIn(rig.hear(1s)).at(0);

    QVERIFY(scan.intensities[540] > scan.intensities[800]);
    QVERIFY(scan.intensities[540] > 137 && scan.intensities[540] < 16'219);  // as in a real session
    QCOMPARE(scan.intensities[0], 0U);
}

void EmulatedLaserTest::whatDoesNotComeBackHasTheModelsCode_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("request");
    QTest::addColumn<quint32>("code");
    QTest::newRow("UTM") << "UTM-30LX"
                         << "MD0000108000001" << 1U;
    QTest::newRow("UST") << "UST-20LX"
                         << "MD0000108000001" << 65'533U;
    QTest::newRow("URG") << "URG-04LX"
                         << "MD0044072500001" << 0U;
}

void EmulatedLaserTest::whatDoesNotComeBackHasTheModelsCode()
{
    QFETCH(QString, model);
    QFETCH(QString, request);
    QFETCH(quint32, code);
    LaserRig rig{laserOptions(model.toStdString())};
    rig.ask(request.toStdString());

    const ScipFrame scan = scansIn(rig.hear(1s)).at(0);

    QCOMPARE(scan.ranges.front(), code);
    QCOMPARE(scan.ranges[scan.ranges.size() / 2], 4000U);
}

void EmulatedLaserTest::simulatedFaultsComeAndGo()
{
    LaserRig rig{laserOptions()};
    rig.ask("DB02");
    QCOMPARE(rig.ask("BM"), std::string{"BM\n01Q\n\n"});
    QCOMPARE(rig.ask("MD0000108000000"), std::string{"MD0000108000000\n70W\n\n"});
    QVERIFY(rig.ask("II").find("STAT:Trouble!! Error No. =[00->33];") != std::string::npos);
    rig.ask("DB10");
    QCOMPARE(rig.ask("BM"), std::string{"BM\n02R\n\n"});

    rig.ask("MD0000108000000");
    std::string verifying = rig.ask("DB04");
    verifying += rig.hear(rig.now + 2s);
    const auto statuses = only<ScipReply>(decode(verifying));
    QCOMPARE(statuses.size(), std::size_t(3));
    QCOMPARE(statuses[0].echo, std::string{"DB04"});
    QCOMPARE(statuses[1].status, std::string{"21"});
    QCOMPARE(statuses[2].status, std::string{"98"});
    QVERIFY(scansIn(verifying).size() > 35);  // after a second of silence

    std::string breaking = rig.ask("DB03");
    breaking += rig.hear(rig.now + 1s);
    QVERIFY(breaking.ends_with("\n\nMD0000108000000\n70W\n\n"));
    QCOMPARE(rig.ask("BM"), std::string{"BM\n01Q\n\n"});
    QCOMPARE(rig.ask("RS"), std::string{"RS\n00P\n\n"});
    QCOMPARE(rig.ask("BM"), std::string{"BM\n00P\n\n"});
}

void EmulatedLaserTest::aClockThatDriftsRunsFast()
{
    EmulatedLaserOptions options = laserOptions();
    options.uptime = 0ms;
    options.clockDrift = 1.0 / 1024.0;
    LaserRig rig{options};
    rig.ask("TM0");
    rig.now = 100s;

    QCOMPARE(rig.ask("TM1"), "TM1\n00P\n" + withPlainSum(plainNumber(100'097, 4)) + "\n\n");
}

void EmulatedLaserTest::nextOutputIsNeverLate()
{
    // A reader that only comes when it is told to gets every byte at its moment.
    LaserRig rig{laserOptions("UTM-30LX", {{"laser-delay", 5}, {"laser-duplicate", 9}})};
    rig.send("MD0000108000000\n");
    std::size_t bytes = 0;
    while (rig.now < 1s) {
        const auto next = rig.laser->nextOutput();
        QVERIFY(next);
        rig.now = std::max(rig.now, *next);
        for (const EmulatedOutput& output : rig.laser->takeOutput(rig.now)) {
            QVERIFY(output.at == rig.now);
            bytes += output.bytes.size();
        }
    }

    QCOMPARE(bytes, std::size_t(21 + 3372 * 40));  // 39 scans, one of them twice
}

void EmulatedLaserTest::whoeverReadsTooLateHasMissedTheOldest()
{
    LaserRig rig{laserOptions()};
    rig.ask("MD0540054100000");

    const auto scans = scansIn(rig.hear(std::chrono::hours{10}));

    QCOMPARE(scans.size(), std::size_t(400));  // of ten seconds
}

void EmulatedLaserTest::unknownModelsAreRefused()
{
    const auto model = emulatedLaserModel("UTM-40LX");

    QVERIFY(!model);
    QCOMPARE(model.error().code, ErrorCode::Usage);
    QVERIFY(model.error().message.find("UTM-30LX, UST-20LX, URG-04LX") != std::string::npos);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::EmulatedLaserTest)
#include "emulated_laser_test.moc"
