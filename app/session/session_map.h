// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/loops/scan_item.h"
#include "core/geometry/sensor_model.h"
#include "core/types/snapshot.h"

namespace planewright {

/// A scan at one moment, before anybody edits its planes: immutable, shared, and sharing with the moment before.
struct SessionMap {
    std::shared_ptr<const Snapshot> snapshot;  ///< null before the first step
    std::vector<SharedSlice> slices;           ///< up to the snapshot's step, corrected by `sensor.*`
    SensorModel sensor;                        ///< of these slices
    int step = -1;                             ///< the newest slice's; −1 before the first
    int plannedSteps = 0;                      ///< 0 where nobody knows
    bool finished = false;                     ///< the forced last pass has been made
    bool isNewest = true;                      ///< false where somebody went back to a step
};

/// How a session goes on, for the status bar.
struct SessionStatus {
    std::string source;                            ///< name of the scanner or the file; empty without one
    double slicesPerSecond = 0.0;                  ///< 0 where no slices come
    std::size_t queueDepth = 0;                    ///< slices that wait to be recorded or extracted
    std::chrono::nanoseconds stepTime{0};          ///< of the last step
    int acquired = 0;                              ///< slices of this scan so far
    int extracted = 0;                             ///< of these, worked in
    int plannedSteps = 0;                          ///< 0 where nobody knows
    std::chrono::duration<double> plannedTime{0};  ///< of a scan with devices, at least; 0 where nobody knows
    int lost = 0;                                  ///< steps that were passed over
    std::string recording;                         ///< path of the file; empty where nothing is recorded
    std::uint64_t recordedBytes = 0;               ///< on the disk
    std::optional<std::uint64_t> freeBytes;        ///< what there is room for
    std::size_t notOnDisk = 0;                     ///< slices that are held in memory because writing fails
};

/// How loud a line of the log is.
enum class LogLevel { Info, Warning, Error };

}  // namespace planewright
