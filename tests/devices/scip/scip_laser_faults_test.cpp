// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <random>

#include <QtTest>

#include "devices/emulated/emulated_laser_faults.h"
#include "devices/scip/scip_laser.h"
#include "tests/devices/scip/laser_bench.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;
using Time = std::chrono::nanoseconds;

/// What the driver does about each fault of an emulated laser. Scans of 81 beams; faults at the tenth turn or later.
class ScipLaserFaultsTest : public QObject {
    Q_OBJECT

private slots:
    void aLaserThatIsPulledOutIsLost();
    void aLaserThatWasNeverThereIsLost();
    void oneDamagedScanIsLeftOut_data();
    void oneDamagedScanIsLeftOut();
    void fiveDamagedScansStartTheStreamAgain();
    void fourDoNot();
    void manyDamagedScansTellOfTheCable();
    void aStreamOfSomebodyElseIsEnded();
    void timeModeIsLeft();
    void scip1IsLeft();
    void aLaserThatStartsIsWaitedForWithACountdown();
    void aLaserThatStartsAnewInTheMiddleComesBack();
    void aFaultOfTheHardwareInAStreamIsResetOnceAndTold();
    void aFaultThatAResetCuresIsCured();
    void aFaultAtConnectIsResetOnceAndTold();
    void newModelsAreStartedAnewBeforeTheyAreGivenUp();
    void aLaserThatChecksItselfIsGivenTime();
    void silenceStartsTheStreamAgain();
    void silenceThatStaysIsALossAfterThreeAttempts();
    void aTimeThatStandsStillStartsTheStreamAgainAndIsNeverTold();
    void timesGoOnOverTheEndOfTheClock();
    void aClockSetToZeroMarksScansUntilItIsKnownAgain();
    void aCoveredWindowIsToldAndScansAreStillGiven();
    void aScanThatComesTwiceIsGivenOnce();
    void aDelayedScanHasItsTrueTimeAndIsMarked();
    void aProgramThatWasKilledFindsItsLaserAgain();
    void whateverHappensScansAreTrue_data();
    void whateverHappensScansAreTrue();
};

namespace {

/// Turns from one scan to the next.
std::vector<int> turnsBetween(const std::vector<LaserScan>& scans)
{
    std::vector<int> turns;
    for (std::size_t i = 1; i < scans.size(); ++i)
        turns.push_back(static_cast<int>(std::lround(milliseconds(scans[i].first - scans[i - 1].first) / 25.0)));
    return turns;
}

}  // namespace

void ScipLaserFaultsTest::aLaserThatIsPulledOutIsLost()
{
    LaserBench bench = benchWith({{"laser-unplug", 10}});
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(10).size(), std::size_t(10));

    const auto scan = bench.next();

    QVERIFY(!scan);
    QCOMPARE(scan.error().code, ErrorCode::DeviceLost);
    QVERIFY(scan.error().message.starts_with("usb 1-4: "));
    QVERIFY(!bench.connect());
}

void ScipLaserFaultsTest::aLaserThatWasNeverThereIsLost()
{
    LaserBench bench = benchWith({{"laser-unplug", 0}});

    QCOMPARE(bench.connect().error().code, ErrorCode::DeviceLost);
}

void ScipLaserFaultsTest::oneDamagedScanIsLeftOut_data()
{
    QTest::addColumn<QString>("kind");
    for (const char* const kind :
         {"laser-cut", "laser-corrupt", "laser-interleave", "laser-garbage", "laser-byte-loss", "laser-count"})
        QTest::newRow(kind) << QString{kind};
}

void ScipLaserFaultsTest::oneDamagedScanIsLeftOut()
{
    QFETCH(QString, kind);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        EmulatedLaserOptions options = laserOptions("UTM-30LX", {{kind.toStdString(), 10}});
        options.seed = seed;
        LaserBench bench{options};
        QVERIFY(bench.begin());

        const auto scans = bench.scans(50);

        QCOMPARE(scans.size(), std::size_t(50));
        for (const LaserScan& scan : scans) {
            QCOMPARE(scan.ranges.size(), std::size_t(81));
            QCOMPARE(scan.ranges[40], 4000U);
        }
        // What is cut, or bytes that overlap, may take a neighbour along; never more.
        const auto turns = turnsBetween(scans);
        const auto missing = std::accumulate(turns.begin(), turns.end(), 0) - 49;
        QVERIFY(missing == 1 || missing == 2);
        QCOMPARE(std::count(turns.begin(), turns.end(), 1), 48);
        const LinkHealth health = bench.laser->health();
        QVERIFY(health.corrupt >= 1);
        QVERIFY(health.corrupt + health.lost >= static_cast<std::uint64_t>(missing));
        QCOMPARE(bench.timesAsked(kStream), std::size_t(1));  // the stream was left alone
        QCOMPARE(bench.timesAsked("RS"), std::size_t(0));
    }
}

void ScipLaserFaultsTest::fiveDamagedScansStartTheStreamAgain()
{
    std::vector<FaultAt> faults;
    for (int step = 10; step < 15; ++step)
        faults.push_back({"laser-corrupt", step});
    LaserBench bench = benchWith(faults);
    QVERIFY(bench.begin());

    const auto scans = bench.scans(50);

    QCOMPARE(scans.size(), std::size_t(50));
    QCOMPARE(bench.laser->health().corrupt, std::uint64_t(5));
    QCOMPARE(bench.timesAsked(kStream), std::size_t(2));
    QCOMPARE(bench.asked.back(), kStream);
    QCOMPARE(*(bench.asked.end() - 2), std::string{"QT"});
    QVERIFY(turnsBetween(scans)[9] <= 8);
}

void ScipLaserFaultsTest::fourDoNot()
{
    std::vector<FaultAt> faults;
    for (int step = 10; step < 14; ++step)
        faults.push_back({"laser-corrupt", step});
    LaserBench bench = benchWith(faults);
    QVERIFY(bench.begin());

    QCOMPARE(bench.scans(50).size(), std::size_t(50));

    QCOMPARE(bench.laser->health().corrupt, std::uint64_t(4));
    QCOMPARE(bench.timesAsked(kStream), std::size_t(1));
}

void ScipLaserFaultsTest::manyDamagedScansTellOfTheCable()
{
    std::vector<FaultAt> faults;
    for (int step = 10; step < 100; step += 10)
        faults.push_back({"laser-corrupt", step});
    LaserBench bench = benchWith(faults);
    QVERIFY(bench.begin());
    bench.scans(15);
    QCOMPARE(bench.laser->health().trouble, std::string{});

    bench.scans(85);
    QVERIFY(bench.laser->health().trouble.find("cable") != std::string::npos);
    bench.scans(1000);

    QCOMPARE(bench.laser->health().trouble, std::string{});
}

void ScipLaserFaultsTest::aStreamOfSomebodyElseIsEnded()
{
    LaserBench bench = benchWith({{"laser-prestream", 0}});

    QVERIFY(bench.begin());

    const auto scans = bench.scans(50);
    QCOMPARE(scans.size(), std::size_t(50));
    for (const LaserScan& scan : scans)
        QCOMPARE(scan.ranges.size(), std::size_t(81));
    QCOMPARE(bench.laser->health().corrupt, std::uint64_t(0));
}

void ScipLaserFaultsTest::timeModeIsLeft()
{
    for (const char* const model : {"UTM-30LX", "UST-20LX"}) {
        LaserBench bench = benchWith({{"laser-time-mode", 0}}, model);

        QVERIFY(bench.begin());
        QCOMPARE(bench.scans(5).size(), std::size_t(5));
    }
}

void ScipLaserFaultsTest::scip1IsLeft()
{
    LaserBench bench = benchWith({{"laser-scip1", 0}}, "URG-04LX");

    QVERIFY(bench.begin());

    QCOMPARE(bench.timesAsked("SCIP2.0"), std::size_t(1));
    QCOMPARE(bench.scans(5).size(), std::size_t(5));
}

void ScipLaserFaultsTest::aLaserThatStartsIsWaitedForWithACountdown()
{
    LaserBench bench = benchWith({{"laser-boot", 0}});

    QVERIFY(bench.begin());

    QVERIFY(bench.clock.now() >= 3s && bench.clock.now() < 6s);
    QVERIFY(!bench.progress.empty());
    QCOMPARE(bench.progress.front(), std::string{"usb 1-4: waiting for the laser to start, up to 18 s more"});
    QCOMPARE(bench.scans(5).size(), std::size_t(5));
}

void ScipLaserFaultsTest::aLaserThatStartsAnewInTheMiddleComesBack()
{
    LaserBench bench = benchWith({{"laser-boot", 10}});
    QVERIFY(bench.begin());

    const auto scans = bench.scans(50);

    QCOMPARE(scans.size(), std::size_t(50));
    for (std::size_t i = 0; i < scans.size(); ++i)
        QCOMPARE(scans[i].timeSuspect, i >= 10 && i < 9 + ScipClock::kKnown);  // its clock began at zero
    const double gap = milliseconds(scans[10].first - scans[9].first);
    QVERIFY2(gap > 3000.0 && gap < 6000.0, qPrintable(QString::number(gap)));
}

void ScipLaserFaultsTest::aFaultOfTheHardwareInAStreamIsResetOnceAndTold()
{
    LaserBench bench = benchWith({{"laser-malfunction", 10}});
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(10).size(), std::size_t(10));

    const auto scan = bench.next();

    QVERIFY(!scan);
    QCOMPARE(scan.error().code, ErrorCode::NeedsOperator);
    QVERIFY(scan.error().message.find("status 70") != std::string::npos);
    QVERIFY(scan.error().message.find("switch its power off and on") != std::string::npos);
    QCOMPARE(bench.timesAsked("RS"), std::size_t(1));
    QCOMPARE(bench.timesAsked("RB"), std::size_t(0));
    QCOMPARE(bench.asked.back(), std::string{"QT"});
    QVERIFY(!*bench.next(1s));
}

void ScipLaserFaultsTest::aFaultThatAResetCuresIsCured()
{
    LaserBench bench = benchWith({});
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(10).size(), std::size_t(10));
    const std::string simulate = scipSimulatedFault(3) + "\n";
    bench.device->receive({reinterpret_cast<const std::uint8_t*>(simulate.data()), simulate.size()}, bench.clock.now());

    const auto scans = bench.scans(50);

    QCOMPARE(scans.size(), std::size_t(50));
    QCOMPARE(bench.timesAsked("RS"), std::size_t(1));
    QCOMPARE(std::count_if(scans.begin(), scans.end(), [](const LaserScan& scan) { return scan.timeSuspect; }),
             ScipClock::kKnown - 1);
}

void ScipLaserFaultsTest::aFaultAtConnectIsResetOnceAndTold()
{
    LaserBench bench = benchWith({{"laser-malfunction", 0}});

    const auto connected = bench.connect();

    QVERIFY(!connected);
    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    QVERIFY(connected.error().message.find("Trouble!! Error No. =[00->33]") != std::string::npos);
    QVERIFY(connected.error().message.find("switch its power off and on") != std::string::npos);
    QCOMPARE(bench.timesAsked("RS"), std::size_t(1));
    QCOMPARE(bench.timesAsked("RB"), std::size_t(0));
}

void ScipLaserFaultsTest::newModelsAreStartedAnewBeforeTheyAreGivenUp()
{
    LaserBench bench = benchWith({{"laser-malfunction", 0}}, "UST-20LX");

    const auto connected = bench.connect();

    QVERIFY(!connected);
    QCOMPARE(connected.error().code, ErrorCode::NoDevice);
    QCOMPARE(bench.timesAsked("RS"), std::size_t(1));
    QCOMPARE(bench.timesAsked("RB"), std::size_t(2));
    QVERIFY(bench.clock.now() > 3s);  // it was given the time to start
}

void ScipLaserFaultsTest::aLaserThatChecksItselfIsGivenTime()
{
    LaserBench bench = benchWith({});
    QVERIFY(bench.begin());
    bench.scans(10);
    const std::string simulate = scipSimulatedFault(4) + "\n";
    bench.device->receive({reinterpret_cast<const std::uint8_t*>(simulate.data()), simulate.size()}, bench.clock.now());
    QVERIFY(!*bench.next(100ms));
    QVERIFY(bench.laser->health().trouble.find("checks an error") != std::string::npos);

    const auto scans = bench.scans(10);

    QCOMPARE(scans.size(), std::size_t(10));
    QCOMPARE(bench.timesAsked(kStream), std::size_t(1));
    QCOMPARE(bench.laser->health().lost, std::uint64_t(41));  // the one that told, and a second's
    QCOMPARE(bench.laser->health().trouble, std::string{});
}

void ScipLaserFaultsTest::silenceStartsTheStreamAgain()
{
    LaserBench bench = benchWith({{"laser-silent", 10}});
    QVERIFY(bench.begin());

    const auto scans = bench.scans(50);

    QCOMPARE(scans.size(), std::size_t(50));
    QCOMPARE(bench.timesAsked(kStream), std::size_t(2));
    QCOMPARE(*(bench.asked.end() - 2), std::string{"QT"});
    // 16 turns without a scan, and one or two to begin again.
    const int gap = turnsBetween(scans)[9];
    QVERIFY2(gap >= 17 && gap <= 19, qPrintable(QString::number(gap)));
    QCOMPARE(bench.laser->health().lost, static_cast<std::uint64_t>(gap - 1));
    for (const LaserScan& scan : scans)
        QVERIFY(!scan.timeSuspect);
}

void ScipLaserFaultsTest::silenceThatStaysIsALossAfterThreeAttempts()
{
    LaserBench bench = benchWith(std::vector<FaultAt>(10, {"laser-silent", 10}));
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(10).size(), std::size_t(10));
    const Time from = bench.clock.now();

    const auto scan = bench.next();

    QVERIFY(!scan);
    QCOMPARE(scan.error().code, ErrorCode::DeviceLost);
    QVERIFY(scan.error().message.find("sends no scans any more") != std::string::npos);
    QCOMPARE(bench.timesAsked(kStream), std::size_t(4));
    const double took = milliseconds(bench.clock.now() - from);
    // Four silences of 400 ms, and half a second before the second and the third attempt.
    QVERIFY2(took > 2500.0 && took < 3000.0, qPrintable(QString::number(took)));
    QVERIFY(bench.begin());
}

void ScipLaserFaultsTest::aTimeThatStandsStillStartsTheStreamAgainAndIsNeverTold()
{
    LaserBench bench = benchWith({{"laser-stuck-time", 10}});
    QVERIFY(bench.begin());

    const auto scans = bench.scans(50);

    QCOMPARE(scans.size(), std::size_t(50));
    QCOMPARE(bench.timesAsked(kStream), std::size_t(2));
    const auto turns = turnsBetween(scans);
    QCOMPARE(turns[9], 1);  // the first of its time is true
    QVERIFY(turns[10] >= 3 && turns[10] <= 5);
    QCOMPARE(std::count(turns.begin(), turns.end(), 1), 48);
}

void ScipLaserFaultsTest::timesGoOnOverTheEndOfTheClock()
{
    LaserBench bench = benchWith({{"laser-wrap", 40}});
    QVERIFY(bench.begin());
    QVERIFY(bench.clock.now() < 3s);

    const auto scans = bench.scans(200);

    QVERIFY(bench.clock.now() > 5s);
    QCOMPARE(scans.size(), std::size_t(200));
    for (const int turns : turnsBetween(scans))
        QCOMPARE(turns, 1);
    for (const LaserScan& scan : scans)
        QVERIFY(!scan.timeSuspect);
}

void ScipLaserFaultsTest::aClockSetToZeroMarksScansUntilItIsKnownAgain()
{
    LaserBench bench = benchWith({{"laser-reset", 60}});
    QVERIFY(bench.begin());

    const auto scans = bench.scans(100);

    for (std::size_t i = 0; i < scans.size(); ++i)
        QCOMPARE(scans[i].timeSuspect, i >= 60 && i < 59 + ScipClock::kKnown);
    for (const int turns : turnsBetween(scans))
        QCOMPARE(turns, 1);
    QVERIFY(std::abs(milliseconds(scans[99].first - scans[59].first) - 1000.0) <= 1.0);
    QCOMPARE(bench.timesAsked(kStream), std::size_t(1));
}

void ScipLaserFaultsTest::aCoveredWindowIsToldAndScansAreStillGiven()
{
    LaserBench bench = benchWith({{"laser-blind", 10}});
    QVERIFY(bench.begin());
    bench.scans(10);
    QCOMPARE(bench.laser->health().trouble, std::string{});

    const auto scans = bench.scans(10);

    QCOMPARE(scans.size(), std::size_t(10));
    QVERIFY(scans[0].ranges == std::vector<std::uint32_t>(81, 0));
    QVERIFY(scans[0].codes == std::vector<std::uint32_t>(81, 4));  // "out of range at the near end"
    QVERIFY(bench.laser->health().trouble.find("window") != std::string::npos);
    const std::vector<FaultRecord> log = bench.laser->takeLog();
    QCOMPARE(log.size(), std::size_t(1));  // once, and not with every scan
    QCOMPARE(log[0].code, std::string{"laser-blind"});
    QCOMPARE(log[0].text, std::string{"almost no beam comes back: 81 times 4"});
    QVERIFY(log[0].bytes.starts_with("30 30 34 30 30 34"));  // "004004"
}

void ScipLaserFaultsTest::aScanThatComesTwiceIsGivenOnce()
{
    LaserBench bench = benchWith({{"laser-duplicate", 10}});
    QVERIFY(bench.begin());

    const auto scans = bench.scans(50);

    for (const int turns : turnsBetween(scans))
        QCOMPARE(turns, 1);
    QCOMPARE(bench.laser->health().corrupt, std::uint64_t(1));
    QCOMPARE(bench.laser->health().lost, std::uint64_t(0));
}

void ScipLaserFaultsTest::aDelayedScanHasItsTrueTimeAndIsMarked()
{
    LaserBench bench = benchWith({{"laser-delay", 60}});
    QVERIFY(bench.begin());

    const auto scans = bench.scans(100);

    for (const int turns : turnsBetween(scans))
        QCOMPARE(turns, 1);
    QVERIFY(milliseconds(scans[60].arrived - scans[60].last) > 199.0);
    // 200 ms are 8 turns: the last of those behind it comes 25 ms late, and what waits on the line comes on top.
    for (std::size_t i = 0; i < scans.size(); ++i)
        QCOMPARE(scans[i].timeSuspect, i >= 60 && i <= 67);
    QCOMPARE(bench.laser->health().late, std::uint64_t(8));
    QCOMPARE(bench.laser->health().corrupt, std::uint64_t(0));
}

void ScipLaserFaultsTest::aProgramThatWasKilledFindsItsLaserAgain()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.begin());
    bench.scans(7);
    auto killed = std::move(bench.laser);  // it says no farewell until the end of the test

    bench.plugIn();
    bench.clock.advance(10ms);
    QVERIFY(bench.begin());

    QCOMPARE(bench.scans(20).size(), std::size_t(20));
}

void ScipLaserFaultsTest::whateverHappensScansAreTrue_data()
{
    QTest::addColumn<quint64>("seed");
    const quint64 seeds = qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG") ? 1000 : 30;
    for (quint64 seed = 1; seed <= seeds; ++seed)
        QTest::addRow("seed %d", static_cast<int>(seed)) << seed;
}

/// The laser nods, so that every moment has a range of its own: a scan with the data of one and the time of another
/// cannot pass.
void ScipLaserFaultsTest::whateverHappensScansAreTrue()
{
    QFETCH(quint64, seed);
    std::mt19937_64 random(seed);
    EmulatedLaserOptions options = laserOptions();
    options.seed = seed;
    // Nobody can tell a clock that is set to zero from one that passes its end at the same moment.
    const std::vector<std::string> leftOut{"laser-unplug",
                                           "laser-malfunction",
                                           "laser-blind",
                                           "laser-scip1",
                                           seed % 2 == 0 ? "laser-wrap" : "laser-reset",
                                           seed % 2 == 0 ? "laser-wrap" : "laser-boot"};
    for (int i = 0; i < 12; ++i) {
        const auto kinds = laserFaultKinds();
        std::string kind;
        do
            kind = kinds[random() % kinds.size()].name;
        while (std::find(leftOut.begin(), leftOut.end(), kind) != leftOut.end());
        options.faults.push_back({kind, 1 + static_cast<int>(random() % 200)});
    }
    const auto nods = [](Time at) { return 0.5 * std::numbers::pi - 0.02 * std::chrono::duration<double>(at).count(); };
    LaserBench bench{options, nods};
    QVERIFY(bench.begin());

    std::vector<LaserScan> scans;
    for (int losses = 0; scans.size() < 250;) {
        auto scan = bench.next();
        if (scan) {
            QVERIFY(*scan);
            scans.push_back(**scan);
            continue;
        }
        // Faults that follow one another closely may be too much for its attempts; it says so, and can be connected.
        QCOMPARE(scan.error().code, ErrorCode::DeviceLost);
        QVERIFY(++losses <= 12);
        QVERIFY(bench.begin());
    }

    Time last{0};
    for (const LaserScan& scan : scans) {
        QCOMPARE(scan.ranges.size(), std::size_t(81));
        if (scan.timeSuspect)
            continue;
        QVERIFY(scan.first > last);
        last = scan.last;
        const double middle = 0.5e-3 * (milliseconds(scan.first) + milliseconds(scan.last));
        const double range = 4000.0 / std::cos(0.02 * middle);
        // Half a millimetre of rounding; three milliseconds of time are worth less than the rest.
        const double bound = 0.5 + 4000.0 * 0.02 * 0.003 * std::tan(0.02 * middle) / std::cos(0.02 * middle) + 0.01;
        QVERIFY2(std::abs(scan.ranges[40] - range) <= bound,
                 qPrintable(QString{"%1 mm, not %2"}.arg(scan.ranges[40]).arg(range)));
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipLaserFaultsTest)
#include "scip_laser_faults_test.moc"
