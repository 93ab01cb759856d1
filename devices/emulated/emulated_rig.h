// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/simulation/scene.h"
#include "core/simulation/simulation_noise.h"
#include "core/types/angle.h"
#include "devices/emulated/emulated_device.h"
#include "devices/emulated/emulated_laser.h"
#include "devices/tilt_unit.h"

namespace planewright {

/// What a rig of emulated devices is made of.
struct EmulatedRigSetup {
    /// What tilts the laser.
    enum class Tilt {
        None,   ///< nothing: it looks straight ahead
        Servo,  ///< a Dynamixel servo
        Board,  ///< a control board
    };
    Scene scene;
    SimulationNoise noise;
    std::uint64_t seed = 1;                ///< of the errors of ranges, and of faults at random
    std::string laserModel = "UTM-30LX";   ///< a name of emulatedLaserModel()
    std::string laserSerial = "00000001";  ///< SERI
    Tilt tilt = Tilt::Servo;
    std::uint16_t servoModel = 64;  ///< RX-64
    int baud = 57'142;              ///< of the servo's bus [1/s]
    /// The middle of its way looks level; it may go all the way round, as fast as it can.
    TiltMounting mounting{degrees(90.0), 1.0, 1.0, degrees(-60.0), degrees(240.0), degrees(360.0)};
    double startPitch = degrees(90.0);  ///< φ at the beginning [rad]
    std::vector<FaultAt> faults;        ///< of emulatedFaultKinds()
};

/// A laser and what tilts it in one room: each is where the other says that it is.
class EmulatedRig {
public:
    /// Errors (Usage): a model or a fault that there is not; a fault of a device that the rig has not.
    static Result<std::unique_ptr<EmulatedRig>> make(const EmulatedRigSetup& setup);

    std::shared_ptr<EmulatedLaser> laser() const { return laser_; }
    /// The servo or board; null without.
    std::shared_ptr<EmulatedDevice> tilt() const { return tilt_; }
    /// Held by whoever calls a device, where several threads do.
    std::shared_ptr<std::mutex> mutex() const { return mutex_; }
    /// True φ of the laser at a moment that has come [rad].
    double pitchAt(std::chrono::nanoseconds at) const { return pitchAt_(at); }

private:
    std::shared_ptr<EmulatedLaser> laser_;
    std::shared_ptr<EmulatedDevice> tilt_;
    std::function<double(std::chrono::nanoseconds)> pitchAt_;
    std::shared_ptr<std::mutex> mutex_ = std::make_shared<std::mutex>();
};

/// A fault that an emulated device can have: its name and a sentence.
struct EmulatedFaultKind {
    std::string_view name;
    std::string_view sentence;
};
/// All of them: laser-…, servo-… and board-….
std::vector<EmulatedFaultKind> emulatedFaultKinds();

/// Reads "KIND@STEP", or "KIND" for step 0. Errors (Usage): no such kind, with those known; a step that is none.
Result<FaultAt> parseFaultAt(const std::string& text);

}  // namespace planewright
