// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/device_search.h"

#include <utility>

namespace planewright {

namespace {

constexpr int kAfterPlugging = 500;  // [ms]

}  // namespace

DeviceSearch::DeviceSearch(Find find, QObject* parent) : QObject(parent), find_(std::move(find))
{
    changed_.setSingleShot(true);
    changed_.setInterval(kAfterPlugging);
    connect(&changed_, &QTimer::timeout, this, [this] { start(false); });
}

DeviceSearch::~DeviceSearch()
{
    stop_.request_stop();
}

void DeviceSearch::noteChange()
{
    // Begun anew with each change it would never run out in a storm of them.
    if (!changed_.isActive())
        changed_.start();
}

void DeviceSearch::start(bool asks)
{
    isWanted_ = true;
    asks_ = asks_ || asks;
    next();
}

void DeviceSearch::setHeld(bool held)
{
    isHeld_ = held;
    next();
}

void DeviceSearch::next()
{
    if (!isWanted_ || isHeld_ || work_.isBusy())
        return;
    isWanted_ = false;
    work_.start<FoundDevices>([find = find_, asks = std::exchange(asks_, false), known = known_,
                               stop = stop_.get_token()] { return find(asks, known, stop); },
                              [this](FoundDevices& devices) {
                                  known_ = withAsked(std::move(known_), devices);
                                  emit found(devices);
                                  next();
                              });
    emit begun();
}

}  // namespace planewright
