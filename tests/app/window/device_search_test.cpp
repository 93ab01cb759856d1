// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/device_search.h"

#include <atomic>

#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

/// What is plugged in and pulled out, however often, is found; no change is passed over.
class DeviceSearchTest : public QObject {
    Q_OBJECT

private slots:
    void aStormOfChangesIsSearchedForMeanwhileAndAtItsEnd();
    void aChangeDuringASearchIsSearchedForAfterwards();
    void whatIsAskedForWhileItIsHeldComesAfterwards();
    void lasersThatWereAskedStayKnown();
};

namespace {

constexpr int kSearchPatience = 20'000;  // [ms]

/// Finds nothing, and counts; waits inside a search until it is let through.
struct CountedSearch {
    std::atomic<int> begun{0};
    std::atomic<int> asking{0};
    std::atomic<bool> waits{false};

    DeviceSearch::Find find()
    {
        return [this](bool asks, const KnownLasers& /*known*/, const std::stop_token& stop) {
            ++begun;
            asking += asks ? 1 : 0;
            while (waits && !stop.stop_requested())
                std::this_thread::sleep_for(std::chrono::milliseconds{1});
            return FoundDevices{};
        };
    }
};

}  // namespace

void DeviceSearchTest::aStormOfChangesIsSearchedForMeanwhileAndAtItsEnd()
{
    CountedSearch counted;
    DeviceSearch search(counted.find());
    QSignalSpy found(&search, &DeviceSearch::found);

    // Changes every 50 ms never leave the half second of peace that a search would wait for.
    QElapsedTimer storm;
    storm.start();
    while (storm.elapsed() < 3000 && found.isEmpty()) {
        search.noteChange();
        QTest::qWait(50);
    }
    QVERIFY(!found.isEmpty());
    const auto before = found.count();
    search.noteChange();

    QTRY_VERIFY_WITH_TIMEOUT(found.count() > before, kSearchPatience);
    QVERIFY(counted.begun <= 1 + storm.elapsed() / 500 + 1);
    QCOMPARE(counted.asking.load(), 0);
}

void DeviceSearchTest::aChangeDuringASearchIsSearchedForAfterwards()
{
    CountedSearch counted;
    counted.waits = true;
    DeviceSearch search(counted.find());
    QSignalSpy found(&search, &DeviceSearch::found);
    search.start(false);
    QTRY_COMPARE_WITH_TIMEOUT(counted.begun.load(), 1, kSearchPatience);

    search.start(true);
    search.start(false);
    search.start(false);
    counted.waits = false;

    QTRY_COMPARE_WITH_TIMEOUT(found.count(), 2, kSearchPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!search.isBusy(), kSearchPatience);
    QCOMPARE(counted.begun.load(), 2);
    QCOMPARE(counted.asking.load(), 1);  // that somebody wanted them asked is not forgotten
}

void DeviceSearchTest::whatIsAskedForWhileItIsHeldComesAfterwards()
{
    CountedSearch counted;
    DeviceSearch search(counted.find());
    QSignalSpy found(&search, &DeviceSearch::found);
    search.setHeld(true);

    search.start(true);
    QVERIFY(!search.isBusy());
    search.setHeld(false);

    QVERIFY(search.isBusy());
    QTRY_COMPARE_WITH_TIMEOUT(found.count(), 1, kSearchPatience);
    QCOMPARE(counted.asking.load(), 1);
}

void DeviceSearchTest::lasersThatWereAskedStayKnown()
{
    std::vector<KnownLasers> given;
    DeviceSearch search([&](bool asks, const KnownLasers& known, const std::stop_token& /*stop*/) {
        given.push_back(known);
        FoundDevice laser;
        laser.port = "1-4";
        laser.serial = asks ? "00903971" : "";
        return FoundDevices{{laser}, {}};
    });
    QSignalSpy found(&search, &DeviceSearch::found);

    search.start(true);
    QTRY_COMPARE_WITH_TIMEOUT(found.count(), 1, kSearchPatience);
    search.start(false);
    QTRY_COMPARE_WITH_TIMEOUT(found.count(), 2, kSearchPatience);

    QVERIFY(given.at(0).empty());
    QCOMPARE(given.at(1), (KnownLasers{{"1-4", "00903971"}}));
    QCOMPARE(search.known(), given.at(1));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::DeviceSearchTest)
#include "device_search_test.moc"
