// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/idle_loop.h"

#include <stdexcept>
#include <thread>

#include <QtTest>

#include "tests/app/session/loops/fakes.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class IdleLoopTest : public QObject {
    Q_OBJECT

private slots:
    void devicesAreLookedAfterTwiceASecond();
    void theHeadGoesHomeOnceForEachWish();
    void anEndStopsWhatIsWaitedFor();
    void whatGoesWrongIsTold();
};

namespace {

/// A loop over a source whose clock the test moves on.
struct Idle {
    Idle() : loop(source, clock, events()) {}
    ~Idle()
    {
        loop.finish();
        if (running.joinable())
            running.join();
    }

    IdleEvents events()
    {
        return {[this](const Result<std::optional<double>>& home) {
                    isHome = home.has_value();
                    ++homes;
                },
                [this](const std::vector<FaultRecord>& told) {
                    code = told.front().code;
                    records += static_cast<int>(told.size());
                }};
    }
    void start()
    {
        running = std::jthread{[this] { loop.run(); }};
    }

    FakeClock clock{FakeClock::Kind::Stands};
    ScriptedSource source{emptySlices(1)};
    std::atomic<bool> isHome{false};
    std::atomic<int> homes{0};
    std::atomic<int> records{0};
    std::string code;  ///< of the last; read when the loop has ended
    IdleLoop loop;
    std::jthread running;
};

}  // namespace

void IdleLoopTest::devicesAreLookedAfterTwiceASecond()
{
    Idle idle;
    idle.start();
    QTRY_COMPARE(idle.source.looks.load(), 1);
    QTRY_VERIFY(idle.clock.waits() > 0);

    idle.clock.advance(499ms);
    const int waits = idle.clock.waits();
    QTRY_VERIFY(idle.clock.waits() > waits + 2);
    QCOMPARE(idle.source.looks.load(), 1);
    idle.clock.advance(1ms);

    QTRY_COMPARE(idle.source.looks.load(), 2);
    QCOMPARE(idle.source.begins.load(), 0);
    QCOMPARE(idle.homes.load(), 0);
}

void IdleLoopTest::theHeadGoesHomeOnceForEachWish()
{
    Idle idle;
    idle.source.onHome = [](const std::stop_token& /*stop*/) { return std::optional{degrees(90.0)}; };
    idle.start();
    QTRY_VERIFY(idle.clock.waits() > 0);

    idle.loop.goHome();  // without waiting for the next look
    QTRY_COMPARE(idle.homes.load(), 1);
    QTRY_COMPARE(idle.source.looks.load(), 2);
    idle.source.onHome = [](const std::stop_token& /*stop*/) -> Result<std::optional<double>> {
        throw std::runtime_error{"no memory"};
    };
    QVERIFY(idle.isHome);
    idle.loop.goHome();

    QTRY_COMPARE(idle.homes.load(), 2);
    QVERIFY(!idle.isHome);
}

void IdleLoopTest::anEndStopsWhatIsWaitedFor()
{
    Idle idle;
    idle.source.onLook = [](const std::stop_token& stop) {
        while (!stop.stop_requested())
            std::this_thread::sleep_for(1ms);
    };
    idle.start();
    QTRY_COMPARE(idle.source.looks.load(), 1);

    idle.loop.finish();
    idle.running.join();

    QCOMPARE(idle.source.looks.load(), 1);
}

void IdleLoopTest::whatGoesWrongIsTold()
{
    Idle idle;
    std::atomic<bool> isTold{false};
    idle.source.onTakeLog = [&] {
        return isTold.exchange(true) ? std::vector<FaultRecord>{}
                                     : std::vector<FaultRecord>{{0ns, "servo-silent", "no answer", ""}};
    };
    idle.source.onLook = [&](const std::stop_token& /*stop*/) {
        if (isTold)
            throw std::runtime_error{"no memory"};
    };
    idle.start();
    QTRY_COMPARE(idle.records.load(), 1);
    QTRY_VERIFY(idle.clock.waits() > 0);

    idle.clock.advance(500ms);
    QTRY_COMPARE(idle.records.load(), 2);
    idle.loop.finish();
    idle.running.join();

    QCOMPARE(idle.code, std::string("internal"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::IdleLoopTest)
#include "idle_loop_test.moc"
