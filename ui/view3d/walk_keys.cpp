// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ui/view3d/walk_keys.h"

#include <algorithm>
#include <array>

namespace planewright {

namespace {

constexpr int kMilliseconds = 16;
constexpr double kSpeed = 2.0;  // [m/s]

}  // namespace

WalkKeys::WalkKeys(QObject* parent) : QObject(parent)
{
    timer_.setInterval(kMilliseconds);
    connect(&timer_, &QTimer::timeout, this, &WalkKeys::step);
}

bool WalkKeys::press(int key)
{
    constexpr std::array<int, 6> kKeys{Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E};
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
        return false;
    if (held_.isEmpty()) {
        clock_.start();
        timer_.start();
    }
    held_.insert(key);
    return true;
}

void WalkKeys::release(int key)
{
    held_.remove(key);
    if (held_.isEmpty())
        timer_.stop();
}

void WalkKeys::releaseAll()
{
    held_.clear();
    timer_.stop();
}

void WalkKeys::step()
{
    const double way = kSpeed * static_cast<double>(clock_.restart()) / 1000.0;
    const auto along = [this, way](int plus, int minus) {
        return way * ((held_.contains(plus) ? 1.0 : 0.0) - (held_.contains(minus) ? 1.0 : 0.0));
    };
    emit walked(along(Qt::Key_D, Qt::Key_A), along(Qt::Key_W, Qt::Key_S), along(Qt::Key_E, Qt::Key_Q));
}

}  // namespace planewright
