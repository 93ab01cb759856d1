// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_laser.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include <QtTest>

#include "core/types/angle.h"
#include "tests/devices/scip/laser_bench.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;
using Time = std::chrono::nanoseconds;

class ScipLaserTest : public QObject {
    Q_OBJECT

private slots:
    void knowsWhoItIs();
    void givesEveryTurnOnceWithItsRanges();
    void timesAreThoseOfTheMirror_data();
    void timesAreThoseOfTheMirror();
    void aClockThatDriftsIsFollowed();
    void theSafeSequenceIsAsked();
    void stepsThatItHasNotAreRefused();
    void aDeadlineComesBeforeTheScanAndLosesNothing();
    void whatWaitsIsGivenWithoutWaiting();
    void noScanIsLostWhereNobodyAsksForAWhile();
    void joinedStepsGiveTheLeastRangeOfEachCluster();
    void clustersThatNoLaserHasAreRefused();
    void stopsAndStartsAgain();
    void aStartWhileItScansStartsAnew();
    void endsScanningWhenItGoes();
    void withoutAStartThereIsNothing();
    void aStopEndsEveryWait();
    void healthTellsTheRate();
    void healthMayBeReadByAnotherThread();
    void otherModelsScanToo_data();
    void otherModelsScanToo();
};

namespace {

/// How far a moment is from the nearest beam of a step: turns begin at 11 ms.
double offMirror(Time moment, int step, const LaserLimits& limits)
{
    const double period = std::chrono::duration<double, std::milli>(limits.period).count();
    const double since =
        std::chrono::duration<double, std::milli>(moment).count() - 11.0 - period * step / limits.stepsPerTurn;
    return since - period * std::round(since / period);
}

}  // namespace

void ScipLaserTest::knowsWhoItIs()
{
    EmulatedLaserOptions options = laserOptions();
    options.serial = "00903971";
    LaserBench bench{options};

    QVERIFY(bench.connect());

    const LaserIdentity& identity = bench.laser->identity();
    QCOMPARE(identity.vendor, std::string{"Hokuyo Automatic Co.,Ltd."});
    QCOMPARE(identity.product, std::string{"SOKUIKI Sensor TOP-URG UTM-30LX"});
    QCOMPARE(identity.firmware, std::string{"P.1.05(17/Apr./2009)"});
    QCOMPARE(identity.protocol, std::string{"SCIP 2.0"});
    QCOMPARE(identity.serial, std::string{"00903971"});
    QCOMPARE(identity.model, std::string{"UTM-30LX(Hokuyo Automatic Co.,Ltd.)"});
    QCOMPARE(bench.laser->limits().lastStep, 1080);
    QVERIFY(bench.laser->limits().period == 25ms);
    QVERIFY(!bench.laser->capabilities().reboot);
    QCOMPARE(bench.laser->health().trouble, std::string{});
    QVERIFY(bench.progress.empty());
}

void ScipLaserTest::givesEveryTurnOnceWithItsRanges()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.connect());
    QVERIFY(bench.laser->start(0, 1080, {}));

    const auto scans = bench.scans(100);

    QCOMPARE(scans.size(), std::size_t(100));
    for (std::size_t i = 0; i < scans.size(); ++i) {
        QCOMPARE(scans[i].ranges.size(), std::size_t(1081));
        QCOMPARE(scans[i].ranges[540], 4000U);
        QCOMPARE(scans[i].ranges[300], 8000U);  // 60 degrees off: twice as far
        QCOMPARE(scans[i].ranges[780], 8000U);
        QCOMPARE(scans[i].ranges[0], 0U);
        QVERIFY(!scans[i].timeSuspect);
        QVERIFY(scans[i].last - scans[i].first == 18'750us);
        QVERIFY(scans[i].arrived >= scans[i].last);
        if (i > 0 && i != ScipClock::kSettled - 1)  // from then on by arrivals
            QVERIFY(scans[i].first - scans[i - 1].first == 25ms);
    }
    QCOMPARE(bench.laser->health().good, std::uint64_t(100));
    QCOMPARE(bench.laser->health().lost, std::uint64_t(0));
    QCOMPARE(bench.laser->health().corrupt, std::uint64_t(0));
    QCOMPARE(bench.laser->health().late, std::uint64_t(0));
}

void ScipLaserTest::timesAreThoseOfTheMirror_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("last");
    QTest::newRow("all") << 0 << 1080;
    QTest::newRow("half a turn") << 180 << 900;
    QTest::newRow("the front") << 500 << 580;
}

void ScipLaserTest::timesAreThoseOfTheMirror()
{
    QFETCH(int, first);
    QFETCH(int, last);
    LaserBench bench{laserOptions()};
    QVERIFY(bench.connect());
    QVERIFY(bench.laser->start(first, last, {}));

    for (const LaserScan& scan : bench.scans(100)) {
        QVERIFY(std::abs(offMirror(scan.first, first, bench.laser->limits())) <= 1.0);
        QVERIFY(std::abs(offMirror(scan.last, last, bench.laser->limits())) <= 1.0);
    }
}

void ScipLaserTest::aClockThatDriftsIsFollowed()
{
    EmulatedLaserOptions options = laserOptions();
    options.clockDrift = 50e-6;
    LaserBench bench{options};
    QVERIFY(bench.begin());

    double worst = 0.0;
    for (const LaserScan& scan : bench.scans(20'000))
        worst = std::max(worst, std::abs(offMirror(scan.first, 500, bench.laser->limits())));

    // 25 ms after 500 s: a clock that is not followed would be a whole turn off.
    QVERIFY2(worst <= 1.6, qPrintable(QString::number(worst)));
    QCOMPARE(bench.laser->health().good, std::uint64_t(20'000));
}

void ScipLaserTest::theSafeSequenceIsAsked()
{
    LaserBench bench{laserOptions()};

    QVERIFY(bench.begin());
    QVERIFY(bench.next());
    QVERIFY(bench.laser->stop());

    QCOMPARE(bench.asked.front(), std::string{});  // ends what another has begun
    const std::vector<std::string> expected{"QT", "QT", "VV", "PP", "II", "TM0"};
    QVERIFY((std::vector(bench.asked.begin() + 1, bench.asked.begin() + 7) == expected));
    const std::vector<std::string> end{"TM2", "BM", "MD0500058000000", "QT"};
    QVERIFY((std::vector(bench.asked.end() - 4, bench.asked.end()) == end));
    QCOMPARE(bench.asked.size(), std::size_t(1 + 6 + 8 + 4));
}

void ScipLaserTest::stepsThatItHasNotAreRefused()
{
    LaserBench bench{laserOptions("URG-04LX")};
    QVERIFY(bench.connect());
    for (const auto& [first, last] : {std::pair{0, 700}, {43, 700}, {44, 726}, {700, 100}, {100, 100}, {-1, 100}}) {
        const auto started = bench.laser->start(first, last, {});

        QVERIFY(!started);
        QCOMPARE(started.error().code, ErrorCode::Usage);
        QVERIFY(started.error().message.starts_with("usb 1-4: "));
    }
}

void ScipLaserTest::aDeadlineComesBeforeTheScanAndLosesNothing()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.begin());
    int empty = 0;
    std::vector<LaserScan> scans;
    while (scans.size() < 50) {
        const auto scan = bench.next(3ms);
        QVERIFY(scan);
        if (*scan)
            scans.push_back(**scan);
        else
            ++empty;
    }

    QVERIFY(empty > 300);
    for (std::size_t i = 1; i < scans.size(); ++i)
        QVERIFY(scans[i].first - scans[i - 1].first < 27ms);
    QCOMPARE(bench.laser->health().lost, std::uint64_t(0));
}

void ScipLaserTest::whatWaitsIsGivenWithoutWaiting()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.begin());
    bench.clock.advance(80ms);
    const Time now = bench.clock.now();

    QVERIFY(*bench.laser->next(now - 1s, {}));
    QVERIFY(*bench.laser->next(now - 1s, {}));

    QVERIFY(bench.clock.now() == now);
}

void ScipLaserTest::noScanIsLostWhereNobodyAsksForAWhile()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.begin());
    auto scans = bench.scans(10);
    bench.clock.advance(5s);

    const auto more = bench.scans(300);
    scans.insert(scans.end(), more.begin(), more.end());

    QCOMPARE(scans.size(), std::size_t(310));
    QCOMPARE(bench.laser->health().good, std::uint64_t(310));
    QCOMPARE(bench.laser->health().lost, std::uint64_t(0));
    QCOMPARE(bench.laser->health().late, std::uint64_t(0));
    QCOMPARE(bench.timesAsked("MD0500058000000"), std::size_t(1));
    QCOMPARE(std::chrono::round<std::chrono::milliseconds>(scans.back().first - scans.front().first).count(), 309 * 25);
}

void ScipLaserTest::joinedStepsGiveTheLeastRangeOfEachCluster()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.connect());
    const LaserBeams beams{500, 580, 4};
    QVERIFY(bench.laser->start(beams, {}));

    const auto scans = bench.scans(20);

    QCOMPARE(bench.timesAsked("MD0500058004000"), std::size_t(1));
    QCOMPARE(scans.size(), std::size_t(20));
    QCOMPARE(scans[0].ranges.size(), std::size_t(21));  // 20 of four steps, and the last step alone
    QCOMPARE(beams.count(), 21);
    for (int cluster = 0; cluster < 21; ++cluster) {
        // The wall is 4 m away: the step nearest to the front, 540, has the least range.
        const int first = 500 + 4 * cluster;
        const int nearest = std::clamp(540, first, std::min(first + 3, 580));
        const double range = 4000.0 / std::cos((nearest - 540) * degrees(0.25));
        QVERIFY(std::abs(scans[0].ranges[static_cast<std::size_t>(cluster)] - range) <= 0.51);
    }
    // A range is that of the middle of its cluster: step 501.5 to step 581.5.
    QVERIFY(std::abs(offMirror(scans[5].first, 501, bench.laser->limits()) - 0.5 * 25.0 / 1440.0) <= 1.0);
    QVERIFY(std::chrono::abs(scans[5].last - scans[5].first - 80 * Time{25ms} / 1440) <= 1us);
    QVERIFY(std::abs(beams.firstBearing(bench.laser->limits()) - degrees(90.0 - 38.5 * 0.25)) < 1e-12);
    QVERIFY(std::abs(beams.bearingStep(bench.laser->limits()) - degrees(1.0)) < 1e-12);
}

void ScipLaserTest::clustersThatNoLaserHasAreRefused()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.connect());
    for (const int cluster : {0, -1, 100}) {
        const auto started = bench.laser->start(LaserBeams{500, 580, cluster}, {});

        QVERIFY(!started);
        QCOMPARE(started.error().code, ErrorCode::Usage);
        QVERIFY(started.error().message.find("1 to 99") != std::string::npos);
    }
    QVERIFY(bench.laser->start(LaserBeams{500, 580, 99}, {}));
    QCOMPARE(bench.scans(1).at(0).ranges, (std::vector<std::uint32_t>{4000}));
}

void ScipLaserTest::stopsAndStartsAgain()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(5).size(), std::size_t(5));

    QVERIFY(bench.laser->stop());
    QVERIFY(bench.laser->stop());  // nothing to end
    QVERIFY(!*bench.next(1s));
    bench.clock.advance(std::chrono::hours{30});
    QVERIFY(bench.laser->start(400, 600, {}));

    const auto scans = bench.scans(5);
    QCOMPARE(scans.size(), std::size_t(5));
    QCOMPARE(scans[0].ranges.size(), std::size_t(201));
    QVERIFY(!scans[0].timeSuspect);
    QVERIFY(std::abs(offMirror(scans[0].first, 400, bench.laser->limits())) <= 1.0);
}

void ScipLaserTest::aStartWhileItScansStartsAnew()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.begin());
    bench.scans(5);

    QVERIFY(bench.laser->start(540, 541, {}));

    const auto scans = bench.scans(5);
    QCOMPARE(scans.size(), std::size_t(5));
    QVERIFY((scans[0].ranges == std::vector<std::uint32_t>{4000, 4000}));
}

void ScipLaserTest::endsScanningWhenItGoes()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.begin());
    bench.scans(5);

    bench.laser.reset();

    QCOMPARE(bench.asked.back(), std::string{"QT"});
    bench.device->takeOutput(bench.clock.now());
    QVERIFY(!bench.device->nextOutput());
}

void ScipLaserTest::withoutAStartThereIsNothing()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.connect());

    const auto scan = bench.next(10s);

    QVERIFY(scan);
    QVERIFY(!*scan);
}

void ScipLaserTest::aStopEndsEveryWait()
{
    std::stop_source stop;
    stop.request_stop();
    LaserBench bench{laserOptions()};

    const auto connected = bench.laser->connect(stop.get_token());
    QVERIFY(!connected);
    QCOMPARE(connected.error().code, ErrorCode::Interrupted);
    QVERIFY(bench.connect());
    const auto started = bench.laser->start(0, 1080, stop.get_token());
    QVERIFY(!started);
    QCOMPARE(started.error().code, ErrorCode::Interrupted);
    QVERIFY(bench.begin());
    const auto scan = bench.laser->next(bench.clock.now() + 1h, stop.get_token());

    QVERIFY(scan);
    QVERIFY(!*scan);
    QVERIFY(bench.clock.now() < 1h);
}

void ScipLaserTest::healthTellsTheRate()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.begin());
    bench.scans(60);
    QCOMPARE(bench.laser->health().rate, 40.0);
    QVERIFY(bench.laser->stop());

    bench.clock.advance(2s);

    QCOMPARE(bench.laser->health().rate, 0.0);
    QCOMPARE(bench.laser->health().good, std::uint64_t(60));
    QVERIFY(bench.connect());
    QCOMPARE(bench.laser->health().good, std::uint64_t(0));
}

void ScipLaserTest::healthMayBeReadByAnotherThread()
{
    LaserBench bench{laserOptions()};
    QVERIFY(bench.begin());
    std::atomic<bool> isOver{false};
    std::uint64_t seen = 0;
    std::jthread watching{[&] {
        while (!isOver)
            seen = std::max(seen, bench.laser->health().good);
    }};

    bench.scans(500);
    isOver = true;
    watching.join();

    QVERIFY(seen <= 500);
    QCOMPARE(bench.laser->health().good, std::uint64_t(500));
}

void ScipLaserTest::otherModelsScanToo_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("front");
    QTest::addColumn<int>("period");
    QTest::addColumn<QString>("protocol");
    QTest::newRow("UST") << "UST-20LX" << 540 << 25 << "SCIP 2.2";
    QTest::newRow("URG") << "URG-04LX" << 384 << 100 << "SCIP 2.0";
}

void ScipLaserTest::otherModelsScanToo()
{
    QFETCH(QString, model);
    QFETCH(int, front);
    QFETCH(int, period);
    QFETCH(QString, protocol);
    LaserBench bench{laserOptions(model.toStdString())};
    QVERIFY(bench.connect());
    QCOMPARE(bench.laser->identity().protocol, protocol.toStdString());
    const LaserLimits limits = bench.laser->limits();
    QVERIFY(bench.laser->start(limits.firstStep, limits.lastStep, {}));

    const auto scans = bench.scans(60);

    QCOMPARE(scans.size(), std::size_t(60));
    for (std::size_t i = 0; i < scans.size(); ++i) {
        QCOMPARE(scans[i].ranges[static_cast<std::size_t>(front - limits.firstStep)], 4000U);
        QCOMPARE(scans[i].ranges[0], 0U);
        QVERIFY(std::abs(offMirror(scans[i].first, limits.firstStep, limits)) <= 1.0);
        if (i > 0 && i != ScipClock::kSettled - 1)
            QVERIFY(scans[i].first - scans[i - 1].first == std::chrono::milliseconds{period});
    }
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipLaserTest)
#include "scip_laser_test.moc"
