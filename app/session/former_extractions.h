// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "app/session/scan_history.h"

namespace planewright {

/// The extractions of a scan that re-runs took the place of, and those that were taken back: the last eight.
class FormerExtractions {
public:
    /// Keeps the present extraction, and shows the next in its place. None is made again after that.
    void replace(ScanHistory& present, ScanHistory next);
    /// Exchanges the present extraction for the one before it, or for the one that was taken back last. False without
    /// one.
    bool takeBack(ScanHistory& present) { return exchange(present, former_, takenBack_); }
    bool makeAgain(ScanHistory& present) { return exchange(present, takenBack_, former_); }
    void clear();

    /// How many there are to go back to.
    std::size_t size() const { return former_.size(); }

private:
    using Stack = std::vector<ScanHistory>;

    static bool exchange(ScanHistory& present, Stack& from, Stack& to);

    Stack former_;     ///< the last one is last
    Stack takenBack_;  ///< the next to be made again is last
};

}  // namespace planewright
