// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>

#include "core/simulation/acquisition_settings.h"
#include "core/simulation/scene.h"
#include "core/simulation/simulation_noise.h"
#include "devices/pacer.h"
#include "devices/scan_source.h"

namespace planewright {

/// What a simulated scanner is set up with.
struct SimulatedScanner {
    AcquisitionSettings settings;
    SimulationNoise noise;
    std::uint64_t seed = 1;
    double speed = 1.0;  ///< 1 is real time, by the settings' time of a slice; 0 as fast as possible
};

/// A nodding scanner in a room of known planes. Its slices are those of simulate(), whatever the pace.
class SimulatedRoom : public ScanSource {
public:
    /// A speed that isReplaySpeed refuses is taken as real time.
    SimulatedRoom(Scene scene, const SimulatedScanner& scanner, const Clock& clock);

    const ScanDescription& description() const override { return description_; }
    std::optional<int> plannedSlices() const override { return scanner_.settings.slices; }
    bool isLive() const override { return true; }
    std::string name() const override { return "Simulated " + scene_.name; }

    Result<void> begin(const std::stop_token& stop) override;
    Result<std::optional<ScanSlice>> next(const std::stop_token& stop) override;
    Result<void> pause() override;
    Result<void> resume() override;
    Result<void> step() override { return pacer_.step(); }
    Result<void> setSpeed(double speed) override { return pacer_.setSpeed(speed); }
    Result<void> stopMotion() override;

private:
    Scene scene_;
    SimulatedScanner scanner_;
    ScanDescription description_;
    Pacer pacer_;
    int next_ = 0;
};

}  // namespace planewright
