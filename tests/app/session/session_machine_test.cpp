// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/session/session_machine.h"

#include <random>
#include <set>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class SessionMachineTest : public QObject {
    Q_OBJECT

private slots:
    void aScanGoesThroughItsStates();
    void aRecordingIsWorkedInAndReviewed();
    void aFileThatCannotBeChangedIsReadOnly();
    void whatCannotBeOpenedLeadsBack();
    void aScannerThatCannotBeOpenedCanBeTriedAgain();
    void aFaultLeadsOnOrToReview();
    void stopMotionEndsAScan();
    void nothingMovesAfterAStopOfMotionBeforeItIsReleased();
    void motionCanBeStoppedWithoutAScanner();
    void theHeadGoesHomeBetweenScans();
    void anEmptyScanLeadsBackToReady();
    void aRerunLeavesNothingRecording();
    void aScannerThatIsLetGoLeavesItsScan();
    void randomWalksKeepTheRules_data();
    void randomWalksKeepTheRules();
};

namespace {

using State = SessionState;
using Request = SessionRequest;
using Happening = SessionHappening;

/// A machine that was asked and to which things happened, in this order.
template <class... Inputs>
SessionMachine after(Inputs... inputs)
{
    SessionMachine machine;
    const auto feed = [&](auto input) {
        if constexpr (std::is_same_v<decltype(input), Request>)
            QVERIFY2(machine.request(input), std::string{machine.refusal(input)}.c_str());
        else
            machine.happen(input);
    };
    (feed(inputs), ...);
    return machine;
}

SessionMachine scanning()
{
    return after(Request::Open, Happening::Connected, Request::Start, Happening::Begun);
}

Request anyRequest(std::mt19937& random)
{
    return static_cast<Request>(random() % kSessionRequests);
}

}  // namespace

void SessionMachineTest::aScanGoesThroughItsStates()
{
    SessionMachine machine;
    const auto asked = [&](Request request) {
        [[maybe_unused]] const auto done = machine.request(request);
        return machine.state();
    };
    const auto happened = [&](Happening happening) {
        machine.happen(happening);
        return machine.state();
    };

    QCOMPARE(machine.state(), State::Empty);
    QCOMPARE(asked(Request::Open), State::Connecting);
    QCOMPARE(happened(Happening::Connected), State::Ready);
    QCOMPARE(asked(Request::Start), State::Homing);
    QCOMPARE(happened(Happening::Begun), State::Scanning);
    QCOMPARE(asked(Request::Pause), State::Paused);
    QCOMPARE(asked(Request::Step), State::Paused);
    QCOMPARE(asked(Request::Continue), State::Scanning);
    QCOMPARE(happened(Happening::SourceEnded), State::Finishing);
    QCOMPARE(happened(Happening::CaughtUp), State::Review);
    QCOMPARE(asked(Request::Start), State::Homing);
    QCOMPARE(asked(Request::Close), State::Empty);
}

void SessionMachineTest::aRecordingIsWorkedInAndReviewed()
{
    const SessionMachine machine =
        after(Request::Open, Happening::Loaded, Request::Pause, Request::Continue, Request::SetSpeed);
    QCOMPARE(machine.state(), State::Replaying);

    QCOMPARE(after(Request::Open, Happening::Loaded, Happening::SourceEnded, Happening::CaughtUp).state(),
             State::Review);
    QCOMPARE(
        after(Request::Open, Happening::Loaded, Happening::SourceEnded, Happening::CaughtUp, Request::Start).state(),
        State::Replaying);
}

void SessionMachineTest::aFileThatCannotBeChangedIsReadOnly()
{
    const SessionMachine machine =
        after(Request::Open, Happening::LoadedReadOnly, Happening::SourceEnded, Happening::CaughtUp);

    QCOMPARE(machine.state(), State::ReadOnly);
    QVERIFY(!machine.refusal(Request::Rerun).empty());
    QVERIFY(!machine.refusal(Request::SetParameters).empty());
    QVERIFY(machine.refusal(Request::GoToStep).empty());
    QVERIFY(machine.refusal(Request::Open).empty());
}

void SessionMachineTest::whatCannotBeOpenedLeadsBack()
{
    QCOMPARE(after(Request::Open, Happening::LoadingFailed).state(), State::Empty);
    QCOMPARE(after(Request::Open, Request::Cancel).state(), State::Empty);
    QCOMPARE(after(Request::Open, Happening::Loaded, Happening::SourceEnded, Happening::CaughtUp, Request::Open,
                   Happening::LoadingFailed)
                 .state(),
             State::Review);
}

void SessionMachineTest::aScannerThatCannotBeOpenedCanBeTriedAgain()
{
    QCOMPARE(after(Request::Open, Happening::ConnectingFailed).state(), State::Fault);
    QCOMPARE(after(Request::Open, Happening::ConnectingFailed, Request::Retry).state(), State::Connecting);
    QCOMPARE(after(Request::Open, Happening::ConnectingFailed, Request::Finish).state(), State::Empty);
}

void SessionMachineTest::aFaultLeadsOnOrToReview()
{
    SessionMachine machine = scanning();

    machine.happen(Happening::SourceFailed);
    QCOMPARE(machine.state(), State::Fault);
    QVERIFY(machine.mayRecord());
    QVERIFY(machine.request(Request::Retry));
    QCOMPARE(machine.state(), State::Scanning);
    machine.happen(Happening::SourceFailed);
    QVERIFY(machine.request(Request::Finish));
    QCOMPARE(machine.state(), State::Finishing);

    SessionMachine homing = after(Request::Open, Happening::Connected, Request::Start, Happening::SourceFailed);
    QVERIFY(homing.request(Request::Retry));
    QCOMPARE(homing.state(), State::Homing);
}

void SessionMachineTest::stopMotionEndsAScan()
{
    for (SessionMachine machine :
         {scanning(), after(Request::Open, Happening::Connected, Request::Start),
          after(Request::Open, Happening::Connected, Request::Start, Happening::Begun, Request::Pause)}) {
        QVERIFY(machine.request(Request::StopMotion));
        QCOMPARE(machine.state(), State::Finishing);
    }
    SessionMachine replaying = after(Request::Open, Happening::Loaded);
    QVERIFY(replaying.request(Request::StopMotion));
    QCOMPARE(replaying.state(), State::Replaying);
}

void SessionMachineTest::nothingMovesAfterAStopOfMotionBeforeItIsReleased()
{
    const auto refused = [](const SessionMachine& machine, Request request) {
        return machine.refusal(request).find("Release it") != std::string_view::npos;
    };
    SessionMachine ready = after(Request::Open, Happening::Connected, Request::StopMotion);
    QVERIFY(ready.isMotionStopped());
    QVERIFY(refused(ready, Request::Start));
    QVERIFY(ready.request(Request::Release));
    QVERIFY(!ready.isMotionStopped());
    QVERIFY(ready.request(Request::Start));

    SessionMachine fault = scanning();
    fault.happen(Happening::SourceFailed);
    QVERIFY(fault.request(Request::StopMotion));
    QCOMPARE(fault.state(), State::Fault);
    QVERIFY(refused(fault, Request::Retry));
    QVERIFY(fault.refusal(Request::Finish).empty());
    QVERIFY(fault.request(Request::Release));
    QCOMPARE(fault.state(), State::Fault);  // it goes on only when it is told to
    QVERIFY(fault.request(Request::Retry));

    SessionMachine over = scanning();
    QVERIFY(over.request(Request::StopMotion));
    over.happen(Happening::CaughtUp);
    QCOMPARE(over.state(), State::Review);
    QVERIFY(refused(over, Request::Start));
    QVERIFY(over.request(Request::Open));
    over.happen(Happening::Connected);
    QVERIFY(refused(over, Request::Start));  // another scanner moves as little
    QVERIFY(over.request(Request::Close));
    QVERIFY(over.isMotionStopped());
    QVERIFY(over.request(Request::Open));
    over.happen(Happening::ConnectingFailed);
    QVERIFY(refused(over, Request::Retry));
    QVERIFY(over.request(Request::Release));
    QVERIFY(!over.isMotionStopped());
}

void SessionMachineTest::motionCanBeStoppedWithoutAScanner()
{
    // Devices may be moved elsewhere, for a test of them.
    SessionMachine empty;
    QVERIFY(empty.request(Request::StopMotion));
    QVERIFY(empty.isMotionStopped());
    QCOMPARE(empty.state(), State::Empty);

    SessionMachine replay = after(Request::Open, Happening::Loaded, Request::StopMotion, Happening::CaughtUp);
    QVERIFY(replay.isMotionStopped());
    QVERIFY(replay.request(Request::Start));  // which moves nothing
    QVERIFY(replay.request(Request::Release));
}

void SessionMachineTest::theHeadGoesHomeBetweenScans()
{
    SessionMachine over = scanning();
    QVERIFY(!over.refusal(Request::GoHome).empty());
    over.happen(Happening::SourceEnded);
    over.happen(Happening::CaughtUp);
    for (SessionMachine machine : {after(Request::Open, Happening::Connected), over}) {
        const State before = machine.state();
        QVERIFY(machine.isIdle());
        QVERIFY(machine.request(Request::GoHome));
        QCOMPARE(machine.state(), State::Homing);
        QVERIFY(machine.goesHome() && machine.isIdle() && machine.mayMove());
        QVERIFY(!machine.mayRecord());
        QCOMPARE(machine.hasScan(), before == State::Review);
        QVERIFY(!machine.refusal(Request::Start).empty());
        machine.happen(Happening::Begun);  // of no scan
        QCOMPARE(machine.state(), State::Homing);
        machine.happen(Happening::Home);
        QCOMPARE(machine.state(), before);

        QVERIFY(machine.request(Request::GoHome));
        QVERIFY(machine.request(Request::StopMotion));
        QCOMPARE(machine.state(), before);
        QVERIFY(machine.refusal(Request::GoHome).find("Release it") != std::string_view::npos);
        machine.happen(Happening::Home);
        QCOMPARE(machine.state(), before);
    }
    QVERIFY(!SessionMachine{}.refusal(Request::GoHome).empty());
    QVERIFY(!after(Request::Open, Happening::Loaded, Happening::CaughtUp).refusal(Request::GoHome).empty());
}

void SessionMachineTest::anEmptyScanLeadsBackToReady()
{
    QCOMPARE(after(Request::Open, Happening::Connected, Request::Start, Request::StopMotion, Happening::CaughtUpEmpty)
                 .state(),
             State::Ready);
}

void SessionMachineTest::aScannerThatIsLetGoLeavesItsScan()
{
    QCOMPARE(after(Request::Open, Happening::Connected, Happening::LetGo).state(), State::Empty);
    QCOMPARE(scanning().state(), after(Request::Open, Happening::Connected, Request::Start, Happening::Begun,
                                       Happening::LetGo)
                                     .state());  // not while it scans

    SessionMachine machine = after(Request::Open, Happening::Connected, Request::Start, Happening::Begun,
                                   Happening::SourceEnded, Happening::CaughtUp, Happening::LetGo);
    QCOMPARE(machine.state(), State::Review);
    QVERIFY(machine.hasScan());
    QVERIFY(!machine.isLive());
    for (const Request request : {Request::Start, Request::SetSpeed, Request::GoHome})
        QVERIFY(machine.refusal(request).starts_with("No scanner is connected."));
    QVERIFY(machine.refusal(Request::Rerun).empty());

    // Where the next one does not come, the scan is still there; where it comes, everything is as ever.
    QVERIFY(machine.request(Request::Open));
    machine.happen(Happening::LoadingFailed);
    QCOMPARE(machine.state(), State::Review);
    QVERIFY(!machine.refusal(Request::Start).empty());
    QVERIFY(machine.request(Request::Open));
    machine.happen(Happening::Connected);
    QVERIFY(machine.request(Request::Start));
}

void SessionMachineTest::aRerunLeavesNothingRecording()
{
    SessionMachine machine = scanning();
    machine.happen(Happening::SourceEnded);
    machine.happen(Happening::CaughtUp);

    QVERIFY(machine.request(Request::Rerun));
    QCOMPARE(machine.state(), State::Replaying);
    QVERIFY(!machine.mayRecord());
    QVERIFY(!machine.refusal(Request::Pause).empty());
    QVERIFY(machine.request(Request::Cancel));
    QVERIFY(!machine.mayRecord());
    machine.happen(Happening::CaughtUp);

    QCOMPARE(machine.state(), State::Review);
}

void SessionMachineTest::randomWalksKeepTheRules_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 20; ++seed)
        QTest::addRow("seed %u", seed) << seed;
}

void SessionMachineTest::randomWalksKeepTheRules()
{
    QFETCH(unsigned, seed);
    std::mt19937 random{seed};
    SessionMachine machine;
    std::set<State> seen;
    std::set<State> left;
    for (int i = 0; i < 20'000; ++i) {
        const State before = machine.state();
        seen.insert(before);
        if (random() % 2 == 0) {
            const Request request = anyRequest(random);
            // Closing is legal everywhere: asked as often as the rest, it would keep walks short.
            if (request == Request::Close && random() % 50 != 0)
                continue;
            const std::string why{machine.refusal(request)};
            const Result<void> done = machine.request(request);

            QCOMPARE(done.has_value(), why.empty());
            if (!done) {
                QCOMPARE(machine.state(), before);
                QCOMPARE(done.error().message, why);
                QVERIFY(why.ends_with('.'));
            }
        } else {
            const auto happening = static_cast<Happening>(random() % kSessionHappenings);
            // Nor is a scanner let go as often as the rest.
            if (happening == Happening::LetGo && random() % 50 != 0)
                continue;
            machine.happen(happening);
        }
        if (machine.state() != before)
            left.insert(before);

        QVERIFY(machine.refusal(Request::StopMotion).empty());
        QVERIFY(machine.refusal(Request::Close).empty());
        for (const State idle : {State::Empty, State::Connecting, State::Ready, State::Review, State::ReadOnly})
            QVERIFY(machine.state() != idle || !machine.mayRecord());
        SessionMachine stopped = machine;
        QVERIFY(stopped.request(Request::StopMotion));
        QVERIFY(stopped.state() != State::Scanning && stopped.state() != State::Homing);
        SessionMachine closed = machine;
        QVERIFY(closed.request(Request::Close));
        QCOMPARE(closed.state(), State::Empty);
        QVERIFY(!closed.mayRecord());
    }

    QCOMPARE(seen.size(), kSessionStates);
    QCOMPARE(left.size(), kSessionStates);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SessionMachineTest)
#include "session_machine_test.moc"
