// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <QTimer>

namespace planewright {

/// Turns the keys W A S D Q E that are held into walking: forward, left, back, right, down, up.
class WalkKeys : public QObject {
    Q_OBJECT

public:
    explicit WalkKeys(QObject* parent = nullptr);

    /// True where the key is one of these; walking then goes on until it is released.
    bool press(int key);
    void release(int key);
    void releaseAll();

signals:
    /// Metres to the right, ahead and up since the last time.
    void walked(double right, double ahead, double up);

private:
    void step();

    QSet<int> held_;
    QTimer timer_;
    QElapsedTimer clock_;
};

}  // namespace planewright
