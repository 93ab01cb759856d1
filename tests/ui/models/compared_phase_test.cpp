// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/compared_phase.h"

#include <initializer_list>

#include <QtTest>

#include "tests/test_program.h"

namespace planewright {
namespace {

PhasedStep stepOf(std::initializer_list<Phase> phases)
{
    PhasedStep step;
    for (const Phase phase : phases)
        step.phases.push_back({phase, {}, nullptr});
    return step;
}

PhasedStep lastPassOf(std::initializer_list<std::string_view> passes)
{
    PhasedStep step;
    for (const std::string_view pass : passes)
        step.phases.push_back({Phase::Finish, pass, nullptr});
    return step;
}

}  // namespace

class ComparedPhaseTest : public QObject {
    Q_OBJECT

private slots:
    void theSamePhaseIsBeside();
    void aPhaseThatIsNotDueIsTheOneBefore();
    void passesAreCounted();
    void anotherMethodHasOtherPasses();
};

void ComparedPhaseTest::theSamePhaseIsBeside()
{
    const PhasedStep a = stepOf({Phase::Extract, Phase::Assign, Phase::Cluster, Phase::SplitMerge});
    const PhasedStep b = stepOf({Phase::Extract, Phase::Assign, Phase::Cluster, Phase::Fit, Phase::SplitMerge});

    QVERIFY(comparedPhase(a, 1, b).state == &b.phases[1]);
    QVERIFY(comparedPhase(a, 3, b).state == &b.phases[4]);
    QVERIFY(comparedPhase(a, 3, b).isSame);
}

void ComparedPhaseTest::aPhaseThatIsNotDueIsTheOneBefore()
{
    const PhasedStep a = stepOf({Phase::Extract, Phase::Assign, Phase::Cluster, Phase::Fit, Phase::Remaining});
    const PhasedStep b = stepOf({Phase::Extract, Phase::Assign, Phase::Cluster, Phase::SplitMerge});

    const ComparedPhase fit = comparedPhase(a, 3, b);
    const ComparedPhase remaining = comparedPhase(a, 4, b);

    QVERIFY(fit.state == &b.phases[2]);
    QVERIFY(!fit.isSame);
    QVERIFY(remaining.state == &b.phases[3]);
    QVERIFY(!remaining.isSame);
}

void ComparedPhaseTest::passesAreCounted()
{
    const PhasedStep a = lastPassOf({"merge", "split", "merge", "thin"});
    const PhasedStep b = lastPassOf({"merge", "split", "merge", "thin"});

    for (std::size_t pass = 0; pass < a.phases.size(); ++pass) {
        QVERIFY(comparedPhase(a, pass, b).state == &b.phases[pass]);
        QVERIFY(comparedPhase(a, pass, b).isSame);
    }
}

void ComparedPhaseTest::anotherMethodHasOtherPasses()
{
    const PhasedStep a = lastPassOf({"merge", "thin", "merge"});
    const PhasedStep b = lastPassOf({"fit", "merge"});

    QVERIFY(comparedPhase(a, 0, b).state == &b.phases[1]);
    QVERIFY(comparedPhase(a, 1, b).state == nullptr);
    QVERIFY(comparedPhase(a, 2, b).state == nullptr);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::ComparedPhaseTest)
#include "compared_phase_test.moc"
