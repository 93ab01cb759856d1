// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <vector>

#include "core/types/snapshot.h"
#include "ui/common/filled_outline.h"

namespace planewright {

/// Works out planes' outlines on a thread of its own: one may take a tenth of a second, and nothing waits for it.
class OutlineMaker {
public:
    /// `onMore` is called on that thread: there are more outlines than the last time it was called.
    explicit OutlineMaker(std::function<void()> onMore);
    ~OutlineMaker();

    /// These planes' outlines are wanted, and no others; the newest call wins. Planes without any come first, then
    /// those whose outline is oldest.
    void want(std::vector<std::shared_ptr<const Plane>> planes, std::shared_ptr<const Snapshot> snapshot);

    /// The outline of a plane, or of what the plane was before; null where there is none yet.
    std::shared_ptr<const FilledOutline> outlineOf(const Plane& plane) const;

    /// True until all that is wanted is there and onMore() has returned.
    bool isBusy() const;

private:
    using SharedPlane = std::shared_ptr<const Plane>;
    struct Known {
        SharedPlane plane;  ///< keeps the address from being used again
        std::shared_ptr<const FilledOutline> outline;
    };

    void run(const std::stop_token& stop);
    SharedPlane next();

    std::function<void()> onMore_;
    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::vector<SharedPlane> wanted_;
    std::shared_ptr<const Snapshot> snapshot_;
    bool busy_ = false;
    std::unordered_map<const Plane*, Known> known_;
    std::unordered_map<PlaneId, std::shared_ptr<const FilledOutline>> lastOfId_;
    std::jthread thread_;  // last: it uses all the others
};

}  // namespace planewright
