// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/outline_maker.h"

#include <algorithm>
#include <chrono>
#include <sys/resource.h>
#include <unordered_set>
#include <utility>

namespace planewright {

namespace {

/// Outlines are told of together where they come faster than this.
constexpr std::chrono::milliseconds kTellEvery{60};

}  // namespace

OutlineMaker::OutlineMaker(std::function<void()> onMore)
    : onMore_(std::move(onMore)), thread_([this](const std::stop_token& stop) { run(stop); })
{
}

OutlineMaker::~OutlineMaker()
{
    thread_.request_stop();
    thread_.join();
}

void OutlineMaker::want(std::vector<SharedPlane> planes, std::shared_ptr<const Snapshot> snapshot)
{
    {
        const std::lock_guard lock(mutex_);
        std::unordered_set<const Plane*> wanted;
        std::unordered_set<PlaneId> ids;
        for (const SharedPlane& plane : planes) {
            wanted.insert(plane.get());
            ids.insert(plane->id);
        }
        std::erase_if(known_, [&](const auto& entry) { return !wanted.contains(entry.first); });
        std::erase_if(lastOfId_, [&](const auto& entry) { return !ids.contains(entry.first); });
        wanted_ = std::move(planes);
        snapshot_ = std::move(snapshot);
    }
    wake_.notify_one();
}

std::shared_ptr<const FilledOutline> OutlineMaker::outlineOf(const Plane& plane) const
{
    const std::lock_guard lock(mutex_);
    if (const auto found = known_.find(&plane); found != known_.end())
        return found->second.outline;
    const auto last = lastOfId_.find(plane.id);
    return last != lastOfId_.end() ? last->second : nullptr;
}

bool OutlineMaker::isBusy() const
{
    const std::lock_guard lock(mutex_);
    return busy_ || !wanted_.empty();
}

/// The plane that has waited longest; null where none is left. Called with the lock held.
OutlineMaker::SharedPlane OutlineMaker::next()
{
    std::erase_if(wanted_, [this](const SharedPlane& plane) { return known_.contains(plane.get()); });
    const auto age = [this](const SharedPlane& plane) {
        const auto last = lastOfId_.find(plane->id);
        return last != lastOfId_.end() ? last->second->revision : 0;
    };
    const auto oldest = std::min_element(wanted_.begin(), wanted_.end(),
                                         [&](const SharedPlane& a, const SharedPlane& b) { return age(a) < age(b); });
    return oldest != wanted_.end() ? *oldest : nullptr;
}

void OutlineMaker::run(const std::stop_token& stop)
{
    // Linux has a niceness for each thread: what is scanned and drawn goes first where processors are few.
    constexpr int kNice = 15;
    setpriority(PRIO_PROCESS, 0, kNice);
    auto toldAt = std::chrono::steady_clock::now();
    bool hasMore = false;
    while (true) {
        SharedPlane plane;
        std::shared_ptr<const Snapshot> snapshot;
        {
            std::unique_lock lock(mutex_);
            plane = next();
            snapshot = snapshot_;
            busy_ = plane != nullptr || hasMore;
        }
        const auto now = std::chrono::steady_clock::now();
        if (hasMore && (plane == nullptr || now - toldAt > kTellEvery)) {
            hasMore = false;
            toldAt = now;
            onMore_();
        }
        if (plane == nullptr) {
            std::unique_lock lock(mutex_);
            busy_ = false;
            if (!wake_.wait(lock, stop, [this] { return !wanted_.empty(); }))
                return;
            busy_ = true;
            continue;
        }
        if (stop.stop_requested())
            return;
        auto outline = filledOutlineOf(*plane, snapshot->segments);
        const std::lock_guard lock(mutex_);
        hasMore = true;
        lastOfId_[plane->id] = outline;
        known_[plane.get()] = {plane, std::move(outline)};
    }
}

}  // namespace planewright
