// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/loops/acquisition_loop.h"

#include <QtTest>

#include "tests/app/session/loops/fakes.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

using namespace std::chrono_literals;

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
    void aLinkThatFailedIsTriedAgainThreeTimesAndThenSomebodyIsAsked();
    void aSliceBeginsTheCountOfTriesAnew();
    void allTriesOfAScanAreBounded();
    void whatNeedsAPersonIsNeverTriedAgainByItself_data();
    void whatNeedsAPersonIsNeverTriedAgainByItself();
    void aStopWhileItIsTriedAgainIsAnsweredAtOnce();
    void anInterruptedSourceIsNoFault();
    void aScannerThatLeftSlicesOutGivesAPartialScan();
    void aRecordingThatLacksSlicesGivesAPartialScan();
    void whateverMovesComesToRestAtTheEnd();
    void whatWentWrongWithDevicesIsToldOnceASecondAndAtTheEnd();
    void whatLedToAFaultIsToldBeforeIt();
};

namespace {

/// A loop with what it hands on and tells.
struct Acquisition {
    explicit Acquisition(Recording recording, AutomaticRecovery automatic = {},
                         FakeClock::Kind kind = FakeClock::Kind::Stands, bool live = true)
        : clock(kind), source(std::move(recording), live), recovery(automatic)
    {
    }

    FakeClock clock;
    ScriptedSource source;
    Channel<AcquiredItem> out{clock};
    std::atomic<int> begun{0};
    std::atomic<int> faults{0};
    std::atomic<int> ended{0};
    AutomaticRecovery recovery;
    std::vector<std::chrono::milliseconds> waits;
    std::atomic<int> recoveries{0};
    std::function<void()> onFault;
    std::vector<FaultRecord> records;
    std::vector<std::string> ledTo;  ///< each time that some were told: the fault
    AcquisitionLoop loop{source,
                         out,
                         clock,
                         {[this] { ++begun; },
                          [this](const Error& /*error*/) {
                              ++faults;
                              if (onFault)
                                  onFault();
                          },
                          [this](ScanOutcome /*outcome*/) { ++ended; },
                          [this](const Error& /*error*/, std::chrono::milliseconds wait) {
                              waits.push_back(wait);
                              ++recoveries;
                          },
                          [this](const std::vector<FaultRecord>& more, const Error* fault) {
                              records.insert(records.end(), more.begin(), more.end());
                              ledTo.push_back(fault == nullptr ? "" : fault->message);
                          }},
                         recovery};

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

Result<void> lost()
{
    return fail(ErrorCode::DeviceLost, "The cable is pulled out.");
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

void AcquisitionLoopTest::aLinkThatFailedIsTriedAgainThreeTimesAndThenSomebodyIsAsked()
{
    Acquisition acquisition{emptySlices(3), {3, 1000}, FakeClock::Kind::Jumps};
    acquisition.source.onNext = [](int call) { return call >= 1 ? lost() : Result<void>{}; };
    acquisition.onFault = [&] { acquisition.loop.giveUp(); };

    acquisition.loop.run();

    const std::vector<std::chrono::milliseconds> waits{500ms, 1000ms, 2000ms};
    QCOMPARE(acquisition.waits, waits);
    QCOMPARE(acquisition.clock.now(), std::chrono::nanoseconds(3500ms));
    QCOMPARE(acquisition.faults.load(), 1);
    QCOMPARE(acquisition.source.releases.load(), 0);
    QCOMPARE(std::get<ScanOutcome>(acquisition.items().back()), ScanOutcome::Fault);
}

void AcquisitionLoopTest::aSliceBeginsTheCountOfTriesAnew()
{
    Acquisition acquisition{emptySlices(10), {1, 1000}, FakeClock::Kind::Jumps};
    acquisition.source.onNext = [](int call) { return call % 2 == 1 ? lost() : Result<void>{}; };

    acquisition.loop.run();

    QCOMPARE(acquisition.faults.load(), 0);
    QCOMPARE(acquisition.loop.slices(), 10);
    QCOMPARE(acquisition.waits.size(), std::size_t(10));
    QCOMPARE(acquisition.waits.back(), 500ms);
    QCOMPARE(std::get<ScanOutcome>(acquisition.items().back()), ScanOutcome::Complete);
}

void AcquisitionLoopTest::allTriesOfAScanAreBounded()
{
    Acquisition acquisition{emptySlices(10), {4, 4}, FakeClock::Kind::Jumps};
    acquisition.source.onNext = [](int call) { return call % 2 == 1 ? lost() : Result<void>{}; };
    acquisition.onFault = [&] { acquisition.loop.giveUp(); };

    acquisition.loop.run();

    QCOMPARE(acquisition.waits.size(), std::size_t(4));
    QCOMPARE(acquisition.faults.load(), 1);
}

void AcquisitionLoopTest::whatNeedsAPersonIsNeverTriedAgainByItself_data()
{
    QTest::addColumn<ErrorCode>("code");
    QTest::newRow("needs somebody") << ErrorCode::NeedsOperator;
    QTest::newRow("our own fault") << ErrorCode::Internal;
    QTest::newRow("a plan that cannot be") << ErrorCode::Usage;
}

void AcquisitionLoopTest::whatNeedsAPersonIsNeverTriedAgainByItself()
{
    QFETCH(ErrorCode, code);
    Acquisition acquisition{emptySlices(3), {100, 100}, FakeClock::Kind::Jumps};
    int calls = 0;
    acquisition.source.onNext = [&](int /*call*/) -> Result<void> {
        ++calls;
        return fail(code, "The board was stopped in an emergency.");
    };
    acquisition.onFault = [&] { acquisition.loop.giveUp(); };

    acquisition.loop.run();

    QCOMPARE(calls, 1);
    QCOMPARE(acquisition.recoveries.load(), 0);
    QCOMPARE(acquisition.faults.load(), 1);
}

void AcquisitionLoopTest::aStopWhileItIsTriedAgainIsAnsweredAtOnce()
{
    Acquisition acquisition{emptySlices(3), {100, 100}};  // its clock stands
    acquisition.source.onNext = [](int /*call*/) { return lost(); };
    std::jthread running{[&] { acquisition.loop.run(); }};
    QTRY_COMPARE(acquisition.recoveries.load(), 1);

    acquisition.loop.finish();
    running.join();

    QCOMPARE(acquisition.recoveries.load(), 1);
    QCOMPARE(acquisition.faults.load(), 0);
    QCOMPARE(acquisition.source.ends.load(), 1);
}

void AcquisitionLoopTest::anInterruptedSourceIsNoFault()
{
    Acquisition acquisition{emptySlices(3), {100, 100}};
    acquisition.source.onBegin = [&](int /*call*/) -> Result<void> {
        acquisition.loop.finish();
        return fail(ErrorCode::Interrupted, "was stopped");
    };

    acquisition.loop.run();

    const auto items = acquisition.items();
    QCOMPARE(items.size(), std::size_t(1));
    QCOMPARE(std::get<ScanOutcome>(items[0]), ScanOutcome::Partial);
    QCOMPARE(acquisition.faults.load() + acquisition.recoveries.load(), 0);
    QCOMPARE(acquisition.source.begins.load(), 1);
}

void AcquisitionLoopTest::aScannerThatLeftSlicesOutGivesAPartialScan()
{
    Acquisition acquisition{emptySlices(6)};
    acquisition.source.planned = 9;
    acquisition.source.firstStep = 1;  // 1 to 6: the first and the last two are missing

    acquisition.loop.run();

    QCOMPARE(std::get<ScanOutcome>(acquisition.items().back()), ScanOutcome::Partial);
    QCOMPARE(acquisition.loop.lost(), 3);
}

void AcquisitionLoopTest::aRecordingThatLacksSlicesGivesAPartialScan()
{
    Acquisition acquisition{emptySlices(6), {}, FakeClock::Kind::Stands, false};
    acquisition.source.planned = 9;

    acquisition.loop.run();

    QCOMPARE(std::get<ScanOutcome>(acquisition.items().back()), ScanOutcome::Partial);
}

void AcquisitionLoopTest::whateverMovesComesToRestAtTheEnd()
{
    Acquisition acquisition{emptySlices(1)};

    acquisition.loop.run();

    QCOMPARE(acquisition.source.ends.load(), 1);
}

/// A slice every 25 ms for 2.5 s, in which every look at the log finds the number of that look.
void AcquisitionLoopTest::whatWentWrongWithDevicesIsToldOnceASecondAndAtTheEnd()
{
    Acquisition acquisition{emptySlices(100)};
    acquisition.clock.advance(10s);
    acquisition.source.onNext = [&](int /*call*/) -> Result<void> {
        acquisition.clock.advance(25ms);
        return {};
    };
    int looks = 0;
    acquisition.source.onTakeLog = [&] {
        return std::vector<FaultRecord>{{acquisition.clock.now(), "look", std::to_string(++looks), ""}};
    };

    acquisition.loop.run();

    // After the first slice, a second later, another one later; where there are no more slices, and where all rests.
    std::vector<std::chrono::nanoseconds> at;
    for (const FaultRecord& record : acquisition.records)
        at.push_back(record.at);
    QCOMPARE(at, (std::vector<std::chrono::nanoseconds>{10'025ms, 11'025ms, 12'025ms, 12'525ms, 12'525ms}));
    QCOMPARE(acquisition.records.back().text, std::string{"5"});
    QCOMPARE(acquisition.ledTo, std::vector<std::string>(5));
}

void AcquisitionLoopTest::whatLedToAFaultIsToldBeforeIt()
{
    Acquisition acquisition{emptySlices(3)};
    acquisition.source.onNext = failOnce;
    std::size_t toldBefore = 0;
    std::string fault;
    acquisition.source.onTakeLog = [] { return std::vector<FaultRecord>{{1s, "laser-silent", "nothing came", ""}}; };
    acquisition.onFault = [&] {
        toldBefore = acquisition.records.size();
        fault = acquisition.ledTo.back();
        acquisition.source.onTakeLog = {};
        acquisition.loop.retry();
    };

    acquisition.loop.run();

    QCOMPARE(acquisition.faults.load(), 1);
    QVERIFY(toldBefore >= 1);
    QVERIFY(!fault.empty());
    QCOMPARE(acquisition.ledTo.back(), fault);
    QCOMPARE(acquisition.records.back().code, std::string{"laser-silent"});
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::AcquisitionLoopTest)
#include "acquisition_loop_test.moc"
