// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/recording_loop.h"

#include <QtTest>

#include "tests/app/session/loops/fakes.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

class RecordingLoopTest : public QObject {
    Q_OBJECT

private slots:
    void recordsAllThatComesInItsOrder();
    void aSliceIsOnTheDiskBeforeItIsHandedOn();
    void parametersAreInForceFromTheNextStep();
    void aRecorderThatFailsForAWhileLosesNothing();
    void aFileThatCannotBeMadeAtOnceIsMadeLater();
    void aDiskThatStaysAwayIsGivenUpAfterSomeTries();
    void whatIsLostIsCountedInSlices();
    void inAHurryTheFirstFailureIsTheLast();
    void withoutARecorderAllIsHandedOn();
    void aScanWithoutAnOutcomeIsPartial();
};

namespace {

/// A loop with its recorder and its two ends.
struct RecordingRun {
    explicit RecordingRun(bool records = true)
        : loop{records ? std::make_unique<FakeRecorder>(scan) : nullptr,
               {},
               5,
               {{0, {}}},
               in,
               out,
               clock,
               {[this](const Error& /*error*/) { ++troubles; }, [this] { ++recoveries; },
                [this](const Result<void>& result) {
                    ++closes;
                    closed = result;
                }}}
    {
    }

    void push(int step)
    {
        ScanSlice slice;
        slice.step = step;
        in.push(std::make_shared<const ScanSlice>(slice));
    }

    std::shared_ptr<RecordedScan> scan = std::make_shared<RecordedScan>();
    FakeClock clock;
    Channel<AcquiredItem> in{clock};
    Channel<ExtractionItem> out{clock};
    std::atomic<int> troubles{0};
    std::atomic<int> recoveries{0};
    std::atomic<int> closes{0};
    Result<void> closed;
    RecordingLoop loop;
};

using Lines = std::vector<std::string>;

}  // namespace

void RecordingLoopTest::recordsAllThatComesInItsOrder()
{
    RecordingRun run;
    run.push(0);
    run.in.push(ScanEvent{ScanEvent::Kind::Pause, {}, {}, {}});
    run.push(1);
    run.in.push(ScanOutcome::Complete);

    run.loop.run();

    QCOMPARE(run.scan->lines, (Lines{"begin", "parameters 0", "slice 0", "event pause", "slice 1", "close complete"}));
    QCOMPARE(run.out.depth(), std::size_t(2));
    QVERIFY(!run.out.push(SharedSlice{}));
    QVERIFY(run.closed);
    QCOMPARE(run.closes.load(), 1);
    QCOMPARE(run.troubles.load(), 0);
    QCOMPARE(run.loop.status().bytes, std::uint64_t{200});
}

void RecordingLoopTest::aSliceIsOnTheDiskBeforeItIsHandedOn()
{
    RecordingRun run;
    std::jthread running{[&] { run.loop.run(); }};

    for (int step = 0; step < 50; ++step) {
        run.push(step);
        QVERIFY(run.out.pop());
        QCOMPARE(run.scan->slices(), step + 1);
    }

    run.in.push(ScanOutcome::Complete);
}

void RecordingLoopTest::parametersAreInForceFromTheNextStep()
{
    RecordingRun run;
    run.push(6);
    run.in.push(Parameters{});
    run.in.push(ScanOutcome::Complete);

    run.loop.run();

    run.out.pop();
    QCOMPARE(std::get<ParametersFrom>(*run.out.pop()).step, 7);
    QCOMPARE(run.scan->lines[3], std::string("parameters 7"));
}

void RecordingLoopTest::aRecorderThatFailsForAWhileLosesNothing()
{
    RecordingRun run;
    std::jthread running{[&] { run.loop.run(); }};
    run.push(0);
    QVERIFY(run.out.pop());

    run.scan->fails = true;
    for (int step = 1; step < 5; ++step) {
        run.push(step);
        QVERIFY(run.out.pop());
    }
    QTRY_COMPARE(run.loop.status().notOnDisk, std::size_t(4));
    run.scan->fails = false;
    QTRY_COMPARE(run.recoveries.load(), 1);
    run.push(5);
    run.in.push(ScanOutcome::Complete);
    running.join();

    QCOMPARE(run.scan->lines, (Lines{"begin", "parameters 0", "slice 0", "slice 1", "slice 2", "slice 3", "slice 4",
                                     "slice 5", "close complete"}));
    QCOMPARE(run.troubles.load(), 1);
    QVERIFY(run.closed);
    QCOMPARE(run.loop.status().notOnDisk, std::size_t(0));
}

void RecordingLoopTest::aFileThatCannotBeMadeAtOnceIsMadeLater()
{
    RecordingRun run;
    run.scan->fails = true;
    std::jthread running{[&] { run.loop.run(); }};
    run.push(0);
    QVERIFY(run.out.pop());
    QTRY_COMPARE(run.troubles.load(), 1);

    run.scan->fails = false;
    QTRY_COMPARE(run.recoveries.load(), 1);
    run.in.push(ScanOutcome::Complete);
    running.join();

    QCOMPARE(run.scan->lines, (Lines{"begin", "parameters 0", "slice 0", "close complete"}));
}

void RecordingLoopTest::aDiskThatStaysAwayIsGivenUpAfterSomeTries()
{
    RecordingRun run;
    run.scan->fails = true;
    run.push(0);
    run.in.push(ScanOutcome::Complete);

    run.loop.run();

    QCOMPARE(run.out.depth(), std::size_t(1));
    QVERIFY(run.clock.now() >= (RecordingLoop::kLastTries - 1) * RecordingLoop::kRetryAfter);
    QVERIFY(!run.closed);
    QCOMPARE(run.closed.error().code, ErrorCode::NotWritten);
    QVERIFY(run.closed.error().message.ends_with("; 1 slice of this scan is not on the disk"));
}

void RecordingLoopTest::whatIsLostIsCountedInSlices()
{
    RecordingRun run;
    run.scan->fails = true;
    for (int step = 0; step < 3; ++step)
        run.push(step);
    run.in.push(ScanEvent{ScanEvent::Kind::Pause, {}, {}, {}});
    run.in.push(ScanOutcome::Complete);

    run.loop.run();

    QVERIFY(!run.closed);
    QVERIFY(run.closed.error().message.ends_with("; 3 slices of this scan are not on the disk"));
}

void RecordingLoopTest::inAHurryTheFirstFailureIsTheLast()
{
    RecordingRun run;
    run.scan->fails = true;
    run.push(0);
    run.in.push(ScanOutcome::Partial);
    run.loop.hurry();

    run.loop.run();

    QVERIFY(!run.closed);
    QVERIFY(run.clock.now() <= RecordingLoop::kRetryAfter);
}

void RecordingLoopTest::withoutARecorderAllIsHandedOn()
{
    RecordingRun run{false};
    run.push(0);
    run.in.push(Parameters{});
    run.in.push(ScanEvent{});
    run.push(1);
    run.in.push(ScanOutcome::Complete);

    run.loop.run();

    QCOMPARE(run.out.depth(), std::size_t(3));
    QCOMPARE(run.closes.load(), 0);
}

void RecordingLoopTest::aScanWithoutAnOutcomeIsPartial()
{
    RecordingRun run;
    run.push(0);
    run.in.close();

    run.loop.run();

    QCOMPARE(run.scan->lines.back(), std::string("close partial"));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::RecordingLoopTest)
#include "recording_loop_test.moc"
