// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/byte_queue.h"

#include <array>
#include <atomic>
#include <numeric>
#include <thread>
#include <vector>

#include <QtTest>

#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ByteQueueTest : public QObject {
    Q_OBJECT

private slots:
    void anArrivalIsReadWithItsTime();
    void twoArrivalsAreNeverMerged();
    void whatDoesNotFitComesNextWithTheSameTime();
    void anArrivalOfNothingIsNone();
    void aDeadlineInThePastGivesWhatIsThere();
    void anEmptyQueueWaitsUntilTheDeadline();
    void aStopEndsTheWait();
    void anArrivalEndsTheWait();
    void theEndComesAfterTheBytesBeforeIt();
    void theFirstReasonStays();
    void theEndWakesTheReader();
    void nothingIsKeptAfterTheEnd();
    void aFloodEndsTheLinkAndLosesNothingBeforeIt();
    void manySmallArrivalsCountWithWhatTheyCost();
    void everyByteComesThroughOnceAndInOrder();
};

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Reads one arrival of at most `most` bytes, without waiting.
Result<Bytes> readOne(ByteQueue& queue, std::size_t most = 100)
{
    Bytes bytes(most);
    const auto arrival = queue.read(bytes, -1ns, {});
    if (!arrival)
        return tl::unexpected<Error>(arrival.error());
    bytes.resize(arrival->count);
    return bytes;
}

const Error kGone{ErrorCode::DeviceLost, "gone"};

}  // namespace

void ByteQueueTest::anArrivalIsReadWithItsTime()
{
    FakeClock clock{FakeClock::Kind::Stands};
    ByteQueue queue{clock, "line"};
    clock.advance(7ms);
    QVERIFY(queue.push(Bytes{1, 2, 3}));
    clock.advance(1s);

    std::array<std::uint8_t, 8> into{};
    const auto arrival = queue.read(into, 10s, {});

    QVERIFY(arrival);
    QCOMPARE(arrival->count, std::size_t(3));
    QVERIFY(arrival->at == 7ms);
    QVERIFY((into == std::array<std::uint8_t, 8>{1, 2, 3}));
}

void ByteQueueTest::twoArrivalsAreNeverMerged()
{
    FakeClock clock;
    ByteQueue queue{clock, "line"};
    queue.push(Bytes{1, 2});
    queue.push(Bytes{3});

    QCOMPARE(readOne(queue).value(), (Bytes{1, 2}));
    QCOMPARE(readOne(queue).value(), Bytes{3});
    QCOMPARE(readOne(queue).value(), Bytes{});
}

void ByteQueueTest::whatDoesNotFitComesNextWithTheSameTime()
{
    FakeClock clock{FakeClock::Kind::Stands};
    ByteQueue queue{clock, "line"};
    queue.push(Bytes{1, 2, 3});
    clock.advance(1s);
    queue.push(Bytes{4});

    std::array<std::uint8_t, 2> into{};
    const auto first = queue.read(into, 0s, {});
    const auto second = queue.read(into, 0s, {});
    const auto third = queue.read(into, 0s, {});

    QCOMPARE(first->count, std::size_t(2));
    QCOMPARE(second->count, std::size_t(1));
    QVERIFY(second->at == 0s);
    QCOMPARE(third->count, std::size_t(1));
    QVERIFY(third->at == 1s);
    QCOMPARE(into[0], std::uint8_t(4));
}

void ByteQueueTest::anArrivalOfNothingIsNone()
{
    FakeClock clock;
    ByteQueue queue{clock, "line"};

    QVERIFY(queue.push({}));
    queue.push(Bytes{5});

    QCOMPARE(readOne(queue).value(), Bytes{5});
}

void ByteQueueTest::aDeadlineInThePastGivesWhatIsThere()
{
    FakeClock clock{FakeClock::Kind::Stands};
    clock.advance(1h);
    ByteQueue queue{clock, "line"};
    queue.push(Bytes{1});
    std::array<std::uint8_t, 4> into{};

    QCOMPARE(queue.read(into, 0s, {})->count, std::size_t(1));
    QCOMPARE(queue.read(into, 0s, {})->count, std::size_t(0));
    QCOMPARE(clock.waits(), 0);
}

void ByteQueueTest::anEmptyQueueWaitsUntilTheDeadline()
{
    FakeClock clock;
    ByteQueue queue{clock, "line"};
    std::array<std::uint8_t, 4> into{};

    const auto arrival = queue.read(into, 150ms, {});

    QCOMPARE(arrival->count, std::size_t(0));
    QVERIFY(arrival->at == 150ms);
}

void ByteQueueTest::aStopEndsTheWait()
{
    ByteQueue queue{steadyClock(), "line"};
    std::atomic<bool> cameBack{false};
    std::jthread reader{[&](const std::stop_token& stop) {
        std::array<std::uint8_t, 4> into{};
        const auto arrival = queue.read(into, steadyClock().now() + 1h, stop);
        cameBack = arrival && arrival->count == 0;
    }};

    reader.request_stop();
    reader.join();

    QVERIFY(cameBack);
}

void ByteQueueTest::anArrivalEndsTheWait()
{
    FakeClock clock{FakeClock::Kind::Stands};
    ByteQueue queue{clock, "line"};
    std::atomic<std::size_t> count{0};
    std::jthread reader{[&](const std::stop_token& stop) {
        std::array<std::uint8_t, 4> into{};
        count = queue.read(into, 1h, stop)->count;
    }};
    QTRY_VERIFY(clock.waits() > 0);

    queue.push(Bytes{1, 2, 3});
    reader.join();

    QCOMPARE(count.load(), std::size_t(3));
}

void ByteQueueTest::theEndComesAfterTheBytesBeforeIt()
{
    FakeClock clock;
    ByteQueue queue{clock, "line"};
    queue.push(Bytes{1, 2});

    queue.end(kGone);

    QCOMPARE(readOne(queue, 1).value(), Bytes{1});
    QCOMPARE(readOne(queue, 1).value(), Bytes{2});
    QCOMPARE(readOne(queue).error().message, std::string("gone"));
    QCOMPARE(readOne(queue).error().code, ErrorCode::DeviceLost);
}

void ByteQueueTest::theFirstReasonStays()
{
    FakeClock clock;
    ByteQueue queue{clock, "line"};
    QVERIFY(!queue.ended());

    queue.end(kGone);
    queue.end({ErrorCode::DeviceLost, "closed"});

    QCOMPARE(queue.ended()->message, std::string("gone"));
    QCOMPARE(readOne(queue).error().message, std::string("gone"));
}

void ByteQueueTest::theEndWakesTheReader()
{
    ByteQueue queue{steadyClock(), "line"};
    std::atomic<bool> failed{false};
    std::jthread reader{[&](const std::stop_token& stop) {
        std::array<std::uint8_t, 4> into{};
        failed = !queue.read(into, steadyClock().now() + 1h, stop);
    }};

    queue.end(kGone);
    reader.join();

    QVERIFY(failed);
}

void ByteQueueTest::nothingIsKeptAfterTheEnd()
{
    FakeClock clock;
    ByteQueue queue{clock, "line"};
    queue.end(kGone);

    QVERIFY(!queue.push(Bytes{1}));
    QVERIFY(!queue.push({}));

    QVERIFY(!readOne(queue));
}

void ByteQueueTest::aFloodEndsTheLinkAndLosesNothingBeforeIt()
{
    FakeClock clock;
    ByteQueue queue{clock, "usb 1-4", 1000};
    std::size_t kept = 0;
    for (std::uint8_t value = 0; queue.push(Bytes(100, value)); ++value)
        ++kept;

    QVERIFY(kept >= 5 && kept < 10);
    for (std::size_t i = 0; i < kept; ++i)
        QCOMPARE(readOne(queue).value(), Bytes(100, static_cast<std::uint8_t>(i)));
    const auto after = readOne(queue);
    QVERIFY(!after);
    QCOMPARE(after.error().code, ErrorCode::DeviceLost);
    QVERIFY(after.error().message.starts_with("usb 1-4: "));
}

void ByteQueueTest::manySmallArrivalsCountWithWhatTheyCost()
{
    FakeClock clock;
    ByteQueue queue{clock, "line", 1000};
    int kept = 0;
    while (queue.push(Bytes{1}))
        ++kept;

    QVERIFY(kept > 10 && kept < 100);
}

void ByteQueueTest::everyByteComesThroughOnceAndInOrder()
{
    constexpr std::size_t kCount = 300'000;
    ByteQueue queue{steadyClock(), "line"};
    std::jthread writer{[&] {
        std::uint8_t next = 0;
        std::size_t size = 1;
        for (std::size_t sent = 0; sent < kCount; sent += size) {
            size = std::min(size % 997 + 13, kCount - sent);
            Bytes bytes(size);
            std::iota(bytes.begin(), bytes.end(), next);
            next = static_cast<std::uint8_t>(next + size);
            queue.push(bytes);
        }
        queue.end(kGone);
    }};

    std::array<std::uint8_t, 256> into{};
    std::size_t count = 0;
    std::size_t wrong = 0;
    while (const auto arrival = queue.read(into, steadyClock().now() + 1min, {})) {
        for (std::size_t i = 0; i < arrival->count; ++i, ++count)
            wrong += into[i] == static_cast<std::uint8_t>(count) ? 0 : 1;
    }

    QCOMPARE(count, kCount);
    QCOMPARE(wrong, std::size_t(0));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ByteQueueTest)
#include "byte_queue_test.moc"
