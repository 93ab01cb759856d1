// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/models/playhead.h"

#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

class PlayheadTest : public QObject {
    Q_OBJECT

private slots:
    void itFollowsTheNewestStep();
    void whoLooksBackStays();
    void anotherScanBeginsAnew();
    void aScanOfAsManyStepsIsAnother();
    void stepsHavePlaces();
    void phasesAreOfOneStep();
    void loopsAndBookmarksAreKept();
};

namespace {

/// Steps 0, 2, 4, … and perhaps the forced last pass.
Playhead::History evenSteps(int count, bool lastPass = false)
{
    Playhead::History history;
    for (int place = 0; place < count + (lastPass ? 1 : 0); ++place) {
        auto snapshot = std::make_shared<Snapshot>();
        snapshot->report.step = place < count ? 2 * place : -1;
        history.push_back(std::move(snapshot));
    }
    return history;
}

Playhead::History grown(Playhead::History history, int by)
{
    for (const auto& more : evenSteps(by))
        history.push_back(more);
    return history;
}

}  // namespace

void PlayheadTest::itFollowsTheNewestStep()
{
    Playhead playhead;
    QCOMPARE(playhead.place(), -1);
    QVERIFY(playhead.snapshot() == nullptr);
    const Playhead::History history = evenSteps(3);
    playhead.setHistory(history, 10);
    QCOMPARE(playhead.place(), 2);
    QVERIFY(playhead.followsNewest());
    playhead.setHistory(grown(history, 2), 10);
    QCOMPARE(playhead.place(), 4);
    QCOMPARE(playhead.planned(), 10);
}

void PlayheadTest::whoLooksBackStays()
{
    Playhead playhead;
    const Playhead::History history = evenSteps(5);
    playhead.setHistory(history, 0);
    QSignalSpy places(&playhead, &Playhead::placeChanged);
    playhead.goTo(1);
    QVERIFY(!playhead.followsNewest());
    QCOMPARE(playhead.snapshot(), history[1]);
    playhead.setHistory(grown(history, 3), 0);
    QCOMPARE(playhead.place(), 1);
    QCOMPARE(places.count(), 1);
    playhead.goTo(101);
    QCOMPARE(playhead.place(), 7);
    QVERIFY(!playhead.followsNewest());
    playhead.goTo(-93);
    QCOMPARE(playhead.place(), 0);
    playhead.follow();
    QCOMPARE(playhead.place(), 7);
    QVERIFY(playhead.followsNewest());
}

void PlayheadTest::anotherScanBeginsAnew()
{
    Playhead playhead;
    playhead.setHistory(evenSteps(5), 0);
    playhead.goTo(1);
    playhead.setLoop(std::pair(1, 2));
    playhead.toggleBookmark(3);
    playhead.setHistory(evenSteps(4), 0);
    QCOMPARE(playhead.place(), 3);
    QVERIFY(playhead.followsNewest());
    QVERIFY(!playhead.loop());
    QVERIFY(playhead.bookmarks().empty());
    playhead.setHistory({}, 0);
    QCOMPARE(playhead.place(), -1);
}

void PlayheadTest::aScanOfAsManyStepsIsAnother()
{
    Playhead playhead;
    playhead.setHistory(evenSteps(5), 0);
    playhead.showPhase(1);
    QSignalSpy places(&playhead, &Playhead::placeChanged);
    std::shared_ptr<const Snapshot> seen;
    connect(&playhead, &Playhead::historyChanged, this, [&] { seen = playhead.snapshot(); });
    const Playhead::History again = evenSteps(5);
    playhead.setHistory(again, 0);
    QCOMPARE(places.count(), 1);
    QCOMPARE(places[0][0].toInt(), 4);
    QCOMPARE(seen, again[4]);
    QVERIFY(!playhead.phase());
    playhead.setHistory(evenSteps(2), 0);
    QCOMPARE(playhead.place(), 1);
    QVERIFY(seen != nullptr);
    playhead.setHistory({}, 0);
    QVERIFY(seen == nullptr);
    QCOMPARE(places.count(), 3);
}

void PlayheadTest::stepsHavePlaces()
{
    Playhead playhead;
    playhead.setHistory(evenSteps(3, true), 3);
    QCOMPARE(playhead.placeOf(0), 0);
    QCOMPARE(playhead.placeOf(3), 1);  // it was lost: step 2 is the last one before it
    QCOMPARE(playhead.placeOf(4), 2);
    QCOMPARE(playhead.placeOf(9), 2);
    QCOMPARE(playhead.placeOf(-7), -1);
}

void PlayheadTest::phasesAreOfOneStep()
{
    Playhead playhead;
    playhead.setHistory(evenSteps(3), 0);
    QSignalSpy phases(&playhead, &Playhead::phaseChanged);
    playhead.showPhase(2);
    QCOMPARE(playhead.phase(), std::optional<std::size_t>(2));
    playhead.goTo(0);
    QVERIFY(!playhead.phase());
    QCOMPARE(phases.count(), 2);
}

void PlayheadTest::loopsAndBookmarksAreKept()
{
    Playhead playhead;
    const Playhead::History history = evenSteps(5);
    playhead.setHistory(history, 0);
    playhead.setLoop(std::pair(4, 2));
    QCOMPARE(playhead.loop(), std::optional(std::pair(2, 4)));
    playhead.toggleBookmark(1);
    playhead.toggleBookmark(3);
    playhead.toggleBookmark(1);
    playhead.setHistory(grown(history, 1), 0);
    QCOMPARE(playhead.bookmarks(), std::set<int>{3});
    QCOMPARE(playhead.loop(), std::optional(std::pair(2, 4)));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::PlayheadTest)
#include "playhead_test.moc"
