// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/fault_log.h"

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class FaultLogTest : public QObject {
    Q_OBJECT

private slots:
    void keepsWhatWasSeen();
    void aRecordIsTakenOnce();
    void onlyTheLastAreKeptAndAllAreCounted();
    void longBytesAreCut();
    void aRecordIsOneLine();
};

void FaultLogTest::keepsWhatWasSeen()
{
    FaultLog log;
    log.add(3s, "laser-sum", "a line with a wrong sum", textBytes("MD\n"));

    const auto records = log.take();

    QCOMPARE(records.size(), std::size_t(1));
    QVERIFY(records[0].at == 3s);
    QCOMPARE(records[0].code, std::string{"laser-sum"});
    QCOMPARE(records[0].text, std::string{"a line with a wrong sum"});
    QCOMPARE(records[0].bytes, std::string{"4D 44 0A"});
}

void FaultLogTest::aRecordIsTakenOnce()
{
    FaultLog log;
    log.add(1s, "a", "first");
    log.add(2s, "b", "second");

    const auto records = log.take();

    QCOMPARE(records.size(), std::size_t(2));
    QCOMPARE(records[0].text, std::string{"first"});
    QCOMPARE(records[1].bytes, std::string{});
    QVERIFY(log.take().empty());
}

void FaultLogTest::onlyTheLastAreKeptAndAllAreCounted()
{
    FaultLog log;
    for (int i = 0; i < 100; ++i)
        log.add(std::chrono::seconds{i}, i % 4 == 0 ? "rare" : "often", std::to_string(i));

    QVERIFY((log.counts() == FaultCounts{{"often", 75}, {"rare", 25}}));
    const auto records = log.take();
    QCOMPARE(records.size(), FaultLog::kMostRecords);
    QCOMPARE(records.front().text, std::string{"80"});
    QCOMPARE(records.back().text, std::string{"99"});

    log.restartCounts();

    QVERIFY(log.counts().empty());
}

void FaultLogTest::longBytesAreCut()
{
    FaultLog log;
    log.add(1s, "exact", "", std::vector<std::uint8_t>(64, 0xFF));
    log.add(1s, "long", "", std::vector<std::uint8_t>(65, 0xFF));

    const auto records = log.take();

    QCOMPARE(records[0].bytes.size(), std::size_t(64 * 3 - 1));
    QVERIFY(records[1].bytes.starts_with(records[0].bytes));
    QVERIFY(records[1].bytes.ends_with("FF …"));
}

void FaultLogTest::aRecordIsOneLine()
{
    QCOMPARE(recordText({3s, "laser-sum", "a line with a wrong sum", "4D 44 0A"}),
             std::string{"a line with a wrong sum (laser-sum: 4D 44 0A)"});
    QCOMPARE(recordText({3s, "servo-silent", "a question was not answered", ""}),
             std::string{"a question was not answered (servo-silent)"});
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::FaultLogTest)
#include "fault_log_test.moc"
