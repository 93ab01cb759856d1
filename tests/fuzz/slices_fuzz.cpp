// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <vector>

#include "core/simulation/scenes.h"
#include "devices/board/board_tilt.h"
#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/emulated/emulated_board.h"
#include "devices/emulated/emulated_laser.h"
#include "devices/emulated/emulated_link.h"
#include "devices/emulated/emulated_servo.h"
#include "devices/nodding/nodding_source.h"
#include "devices/scip/scip_laser.h"
#include "tests/devices/fake_clock.h"

/// Bytes to slices: an emulated laser on a servo, or on a control board where the input has an odd length, whose bytes
/// the input changes on their way. Whatever comes, the scanner ends, and its slices are whole, in order, and have
/// angles that the head really had.
namespace planewright {

namespace {

constexpr int kSlices = 6;
/// Calls of next() that may fail, one after the other or not, before the scan is given up.
constexpr int kMostFaults = 4;
constexpr double kFirstPitch = degrees(80.0);

void require(bool holds)
{
    if (!holds)
        std::abort();
}

/// Changes to bytes: so many pass, then one is flipped, lost, doubled or preceded by another.
class Edits {
public:
    explicit Edits(std::span<const std::uint8_t> input) : input_(input) { read(); }

    void change(std::uint8_t byte, std::vector<std::uint8_t>& out)
    {
        if (!hasEdit_ || gap_-- > 0) {
            out.push_back(byte);
            return;
        }
        switch (kind_ % 4) {
            case 0:
                out.push_back(static_cast<std::uint8_t>(byte ^ value_));
                break;
            case 1:
                break;
            case 2:
                out.insert(out.end(), {value_, byte});
                break;
            default:
                out.insert(out.end(), {byte, byte});
        }
        read();
    }

private:
    void read()
    {
        hasEdit_ = input_.size() >= 4;
        if (!hasEdit_)
            return;
        gap_ = 256 * input_[0] + input_[1];
        kind_ = input_[2];
        value_ = input_[3];
        input_ = input_.subspan(4);
    }

    std::span<const std::uint8_t> input_;
    bool hasEdit_ = false;
    int gap_ = 0;
    std::uint8_t kind_ = 0;
    std::uint8_t value_ = 0;
};

class ChangedLink : public Transport {
public:
    ChangedLink(std::unique_ptr<Transport> link, std::shared_ptr<Edits> edits)
        : link_(std::move(link)), edits_(std::move(edits))
    {
    }

    std::string name() const override { return link_->name(); }

    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override
    {
        while (changed_.empty()) {
            std::vector<std::uint8_t> raw(256);
            const Result<Arrival> arrival = link_->read(raw, deadline, stop);
            if (!arrival || arrival->count == 0)
                return arrival;
            at_ = arrival->at;
            for (std::size_t i = 0; i < arrival->count; ++i)
                edits_->change(raw[i], changed_);
        }
        const Arrival arrival{std::min(into.size(), changed_.size()), at_};
        const auto end = changed_.begin() + static_cast<std::ptrdiff_t>(arrival.count);
        std::copy(changed_.begin(), end, into.begin());
        changed_.erase(changed_.begin(), end);
        return arrival;
    }

    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override
    {
        return link_->write(bytes, deadline);
    }
    void close() override { link_->close(); }

private:
    std::unique_ptr<Transport> link_;
    std::shared_ptr<Edits> edits_;
    std::vector<std::uint8_t> changed_;
    std::chrono::nanoseconds at_{0};
};

struct Rig {
    FakeClock clock;
    std::shared_ptr<std::mutex> mutex = std::make_shared<std::mutex>();
    TiltMounting mounting{degrees(90.0), 1.0, 1.0, degrees(0.0), degrees(180.0), degrees(120.0)};
    std::shared_ptr<EmulatedServo> servo;
    std::shared_ptr<EmulatedBoard> board;  ///< one of the two
    std::shared_ptr<EmulatedLaser> laser;

    explicit Rig(bool hasBoard)
    {
        if (hasBoard)
            board = EmulatedBoard::make({.mounting = mounting, .startPitch = kFirstPitch}).value();
        else
            servo = EmulatedServo::make({.mounting = mounting, .pitch = kFirstPitch}).value();
        // A room of few surfaces: what is cast into it is no part of what is tried here.
        static const auto view = std::make_shared<EmulatedView>(makeScene("curved", 1).value(), SimulationNoise{}, 1);
        EmulatedLaserOptions options;
        options.model = emulatedLaserModel("UTM-30LX").value();
        laser = EmulatedLaser::make(
                    view, [this](auto at) { return board ? board->pitchAt(at) : servo->pitchAt(at); }, options)
                    .value();
    }

    template <class Device, class Driver, class... Options>
    auto opener(const std::shared_ptr<Device>& device, std::shared_ptr<Edits> edits, Options... options)
    {
        return [=, this](const std::stop_token& stop) {
            auto link = std::make_unique<EmulatedLink>(device, mutex, clock, "fuzzed");
            auto driver =
                std::make_unique<Driver>(std::make_unique<ChangedLink>(std::move(link), edits), clock, options...);
            const Result<void> connected = driver->connect(stop);
            return connected ? Result<std::unique_ptr<Driver>>(std::move(driver)) : tl::unexpected{connected.error()};
        };
    }
};

}  // namespace

void scanThrough(std::span<const std::uint8_t> input)
{
    Rig rig{input.size() % 2 == 1};
    const std::size_t half = input.size() / 8 * 4;
    const auto laserEdits = std::make_shared<Edits>(input.first(half));
    const auto tiltEdits = std::make_shared<Edits>(input.subspan(half));
    const auto openLaser = rig.opener<EmulatedLaser, ScipLaser>(rig.laser, laserEdits);
    DynamixelOptions options;
    options.mounting = rig.mounting;
    const auto openServo = rig.opener<EmulatedServo, DynamixelTilt>(rig.servo, tiltEdits, options);
    BoardTiltOptions boardOptions;
    boardOptions.mounting = rig.mounting;
    const auto openBoard = rig.opener<EmulatedBoard, BoardTilt>(rig.board, tiltEdits, boardOptions);
    ScanPlan plan;
    plan.firstPitch = kFirstPitch;
    plan.slices = kSlices;
    plan.firstBearing = degrees(88.0);
    plan.lastBearing = degrees(92.0);

    const NoddingDevices devices{
        [&](const std::stop_token& stop) {
            return openLaser(stop).map([](auto p) { return std::unique_ptr<Laser>(std::move(p)); });
        },
        [&](const std::stop_token& stop) {
            const auto asUnit = [](auto p) { return std::unique_ptr<TiltUnit>(std::move(p)); };
            return rig.board ? openBoard(stop).map(asUnit) : openServo(stop).map(asUnit);
        }};
    auto scanner = NoddingSource::open(devices, plan, rig.clock, {});
    if (!scanner)
        return;
    int faults = (*scanner)->begin({}) ? 0 : kMostFaults;
    int last = -1;
    while (faults < kMostFaults) {
        const auto slice = (*scanner)->next({});
        if (!slice) {
            ++faults;
            continue;
        }
        if (!*slice)
            break;
        require((*slice)->step > last && (*slice)->step < kSlices);
        last = (*slice)->step;
        require((*slice)->ranges.size() == 17);
        for (const double range : (*slice)->ranges)
            require(range == 0.0 || (range >= 0.023 && range <= 60.0));
        require(std::isfinite((*slice)->tilt) && std::isfinite((*slice)->tiltEnd.value()));
        require((*slice)->tilt > degrees(-60.0) && (*slice)->tilt < degrees(240.0));
    }
}

}  // namespace planewright

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    planewright::scanThrough({data, size});
    return 0;
}
