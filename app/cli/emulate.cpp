// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/number_option.h"
#include "app/cli/signal_watch.h"
#include "app/sources/open_source.h"
#include "devices/emulated/device_server.h"
#include "devices/emulated/emulated_rig.h"
#include "devices/emulated/servo_kind.h"

namespace planewright {

namespace {

struct EmulateOptions {
    std::string room = "corridor";
    std::uint64_t seed = 1;
    std::string laser;
    std::string tilt;
    std::string board;
    std::string model = "UTM-30LX";
    std::string serial = "00000001";
    std::string servo;  ///< empty: RX-64
    int baud = 0;       ///< of the servo's bus; 0: that of a new RX
    std::vector<std::string> faults;
};

/// "RX-64, AX-12, MX-28 and XM430-W350".
std::string namesOf(std::span<const EmulatedServoKind> kinds)
{
    std::string text;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        text += (i == 0 ? "" : i + 1 == kinds.size() ? " and " : ", ") + std::string{kinds[i].name};
    return text;
}

/// The servo as it comes from its maker, or what the options say. Errors (Usage).
Result<void> takeServo(const EmulateOptions& options, EmulatedRigSetup& setup)
{
    if (options.tilt.empty() && (!options.servo.empty() || options.baud != 0))
        return fail(ErrorCode::Usage, "--servo, --baud: there is no servo without --tilt; give it, or leave them out");
    const std::span<const EmulatedServoKind> kinds = emulatedServoKinds();
    if (!options.servo.empty()) {
        const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                       [&](const EmulatedServoKind& known) { return known.name == options.servo; });
        if (kind == kinds.end())
            return fail(ErrorCode::Usage,
                        "--servo: '" + options.servo + "' cannot be emulated. Known: " + namesOf(kinds));
        setup.servoModel = kind->model;
    }
    if (options.baud != 0)
        setup.baud = options.baud;
    return {};
}

Result<EmulatedRigSetup> setupOf(const EmulateOptions& options)
{
    if (options.laser.empty() && options.tilt.empty() && options.board.empty())
        return fail(ErrorCode::Usage, "give --laser, --tilt or --board: what is emulated, and where it is served");
    if (!options.tilt.empty() && !options.board.empty())
        return fail(ErrorCode::Usage, "--tilt, --board: one laser is tilted by one of them; leave the other out");
    EmulatedRigSetup setup;
    Result<Scene> scene = makeScene(options.room, options.seed);
    if (!scene)
        return fail(scene.error().code, "--room: " + scene.error().message);
    setup.scene = std::move(*scene);
    setup.noise = defaultSimulationNoise();
    setup.noise.pitch = 0.0;  // the servo brings its own errors
    setup.seed = options.seed;
    setup.laserModel = options.model;
    setup.laserSerial = options.serial;
    setup.tilt = !options.board.empty()  ? EmulatedRigSetup::Tilt::Board
                 : !options.tilt.empty() ? EmulatedRigSetup::Tilt::Servo
                                         : EmulatedRigSetup::Tilt::None;
    if (const Result<void> servo = takeServo(options, setup); !servo)
        return tl::unexpected{servo.error()};
    for (const std::string& text : options.faults) {
        const Result<FaultAt> fault = parseFaultAt(text);
        if (!fault)
            return fail(fault.error().code, "--fault: " + fault.error().message);
        setup.faults.push_back(*fault);
    }
    return setup;
}

/// Where a device is served, as the address that opens it: `unit` before the link, `options` behind it.
Result<std::string> serve(DeviceServer& server, EmulatedDevice& device, const std::string& where,
                          const std::string& unit, const std::string& options)
{
    const Result<std::string> address = server.add(device, where);
    if (!address)
        return address;
    return unit + *address + options + "\n";
}

Result<ExitCode> emulate(const EmulateOptions& options)
{
    const auto setup = setupOf(options);
    if (!setup)
        return tl::unexpected{setup.error()};
    const auto rig = EmulatedRig::make(*setup);
    if (!rig)
        return tl::unexpected{rig.error()};

    const SignalWatch signals;
    DeviceServer server;
    std::string addresses;
    struct Place {
        const std::string& where;
        EmulatedDevice* device;
        const char* unit;
        std::string options;
    };
    const std::string rate = options.baud == 0 ? "" : "?baud=" + std::to_string(options.baud);
    for (const Place& place : {Place{options.laser, (*rig)->laser().get(), "", ""},
                               Place{options.tilt, (*rig)->tilt().get(), "dynamixel:", rate},
                               Place{options.board, (*rig)->tilt().get(), "board:", ""}}) {
        if (place.where.empty())
            continue;
        const auto address = serve(server, *place.device, place.where, place.unit, place.options);
        if (!address)
            return tl::unexpected{address.error()};
        addresses += *address;
    }
    if (const Result<void> printed = print(addresses); !printed)
        return tl::unexpected{printed.error()};

    Result<void> served;
    std::atomic<bool> isOver{false};
    std::jthread serving([&](const std::stop_token& stop) {
        served = server.run(stop);
        isOver = true;
    });
    std::optional<int> signal;
    while (!signal && !isOver)
        signal = signals.wait(std::chrono::milliseconds{100});
    serving.request_stop();
    serving.join();
    if (!served)
        return tl::unexpected{served.error()};
    return static_cast<ExitCode>(128 + signal.value_or(0));
}

}  // namespace

void addEmulateCommand(CLI::App& program, Command& chosen)
{
    CLI::App& command = *program.add_subcommand(
        "emulate",
        "a laser and what tilts it in a simulated room, for other programs to talk to, until it is interrupted");
    auto options = std::make_shared<EmulateOptions>();
    command.add_option("--room", options->room, "scene of the room (default corridor)")->type_name("SCENE");
    addWholeNumber(command, "--seed", options->seed, std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max(),
                   "seed of the room, of noise and of faults at random");
    command.add_option("--laser", options->laser, "serve the laser: tcp:PORT (0: any) or pty")->type_name("SERVE");
    command.add_option("--tilt", options->tilt, "serve a servo that tilts it: tcp:PORT or pty")->type_name("SERVE");
    command.add_option("--board", options->board, "serve a control board that tilts it: tcp:PORT or pty")
        ->type_name("SERVE");
    command.add_option("--model", options->model, "UTM-30LX, UST-20LX or URG-04LX")->type_name("NAME");
    command
        .add_option("--servo", options->servo,
                    "servo behind --tilt: " + namesOf(emulatedServoKinds()) + " (default RX-64)")
        ->type_name("NAME");
    addWholeNumber(command, "--baud", options->baud, 300, 4'500'000,
                   "rate of the servo's bus in bit/s (default 57142)");
    command.add_option("--serial", options->serial, "number that the laser says it has")->type_name("NUMBER");
    std::string kinds =
        "what goes wrong, from the STEP-th turn of the mirror since it first streamed on; without @STEP from the "
        "beginning on:";
    for (const EmulatedFaultKind& kind : emulatedFaultKinds())
        kinds += "\n  " + std::string(kind.name) + ": " + std::string(kind.sentence);
    command.add_option("--fault", options->faults, kinds)->type_name("KIND[@STEP]");
    command.callback([options, &chosen] { chosen = [options] { return emulate(*options); }; });
}

}  // namespace planewright
