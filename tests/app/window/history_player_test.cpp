// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/history_player.h"

#include <QSignalSpy>
#include <QtTest>

#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class HistoryPlayerTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void stepsLastAsLongAsTheyDid();
    void manyStepsMayPassAtOnce();
    void theEndIsFollowed();
    void aLoopIsGoneRound();
    void playingBeginsAnewAtTheEnd();
    void playingBeginsInTheLoop();
    void oneStepIsNotPlayed();

private:
    std::unique_ptr<Playhead> playhead_;
    std::unique_ptr<HistoryPlayer> player_;
};

/// Six places, of which the third lasts 100 ms and the others 25 ms.
void HistoryPlayerTest::init()
{
    player_.reset();
    playhead_ = std::make_unique<Playhead>();
    Playhead::History history;
    for (int step = 0; step < 6; ++step) {
        auto snapshot = std::make_shared<Snapshot>();
        snapshot->report.step = step;
        history.push_back(std::move(snapshot));
    }
    playhead_->setHistory(std::move(history), 6);
    player_ = std::make_unique<HistoryPlayer>(
        *playhead_, [](int place) { return std::chrono::microseconds(place == 2 ? 100'000 : 25'000); });
}

void HistoryPlayerTest::stepsLastAsLongAsTheyDid()
{
    playhead_->goTo(0);

    player_->goOn(24ms);
    QCOMPARE(playhead_->place(), 0);
    player_->goOn(1ms);
    QCOMPARE(playhead_->place(), 1);
    player_->goOn(25ms);
    QCOMPARE(playhead_->place(), 2);
    player_->goOn(99ms);
    QCOMPARE(playhead_->place(), 2);
    player_->goOn(1ms);
    QCOMPARE(playhead_->place(), 3);
}

void HistoryPlayerTest::manyStepsMayPassAtOnce()
{
    playhead_->goTo(0);
    QSignalSpy places(playhead_.get(), &Playhead::placeChanged);

    player_->goOn(160ms);  // 25 + 25 + 100, and 10 of the fourth

    QCOMPARE(playhead_->place(), 3);
    QCOMPARE(places.size(), 1);
    player_->goOn(15ms);
    QCOMPARE(playhead_->place(), 4);
}

void HistoryPlayerTest::theEndIsFollowed()
{
    playhead_->goTo(0);
    player_->play();
    QVERIFY(player_->isPlaying());

    player_->goOn(10s);

    QCOMPARE(playhead_->place(), 5);
    QVERIFY(playhead_->followsNewest());
    QVERIFY(!player_->isPlaying());
}

void HistoryPlayerTest::aLoopIsGoneRound()
{
    playhead_->setLoop(std::pair(3, 5));
    playhead_->goTo(3);

    player_->goOn(50ms);
    QCOMPARE(playhead_->place(), 5);
    player_->goOn(25ms);
    QCOMPARE(playhead_->place(), 3);
    player_->goOn(75ms * 10 + 25ms);
    QCOMPARE(playhead_->place(), 4);
    QVERIFY(!playhead_->followsNewest());
}

void HistoryPlayerTest::playingBeginsAnewAtTheEnd()
{
    QSignalSpy playing(player_.get(), &HistoryPlayer::playingChanged);

    player_->play();
    QCOMPARE(playhead_->place(), 0);
    player_->pause();
    playhead_->goTo(2);
    player_->play();

    QCOMPARE(playhead_->place(), 2);
    QCOMPARE(playing.size(), 3);
}

void HistoryPlayerTest::playingBeginsInTheLoop()
{
    playhead_->setLoop(std::pair(2, 4));
    playhead_->goTo(0);

    player_->play();

    QCOMPARE(playhead_->place(), 2);
}

void HistoryPlayerTest::oneStepIsNotPlayed()
{
    playhead_->setHistory({playhead_->history().front()}, 1);

    player_->play();

    QVERIFY(!player_->isPlaying());
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::HistoryPlayerTest)
#include "history_player_test.moc"
