// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/nodding/device_pair.h"

#include <QtTest>

#include "tests/devices/nodding/scripted_devices.h"
#include "tests/test_program.h"

using namespace std::chrono_literals;

namespace planewright {

class DevicePairTest : public QObject {
    Q_OBJECT

private slots:
    void theSameLaserIsWaitedFor();
    void aLaserWithoutANumberIsNotTakenForAnother();
    void scansThatNobodyTakesAreBounded();
    void aLaserThatFailedLeavesTheUnitOpen();
    void recordsOfADeviceThatWasClosedAreKept();
    void whatGoesWrongBesideTheDevicesIsTold();
};

void DevicePairTest::theSameLaserIsWaitedFor()
{
    DeviceScript script;
    DevicePair pair(scriptedDevices(script), script.clock);
    QVERIFY(pair.open({}));
    pair.close();

    script.laser.serial = "00000002";
    const auto other = pair.open({});
    const bool isOpenWithOther = pair.isOpen();
    script.laser.serial = "00000001";
    const auto same = pair.open({});

    QVERIFY(!other && !isOpenWithOther);
    QCOMPARE(other.error().code, ErrorCode::NeedsOperator);
    QVERIFY(QString::fromStdString(other.error().message).contains("00000002"));
    QVERIFY(same.has_value());
    QVERIFY(pair.isOpen());
}

void DevicePairTest::aLaserWithoutANumberIsNotTakenForAnother()
{
    DeviceScript script;
    script.laser.serial.clear();
    DevicePair pair(scriptedDevices(script), script.clock);
    QVERIFY(pair.open({}));
    pair.close();

    script.laser.serial = "00000002";
    const auto other = pair.open({});

    QVERIFY(!other);
    QCOMPARE(other.error().code, ErrorCode::NeedsOperator);
}

/// A unit that tells no angle for a minute, beside a laser that goes on.
void DevicePairTest::scansThatNobodyTakesAreBounded()
{
    DeviceScript script;
    script.hasSamples = false;
    DevicePair pair(scriptedDevices(script), script.clock);
    QVERIFY(pair.open({}));
    QVERIFY(pair.startLaser({180, 900}, {}));
    while (script.clock.now() < 60s)
        QVERIFY(pair.hear({}));

    script.hasSamples = true;
    QVERIFY(pair.hear({}));
    std::vector<LaserScan> scans;
    while (auto scan = pair.takeScan())
        scans.push_back(std::move(*scan));

    QVERIFY(!scans.empty());
    QVERIFY(scans.size() <= 200);
    QVERIFY(scans.back().first > script.clock.now() - 100ms);  // the latest are kept
}

void DevicePairTest::aLaserThatFailedLeavesTheUnitOpen()
{
    DeviceScript script;
    DevicePair pair(scriptedDevices(script), script.clock);
    QVERIFY(pair.open({}));
    QVERIFY(pair.startLaser({180, 900}, {}));
    script.onLaser = [] { return Result<void>{fail(ErrorCode::DeviceLost, "the cable is pulled out")}; };

    QVERIFY(!pair.hear({}));
    pair.close();

    QCOMPARE(script.count("laser closed"), 1);
    QCOMPARE(script.count("unit closed"), 0);
}

void DevicePairTest::recordsOfADeviceThatWasClosedAreKept()
{
    DeviceScript script;
    DevicePair pair(scriptedDevices(script), script.clock);
    QVERIFY(pair.open({}));
    script.laserLog = {{2s, "laser-sum", "a line with a wrong sum", "4D"}, {1s, "laser-late", "a scan came late", ""}};
    pair.close();
    script.laserLog = {{3s, "laser-silent", "nothing came", ""}};
    QVERIFY(pair.open({}));

    const std::vector<FaultRecord> records = pair.takeLog();

    QCOMPARE(records.size(), std::size_t(3));  // oldest first
    QCOMPARE(records[0].code, std::string{"laser-late"});
    QCOMPARE(records[1].code, std::string{"laser-sum"});
    QCOMPARE(records[2].code, std::string{"laser-silent"});
    QVERIFY(pair.takeLog().empty());

    for (int i = 0; i < 100; ++i)
        script.laserLog.push_back({std::chrono::seconds{i}, "laser-sum", std::to_string(i), ""});
    const std::vector<FaultRecord> latest = pair.takeLog();
    QCOMPARE(latest.size(), 2 * FaultLog::kMostRecords);
    QCOMPARE(latest.back().text, std::string{"99"});
}

void DevicePairTest::whatGoesWrongBesideTheDevicesIsTold()
{
    DeviceScript script;
    script.laserLog = {{2s, "laser-sum", "a line with a wrong sum", ""}};
    NoddingDevices devices = scriptedDevices(script);
    devices.takeLog = [] { return std::vector<FaultRecord>{{1s, "dialogue-ended", "the disk is full", ""}}; };
    DevicePair pair(std::move(devices), script.clock);
    QVERIFY(pair.open({}));

    const std::vector<FaultRecord> log = pair.takeLog();

    QCOMPARE(log.size(), std::size_t(2));
    QCOMPARE(log[0].code, std::string("dialogue-ended"));
    QCOMPARE(log[1].code, std::string("laser-sum"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DevicePairTest)
#include "device_pair_test.moc"
