// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/channel.h"

#include <memory>
#include <thread>

#include <QtTest>

#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class ChannelTest : public QObject {
    Q_OBJECT

private slots:
    void valuesComeOutInTheOrderTheyWentIn();
    void closingLetsWhatIsInComeOutAndNothingIn();
    void abandoningEmptiesIt();
    void waitingEndsAtTheMoment();
    void closingWakesWhoeverWaits();
    void nothingIsLostBetweenThreads();
};

void ChannelTest::valuesComeOutInTheOrderTheyWentIn()
{
    Channel<std::unique_ptr<int>> channel{steadyClock()};

    QVERIFY(channel.push(std::make_unique<int>(1)));
    QVERIFY(channel.push(std::make_unique<int>(2)));

    QCOMPARE(channel.depth(), std::size_t(2));
    QCOMPARE(**channel.pop(), 1);
    QCOMPARE(**channel.pop(), 2);
    QCOMPARE(channel.depth(), std::size_t(0));
}

void ChannelTest::closingLetsWhatIsInComeOutAndNothingIn()
{
    Channel<int> channel{steadyClock()};
    channel.push(1);

    channel.close();

    QVERIFY(!channel.push(2));
    QVERIFY(!channel.isDone());
    QCOMPARE(channel.pop().value(), 1);
    QVERIFY(!channel.pop());
    QVERIFY(channel.isDone());
}

void ChannelTest::abandoningEmptiesIt()
{
    Channel<int> channel{steadyClock()};
    channel.push(1);

    channel.abandon();

    QVERIFY(channel.isDone());
    QVERIFY(!channel.pop());
}

void ChannelTest::waitingEndsAtTheMoment()
{
    const FakeClock clock;
    Channel<int> channel{clock};

    QVERIFY(!channel.pop(1s));

    QVERIFY(clock.now() == 1s);
    QVERIFY(!channel.isDone());
}

void ChannelTest::closingWakesWhoeverWaits()
{
    Channel<int> channel{steadyClock()};
    std::jthread waiting{[&] { channel.pop(); }};

    channel.close();

    waiting.join();
}

void ChannelTest::nothingIsLostBetweenThreads()
{
    constexpr int kValues = 20'000;
    Channel<int> channel{steadyClock()};
    std::jthread pushing{[&] {
        for (int value = 0; value < kValues; ++value)
            channel.push(value);
        channel.close();
    }};

    int expected = 0;
    bool inOrder = true;
    while (const auto value = channel.pop())
        inOrder = inOrder && *value == expected++;

    QVERIFY(inOrder);
    QCOMPARE(expected, kValues);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ChannelTest)
#include "channel_test.moc"
