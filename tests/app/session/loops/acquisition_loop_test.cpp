// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/acquisition_loop.h"

#include <QtTest>

#include "tests/app/session/loops/fakes.h"
#include "tests/devices/fake_clock.h"

namespace planewright {

class AcquisitionLoopTest : public QObject {
    Q_OBJECT

private slots:
    void handsOnEverySliceAndThenTheOutcome();
    void givesSlicesAsARecordingGivesThemBack();
    void aScanThatIsFinishedEarlyIsPartial();
    void aScanThatIsFinishedAfterItsLastSliceIsComplete();
    void afterAFaultItGoesOnWhenToldTo();
    void afterAFaultItEndsWhenToldTo();
    void finishingEndsAFault();
    void anExceptionOfTheSourceIsAFault();
    void countsStepsThatWerePassedOver();
    void whateverMovesIsStoppedAtTheEnd();
};

namespace {

/// A loop with what it hands on and tells.
struct Acquisition {
    explicit Acquisition(Recording recording) : source(std::move(recording)) {}

    FakeClock clock{FakeClock::Kind::Stands};
    ScriptedSource source;
    Channel<AcquiredItem> out{clock};
    std::atomic<int> begun{0};
    std::atomic<int> faults{0};
    std::atomic<int> ended{0};
    AcquisitionLoop loop{source,
                         out,
                         clock,
                         {[this] { ++begun; }, [this](const Error& /*error*/) { ++faults; },
                          [this](ScanOutcome /*outcome*/) { ++ended; }}};

    std::vector<AcquiredItem> items()
    {
        out.close();
        std::vector<AcquiredItem> items;
        while (auto item = out.pop())
            items.push_back(std::move(*item));
        return items;
    }
};

Result<void> failOnce(int call)
{
    if (call == 1)
        return fail(ErrorCode::Internal, "The scanner is silent.");
    return {};
}

}  // namespace

void AcquisitionLoopTest::handsOnEverySliceAndThenTheOutcome()
{
    Acquisition acquisition{emptySlices(3)};

    acquisition.loop.run();

    const auto items = acquisition.items();
    QCOMPARE(items.size(), std::size_t(4));
    for (int step = 0; step < 3; ++step)
        QCOMPARE(std::get<SharedSlice>(items[static_cast<std::size_t>(step)])->step, step);
    QCOMPARE(std::get<ScanOutcome>(items[3]), ScanOutcome::Complete);
    QCOMPARE(acquisition.begun.load(), 1);
    QCOMPARE(acquisition.ended.load(), 1);
}

void AcquisitionLoopTest::givesSlicesAsARecordingGivesThemBack()
{
    Recording recording = emptySlices(1);
    recording.slices[0].ranges = {1.23449, 1.2345, -1.0};
    Acquisition acquisition{recording};

    acquisition.loop.run();

    const auto items = acquisition.items();
    QCOMPARE(std::get<SharedSlice>(items[0])->ranges, (std::vector{1.234, 1.235, 0.0}));
}

void AcquisitionLoopTest::aScanThatIsFinishedEarlyIsPartial()
{
    Acquisition acquisition{emptySlices(3)};
    acquisition.source.onNext = [&](int call) -> Result<void> {
        if (call == 1)
            acquisition.loop.finish();
        return {};
    };

    acquisition.loop.run();

    const auto items = acquisition.items();
    QCOMPARE(items.size(), std::size_t(3));
    QCOMPARE(std::get<ScanOutcome>(items[2]), ScanOutcome::Partial);
}

void AcquisitionLoopTest::aScanThatIsFinishedAfterItsLastSliceIsComplete()
{
    Acquisition acquisition{emptySlices(3)};
    acquisition.source.onNext = [&](int call) -> Result<void> {
        if (call == 2)
            acquisition.loop.finish();
        return {};
    };

    acquisition.loop.run();

    QCOMPARE(std::get<ScanOutcome>(acquisition.items().back()), ScanOutcome::Complete);
}

void AcquisitionLoopTest::afterAFaultItGoesOnWhenToldTo()
{
    Acquisition acquisition{emptySlices(3)};
    acquisition.source.onNext = failOnce;
    std::jthread running{[&] { acquisition.loop.run(); }};
    QTRY_COMPARE(acquisition.faults.load(), 1);

    acquisition.loop.retry();
    running.join();

    const auto items = acquisition.items();
    QCOMPARE(items.size(), std::size_t(6));
    QCOMPARE(std::get<ScanEvent>(items[1]).kind, ScanEvent::Kind::Fault);
    QCOMPARE(std::get<ScanEvent>(items[1]).payload, std::string("The scanner is silent."));
    QCOMPARE(std::get<ScanEvent>(items[2]).kind, ScanEvent::Kind::Recovered);
    QCOMPARE(std::get<ScanOutcome>(items[5]), ScanOutcome::Complete);
    QCOMPARE(acquisition.begun.load(), 1);
}

void AcquisitionLoopTest::afterAFaultItEndsWhenToldTo()
{
    Acquisition acquisition{emptySlices(3)};
    acquisition.source.onNext = failOnce;
    std::jthread running{[&] { acquisition.loop.run(); }};
    QTRY_COMPARE(acquisition.faults.load(), 1);

    acquisition.loop.giveUp();
    running.join();

    QCOMPARE(std::get<ScanOutcome>(acquisition.items().back()), ScanOutcome::Fault);
}

void AcquisitionLoopTest::finishingEndsAFault()
{
    Acquisition acquisition{emptySlices(3)};
    acquisition.source.onNext = failOnce;
    std::jthread running{[&] { acquisition.loop.run(); }};
    QTRY_COMPARE(acquisition.faults.load(), 1);

    acquisition.loop.finish();
    running.join();

    QCOMPARE(std::get<ScanOutcome>(acquisition.items().back()), ScanOutcome::Fault);
}

void AcquisitionLoopTest::anExceptionOfTheSourceIsAFault()
{
    Acquisition acquisition{emptySlices(3)};
    acquisition.source.onNext = [](int /*call*/) -> Result<void> { throw std::bad_alloc{}; };
    std::jthread running{[&] { acquisition.loop.run(); }};

    QTRY_COMPARE(acquisition.faults.load(), 1);

    acquisition.loop.giveUp();
}

void AcquisitionLoopTest::countsStepsThatWerePassedOver()
{
    Recording recording = emptySlices(4);
    recording.slices.erase(recording.slices.begin() + 1, recording.slices.begin() + 3);
    Acquisition acquisition{recording};

    acquisition.loop.run();

    QCOMPARE(acquisition.loop.lost(), 2);
    QCOMPARE(acquisition.loop.slices(), 2);
}

void AcquisitionLoopTest::whateverMovesIsStoppedAtTheEnd()
{
    Acquisition acquisition{emptySlices(1)};

    acquisition.loop.run();

    QCOMPARE(acquisition.source.stops.load(), 1);
}

}  // namespace planewright

QTEST_GUILESS_MAIN(planewright::AcquisitionLoopTest)
#include "acquisition_loop_test.moc"
