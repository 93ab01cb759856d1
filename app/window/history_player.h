// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <functional>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "ui/models/playhead.h"

namespace planewright {

/// Plays the history of a scan: moves the playhead as the slices came, faster or slower.
///
/// It goes round in the playhead's loop, and otherwise stops at the newest step, which it then follows.
class HistoryPlayer : public QObject {
    Q_OBJECT

public:
    /// `lasts` tells how long the scan took from a place to the next.
    HistoryPlayer(Playhead& playhead, std::function<std::chrono::microseconds(int place)> lasts,
                  QObject* parent = nullptr);

    bool isPlaying() const { return timer_.isActive(); }
    /// From the beginning where it is at the end; nothing happens without two places.
    void play();
    void pause();
    /// 1 is the time that the scan took.
    void setSpeed(double speed) { speed_ = speed; }

    /// Goes on by a time of the scan.
    void goOn(std::chrono::microseconds time);

signals:
    void playingChanged(bool plays);

private:
    int lastPlace() const { return static_cast<int>(playhead_.history().size()) - 1; }

    Playhead& playhead_;
    std::function<std::chrono::microseconds(int)> lasts_;
    double speed_ = 1.0;
    std::chrono::microseconds spent_{0};  ///< at the place of now
    QElapsedTimer clock_;
    QTimer timer_;
};

}  // namespace planewright
