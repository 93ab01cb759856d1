// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "app/session/loops/scan_item.h"
#include "core/types/snapshot.h"

namespace planewright {

/// What a step of the extraction leaves behind, all of it shared.
struct ExtractedStep {
    SharedSlice measured;  ///< null for the forced last pass
    SharedSlice slice;     ///< the same with `sensor.*` corrected
    std::shared_ptr<const Snapshot> snapshot;
    std::shared_ptr<const Parameters> parameters = nullptr;  ///< in force; another object where they were set anew
};

/// From the extractor to the window, which is slower: it hears once that there is news and takes what has come by then.
/// It may skip all snapshots but the newest; it gets every slice. Nobody waits for anybody.
class SnapshotBridge {
public:
    /// `onNews` is called by the thread that publishes, when there was nothing to be taken before.
    explicit SnapshotBridge(std::function<void()> onNews) : onNews_(std::move(onNews)) {}

    void publish(ExtractedStep step)
    {
        bool isNews = false;
        {
            const std::lock_guard lock{mutex_};
            isNews = steps_.empty();
            steps_.push_back(std::move(step));
        }
        if (isNews && onNews_)
            onNews_();
    }

    /// All steps since it was called last, in their order; the newest snapshot is the last one's.
    std::vector<ExtractedStep> take()
    {
        const std::lock_guard lock{mutex_};
        return std::exchange(steps_, {});
    }

private:
    std::function<void()> onNews_;
    std::mutex mutex_;
    std::vector<ExtractedStep> steps_;
};

}  // namespace planewright
