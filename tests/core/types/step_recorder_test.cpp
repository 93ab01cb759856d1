// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/types/step_recorder.h"

#include <string>
#include <vector>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class StepRecorderTest : public QObject {
    Q_OBJECT

private slots:
    void aListenerHearsOfEveryPhaseThatEndsOnce();
    void decisionsHaveThePhaseThatIsOn();
    void passesOfOnePhaseAddUpTheirTimes();
};

void StepRecorderTest::aListenerHearsOfEveryPhaseThatEndsOnce()
{
    StepReport report;
    const StepClock noClock;
    std::vector<std::string> heard;
    const PhaseListener listener = [&](Phase phase, std::string_view pass) {
        heard.push_back(std::string{name(phase)} + ":" + std::string{pass});
    };
    StepRecorder recorder(report, noClock, false, &listener);

    recorder.end();
    recorder.begin(Phase::Extract);
    recorder.begin(Phase::Finish, "merge");
    recorder.begin(Phase::Finish, "thin");
    recorder.end();
    recorder.end();

    QCOMPARE(heard, (std::vector<std::string>{"extract:", "finish:merge", "finish:thin"}));
}

void StepRecorderTest::decisionsHaveThePhaseThatIsOn()
{
    StepReport report;
    const StepClock noClock;
    StepRecorder recorder(report, noClock, true);

    recorder.begin(Phase::Assign);
    recorder.begin(Phase::Fit);
    recorder.decide(DecisionKind::Fit, {ClusterRef{1}}, {}, {PlaneRef{2}});

    QCOMPARE(report.decisions.size(), std::size_t{1});
    QVERIFY(report.decisions[0].phase == Phase::Fit);
}

void StepRecorderTest::passesOfOnePhaseAddUpTheirTimes()
{
    StepReport report;
    int seconds = 0;
    const StepClock clock = [&] { return std::chrono::seconds(seconds); };
    StepRecorder recorder(report, clock, false);

    recorder.begin(Phase::Finish, "merge");
    seconds = 2;
    recorder.begin(Phase::Finish, "thin");
    seconds = 5;
    recorder.end();

    QCOMPARE(report.times[static_cast<std::size_t>(Phase::Finish)], std::chrono::nanoseconds(std::chrono::seconds(5)));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::StepRecorderTest)
#include "step_recorder_test.moc"
