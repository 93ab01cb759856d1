// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/emulated/emulated_rig.h"

#include <algorithm>
#include <charconv>

#include "devices/emulated/emulated_board.h"
#include "devices/emulated/emulated_laser_faults.h"
#include "devices/emulated/emulated_servo.h"
#include "devices/emulated/emulated_view.h"

namespace planewright {

namespace {

using Time = std::chrono::nanoseconds;

std::vector<FaultAt> faultsOf(const EmulatedRigSetup& setup, std::string_view device)
{
    std::vector<FaultAt> faults;
    std::copy_if(setup.faults.begin(), setup.faults.end(), std::back_inserter(faults),
                 [&](const FaultAt& fault) { return fault.kind.starts_with(device); });
    return faults;
}

/// Errors (Usage): a fault of a device that is not there does nothing, which its user would wait for in vain.
Result<void> checkFaults(const EmulatedRigSetup& setup)
{
    const std::string_view tilt = setup.tilt == EmulatedRigSetup::Tilt::Servo   ? "servo-"
                                  : setup.tilt == EmulatedRigSetup::Tilt::Board ? "board-"
                                                                                : "laser-";
    for (const FaultAt& fault : setup.faults) {
        if (!fault.kind.starts_with("laser-") && !fault.kind.starts_with(tilt))
            return fail(ErrorCode::Usage, fault.kind + ": the device that would have this fault is not emulated");
    }
    return {};
}

}  // namespace

Result<std::unique_ptr<EmulatedRig>> EmulatedRig::make(const EmulatedRigSetup& setup)
{
    if (const Result<void> checked = checkFaults(setup); !checked)
        return tl::unexpected{checked.error()};
    const Result<EmulatedLaserModel> model = emulatedLaserModel(setup.laserModel);
    if (!model)
        return tl::unexpected{model.error()};
    auto rig = std::make_unique<EmulatedRig>();
    EmulatedLaserOptions options;
    options.model = *model;
    options.serial = setup.laserSerial;
    options.seed = setup.seed;
    options.faults = faultsOf(setup, "laser-");
    // The laser asks where it is; what tilts it asks how often the laser has turned.
    EmulatedRig* const self = rig.get();
    auto laser = EmulatedLaser::make(
        std::make_shared<EmulatedView>(setup.scene, setup.noise, setup.seed),
        [self](Time at) { return self->pitchAt_(at); }, options);
    if (!laser)
        return tl::unexpected{laser.error()};
    rig->laser_ = std::move(*laser);

    if (setup.tilt == EmulatedRigSetup::Tilt::None) {
        rig->pitchAt_ = [pitch = setup.startPitch](Time /*at*/) { return pitch; };
    } else if (setup.tilt == EmulatedRigSetup::Tilt::Servo) {
        EmulatedServoSettings settings;
        settings.model = setup.servoModel;
        settings.baud = setup.baud;
        settings.mounting = setup.mounting;
        settings.pitch = setup.startPitch;
        settings.seed = setup.seed;
        auto servo = EmulatedServo::make(settings, faultsOf(setup, "servo-"),
                                         [self](Time now) { return self->laser_->turns(now); });
        if (!servo)
            return tl::unexpected{servo.error()};
        rig->pitchAt_ = [bus = servo->get()](Time at) { return bus->pitchAt(at); };
        rig->tilt_ = std::move(*servo);
    } else {
        EmulatedBoardSetup board;
        board.mounting = setup.mounting;
        board.startPitch = setup.startPitch;
        board.nextEdge = edgesEvery(rig->laser_->period(), options.phase);
        board.faults = faultsOf(setup, "board-");
        board.turns = [self](Time now) { return self->laser_->turns(now); };
        board.seed = setup.seed;
        auto made = EmulatedBoard::make(board);
        if (!made)
            return tl::unexpected{made.error()};
        rig->pitchAt_ = [firmware = made->get()](Time at) { return firmware->pitchAt(at); };
        rig->tilt_ = std::move(*made);
    }
    return rig;
}

std::vector<EmulatedFaultKind> emulatedFaultKinds()
{
    std::vector<EmulatedFaultKind> kinds;
    for (const LaserFaultKind& fault : laserFaultKinds())
        kinds.push_back({fault.name, fault.sentence});
    for (const ServoFaultKind& fault : servoFaultKinds())
        kinds.push_back({fault.kind, fault.sentence});
    for (const BoardFaultKind& fault : boardFaultKinds())
        kinds.push_back({fault.kind, fault.sentence});
    return kinds;
}

Result<FaultAt> parseFaultAt(const std::string& text)
{
    const std::size_t at = text.find('@');
    FaultAt fault{text.substr(0, at), 0};
    const std::vector<EmulatedFaultKind> kinds = emulatedFaultKinds();
    if (std::none_of(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.name == fault.kind; })) {
        std::string known;
        for (const EmulatedFaultKind& kind : kinds)
            known += (known.empty() ? "" : ", ") + std::string(kind.name);
        return fail(ErrorCode::Usage, "'" + fault.kind + "' is no fault; there are " + known);
    }
    if (at == std::string::npos)
        return fault;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data() + at + 1, end, fault.step);
    if (error != std::errc{} || stopped != end || fault.step < 0)
        return fail(ErrorCode::Usage,
                    "'" + text + "': behind the @ comes a number of turns of the mirror, as in " + fault.kind + "@40");
    return fault;
}

}  // namespace planewright
