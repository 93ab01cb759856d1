// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/history_player.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

constexpr std::chrono::milliseconds kPlayEvery{16};

}  // namespace

HistoryPlayer::HistoryPlayer(Playhead& playhead, std::function<std::chrono::microseconds(int place)> lasts,
                             QObject* parent)
    : QObject(parent), playhead_(playhead), lasts_(std::move(lasts))
{
    timer_.setInterval(kPlayEvery);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, [this] {
        const auto real = std::chrono::nanoseconds(clock_.nsecsElapsed());
        clock_.restart();
        goOn(std::chrono::duration_cast<std::chrono::microseconds>(real * speed_));
    });
}

void HistoryPlayer::play()
{
    const int last = lastPlace();
    if (isPlaying() || last < 1)
        return;
    const auto loop = playhead_.loop();
    const int from = loop ? loop->first : 0;
    const int to = loop ? std::min(loop->second, last) : last;
    if (playhead_.place() < from || playhead_.place() >= to)
        playhead_.goTo(from);
    spent_ = std::chrono::microseconds(0);
    clock_.start();
    timer_.start();
    emit playingChanged(true);
}

void HistoryPlayer::pause()
{
    if (!isPlaying())
        return;
    timer_.stop();
    emit playingChanged(false);
}

void HistoryPlayer::goOn(std::chrono::microseconds time)
{
    constexpr std::chrono::microseconds kLeast{100};  // so that no range takes no time at all
    const int last = lastPlace();
    const auto loop = playhead_.loop();
    int place = playhead_.place();
    if (place < 0) {
        pause();
        return;
    }
    spent_ += time;
    while (true) {
        const bool turns = loop && place >= std::min(loop->second, last);
        if (place >= last && !turns) {
            playhead_.follow();
            pause();
            return;
        }
        const auto due = std::max(lasts_(place), kLeast);
        if (spent_ < due)
            break;
        spent_ -= due;
        place = turns ? std::min(loop->first, last) : place + 1;
    }
    if (place != playhead_.place())
        playhead_.goTo(place);
}

}  // namespace planewright
