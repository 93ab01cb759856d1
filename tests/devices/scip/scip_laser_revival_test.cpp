// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "devices/emulated/emulated_laser_scan.h"
#include "devices/scip/scip_laser.h"
#include "devices/scip/scip_revival.h"
#include "tests/devices/scip/laser_bench.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;
using Time = std::chrono::nanoseconds;

/// How a laser that fails is got to scan again, that nobody waits for it, and what is left behind where it fails.
class ScipLaserRevivalTest : public QObject {
    Q_OBJECT

private slots:
    void nextKeepsItsDeadlineWhileNothingIsAnswered();
    void aStopIsSeenAtOnceWhileItStartsTheStreamAgain();
    void aStopWhileItStartsLeavesNoStreamBehind_data();
    void aStopWhileItStartsLeavesNoStreamBehind();
    void aStartThatIsRefusedEndsWithQuiet();
    void everyFaultIsLoggedWithItsBytes();
    void newModelsAreStartedAnewInAStreamAndAtTheStart();
    void aNewModelThatAStartAnewCuresScansOn();
};

/// A laser that answers up to a moment, and then nothing any more: not even QT.
void ScipLaserRevivalTest::nextKeepsItsDeadlineWhileNothingIsAnswered()
{
    bool isDeaf = false;
    auto emulated = *EmulatedLaser::make(viewOfWall(), level, laserOptions());
    LaserBench bench{std::make_shared<DeafDevice>(emulated, isDeaf)};
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(10).size(), std::size_t(10));
    isDeaf = true;
    const Time from = bench.clock.now();

    Result<std::optional<LaserScan>> scan;
    do {
        const Time deadline = bench.clock.now() + 20ms;
        scan = bench.laser->next(deadline, {});
        QVERIFY(bench.clock.now() <= deadline);
    } while (scan && !*scan && bench.clock.now() < from + 60s);

    QVERIFY(!scan);
    QCOMPARE(scan.error().code, ErrorCode::DeviceLost);
    // 16 turns of silence, three times QT, QT and the request with 500 ms each, and two pauses of 500 ms.
    const double took = milliseconds(bench.clock.now() - from);
    QVERIFY2(took >= 5850.0 && took <= 6000.0, qPrintable(QString::number(took)));
    QCOMPARE(bench.timesAsked(kStream), std::size_t(4));
    isDeaf = false;
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(5).size(), std::size_t(5));
}

void ScipLaserRevivalTest::aStopIsSeenAtOnceWhileItStartsTheStreamAgain()
{
    bool isDeaf = false;
    auto emulated = *EmulatedLaser::make(viewOfWall(), level, laserOptions());
    LaserBench bench{std::make_shared<DeafDevice>(emulated, isDeaf)};
    QVERIFY(bench.begin());
    isDeaf = true;
    QVERIFY(!*bench.next(1s));  // QT was sent, and is not answered
    QCOMPARE(bench.asked.back(), std::string{"QT"});
    std::stop_source stop;
    stop.request_stop();
    const Time from = bench.clock.now();

    const auto scan = bench.laser->next(from + 1h, stop.get_token());

    QVERIFY(scan && !*scan);
    QVERIFY(bench.clock.now() - from <= 1ms);
    isDeaf = false;
    QVERIFY(*bench.next());  // and it goes on
}

void ScipLaserRevivalTest::aStopWhileItStartsLeavesNoStreamBehind_data()
{
    QTest::addColumn<QString>("at");  // the request whose coming stops it; none: it was stopped before
    QTest::newRow("before it is asked anything") << "";
    QTest::newRow("while the clocks are compared") << "TM2";
    QTest::newRow("while it is switched on") << "BM";
    QTest::newRow("after the stream was asked for") << QString::fromStdString(kStream);
}

void ScipLaserRevivalTest::aStopWhileItStartsLeavesNoStreamBehind()
{
    QFETCH(QString, at);
    std::stop_source stop;
    auto emulated = *EmulatedLaser::make(viewOfWall(), level, laserOptions());
    LaserBench bench{
        std::make_shared<FilteredDevice>(emulated, [&](const std::string& line) -> std::optional<std::string> {
            if (line == at.toStdString())
                stop.request_stop();
            return std::nullopt;
        })};
    QVERIFY(bench.connect());
    bench.asked.clear();
    if (at.isEmpty())
        stop.request_stop();

    const auto started = bench.laser->start(500, 580, stop.get_token());

    QVERIFY(!started);
    QCOMPARE(started.error().code, ErrorCode::Interrupted);
    QCOMPARE(bench.asked.back(), std::string{"QT"});
    QCOMPARE(bench.timesAsked(kStream), std::size_t(at.toStdString() == kStream ? 1 : 0));
    bench.clock.advance(1s);
    bench.device->takeOutput(bench.clock.now());
    QVERIFY(!bench.device->nextOutput());  // it is quiet
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(5).size(), std::size_t(5));
}

void ScipLaserRevivalTest::aStartThatIsRefusedEndsWithQuiet()
{
    LaserBench broken = benchWith({{"laser-malfunction", 1}});
    QVERIFY(broken.begin());
    QVERIFY(!broken.next() || !broken.next());

    const auto started = broken.laser->start(500, 580, {});

    QVERIFY(!started);
    QCOMPARE(started.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(broken.asked.back(), std::string{"QT"});
}

void ScipLaserRevivalTest::everyFaultIsLoggedWithItsBytes()
{
    LaserBench bench = benchWith({{"laser-corrupt", 10}, {"laser-count", 20}, {"laser-silent", 30}});
    QVERIFY(bench.begin());
    QVERIFY(bench.laser->takeLog().empty());

    QCOMPARE(bench.scans(50).size(), std::size_t(50));

    const std::vector<FaultRecord> log = bench.laser->takeLog();
    QCOMPARE(log.size(), std::size_t(3));
    QCOMPARE(log[1].code, std::string{"laser-count"});
    QCOMPARE(log[2].code, std::string{"laser-silent"});
    QVERIFY(log[0].at < log[1].at && log[1].at < log[2].at);
    for (std::size_t i = 0; i < 2; ++i)  // "MD0500058000000" and its line feed
        QVERIFY2(log[i].bytes.starts_with("4D 44 30 35 30 30 30 35 38 30 30 30 30 30 30 0A"), log[i].bytes.c_str());
    const FaultCounts faults = bench.laser->health().faults;
    QCOMPARE(faults.size(), std::size_t(3));
    QCOMPARE(faults.at("laser-silent"), std::uint64_t(1));
    QVERIFY(bench.laser->takeLog().empty());
    QVERIFY(bench.connect());
    QVERIFY(bench.laser->health().faults.empty());
}

void ScipLaserRevivalTest::newModelsAreStartedAnewInAStreamAndAtTheStart()
{
    LaserBench bench = benchWith({{"laser-malfunction", 10}}, "UST-20LX");
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(10).size(), std::size_t(10));
    Time from = bench.clock.now();

    Result<std::optional<LaserScan>> scan;
    do {
        const Time deadline = bench.clock.now() + 50ms;
        scan = bench.laser->next(deadline, {});
        QVERIFY(bench.clock.now() <= deadline);
    } while (scan && !*scan);

    QCOMPARE(scan.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(bench.timesAsked("RS"), std::size_t(1));
    QCOMPARE(bench.timesAsked("RB"), std::size_t(2));
    QVERIFY(bench.clock.now() - from > 3s);  // it was given the time to start
    QVERIFY(bench.clock.now() - from < 30s);

    const auto started = bench.laser->start(500, 580, {});

    QCOMPARE(started.error().code, ErrorCode::NeedsOperator);
    QCOMPARE(bench.timesAsked("RS"), std::size_t(2));
    QCOMPARE(bench.timesAsked("RB"), std::size_t(4));
}

/// A laser whose fault only a start anew ends.
void ScipLaserRevivalTest::aNewModelThatAStartAnewCuresScansOn()
{
    int reboots = 0;
    bool isFaulty = false;
    auto emulated = *EmulatedLaser::make(viewOfWall(), level, laserOptions("UST-20LX"));
    LaserBench bench{
        std::make_shared<FilteredDevice>(emulated, [&](const std::string& line) -> std::optional<std::string> {
            reboots += line == "RB" ? 1 : 0;
            isFaulty = isFaulty && reboots < 2;
            return isFaulty && line == kStream ? std::optional{laserReply(kStream, "70")} : std::nullopt;
        })};
    QVERIFY(bench.begin());
    QCOMPARE(bench.scans(10).size(), std::size_t(10));
    isFaulty = true;
    const std::string simulate = scipSimulatedFault(3) + "\n";
    bench.device->receive({reinterpret_cast<const std::uint8_t*>(simulate.data()), simulate.size()}, bench.clock.now());

    const auto scans = bench.scans(50);

    QCOMPARE(scans.size(), std::size_t(50));
    QCOMPARE(reboots, 2);
    QCOMPARE(bench.timesAsked("RS"), std::size_t(1));
    QVERIFY(bench.laser->health().faults.at("laser-malfunction") == 2);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ScipLaserRevivalTest)
#include "scip_laser_revival_test.moc"
