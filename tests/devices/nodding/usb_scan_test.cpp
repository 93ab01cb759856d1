// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "core/simulation/nodding_scanner.h"
#include "core/simulation/scenes.h"
#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/emulated/emulated_rig.h"
#include "devices/nodding/nodding_source.h"
#include "devices/nodding/slice_maker.h"
#include "devices/scip/scip_clock.h"
#include "devices/scip/scip_laser.h"
#include "devices/transport/usb_cdc.h"
#include "devices/transport/usb_ftdi.h"
#include "tests/devices/nodding/same_planes.h"
#include "tests/devices/transport/far_end.h"
#include "tests/devices/transport/usb_rig.h"
#include "tests/test_program.h"

namespace planewright {

/// A scan in real time through libusb: an emulated laser, and an emulated servo behind an emulated FTDI adapter.
class UsbScanTest : public QObject {
    Q_OBJECT

private slots:
    void aScanComesThroughUsb();
};

namespace {

/// A device of a rig whose devices are moved by different threads.
class SharedDevice : public EmulatedDevice {
public:
    SharedDevice(std::shared_ptr<EmulatedDevice> device, std::shared_ptr<std::mutex> rig)
        : device_(std::move(device)), rig_(std::move(rig))
    {
    }

    void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) override
    {
        const std::scoped_lock lock{*rig_};
        device_->receive(bytes, later(now));
    }
    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override
    {
        const std::scoped_lock lock{*rig_};
        return device_->takeOutput(later(now));
    }
    std::optional<std::chrono::nanoseconds> nextOutput() const override
    {
        const std::scoped_lock lock{*rig_};
        return device_->nextOutput();
    }
    bool isConnected(std::chrono::nanoseconds now) override
    {
        const std::scoped_lock lock{*rig_};
        return device_->isConnected(later(now));
    }

private:
    /// Two threads may have looked at the clock before either has come here.
    std::chrono::nanoseconds later(std::chrono::nanoseconds now) { return now_ = std::max(now_, now); }

    std::shared_ptr<EmulatedDevice> device_;
    std::shared_ptr<std::mutex> rig_;
    std::chrono::nanoseconds now_{0};
};

/// A serial device behind an adapter of FTDI: two bytes of status begin each packet to the host.
class BehindFtdi : public EmulatedDevice {
public:
    explicit BehindFtdi(std::shared_ptr<EmulatedDevice> device) : device_(std::move(device)) {}

    void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) override
    {
        device_->receive(bytes, now);
    }
    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override
    {
        constexpr std::size_t kPacket = 64;
        constexpr std::size_t kStatus = 2;
        std::vector<EmulatedOutput> outputs = device_->takeOutput(now);
        for (EmulatedOutput& output : outputs) {
            std::vector<std::uint8_t> packets;
            for (std::size_t i = 0; i < output.bytes.size(); ++i) {
                if (i % (kPacket - kStatus) == 0)
                    packets.insert(packets.end(), {0x01, 0x60});
                packets.push_back(output.bytes[i]);
            }
            output.bytes = std::move(packets);
        }
        return outputs;
    }
    std::optional<std::chrono::nanoseconds> nextOutput() const override { return device_->nextOutput(); }
    bool isConnected(std::chrono::nanoseconds now) override { return device_->isConnected(now); }

private:
    std::shared_ptr<EmulatedDevice> device_;
};

template <class Driver, class Base>
Result<std::unique_ptr<Base>> connected(std::unique_ptr<Driver> driver, const std::stop_token& stop)
{
    if (const Result<void> done = driver->connect(stop); !done)
        return tl::unexpected{done.error()};
    return std::unique_ptr<Base>(std::move(driver));
}

constexpr double kHalfCount = degrees(0.15);  // of an RX-64
/// By which the moments of a laser and of a servo may be wrong to each other, where both answered as slowly as they
/// may.
constexpr std::chrono::duration<double> kWorstTiming = ScipClock::kSlowestAnswer / 2 + kLargestSkew;
constexpr std::chrono::milliseconds kTurn{25};  // of the emulated laser
/// Three times the noise of the emulated laser, 8 mm and 1 mm a metre.
constexpr double slackAt(double range)
{
    return 0.024 + 0.003 * range;
}

}  // namespace

void UsbScanTest::aScanComesThroughUsb()
{
    EmulatedRigSetup setup;
    setup.scene = makeScene("corridor", 7).value();
    const auto devices = EmulatedRig::make(setup).value();
    UsbRig usb;
    FarEnd laser(usb.usb.plug(cdcModel(), 1), std::make_shared<SharedDevice>(devices->laser(), devices->mutex()),
                 steadyClock());
    FarEnd servo(usb.usb.plug(ft232rModel(), 2),
                 std::make_shared<BehindFtdi>(std::make_shared<SharedDevice>(devices->tilt(), devices->mutex())),
                 steadyClock());
    std::vector<UsbDevice> found = usb.devices(2);
    QCOMPARE(found.size(), std::size_t(2));
    if (found[0].kind == UsbKind::Ftdi)
        std::swap(found[0], found[1]);
    NoddingDevices openers{[&](const std::stop_token& stop) -> Result<std::unique_ptr<Laser>> {
                               auto link = openUsbCdc(usb.bus, found[0], steadyClock());
                               if (!link)
                                   return tl::unexpected{link.error()};
                               return connected<ScipLaser, Laser>(
                                   std::make_unique<ScipLaser>(std::move(*link), steadyClock()), stop);
                           },
                           [&](const std::stop_token& stop) -> Result<std::unique_ptr<TiltUnit>> {
                               auto link = UsbFtdi::open(usb.bus, found[1], setup.baud, steadyClock());
                               if (!link)
                                   return tl::unexpected{link.error()};
                               DynamixelOptions options;
                               options.mounting = setup.mounting;
                               options.mounting.lowest = degrees(0.0);
                               options.mounting.highest = degrees(180.0);
                               return connected<DynamixelTilt, TiltUnit>(
                                   std::make_unique<DynamixelTilt>(std::move(*link), steadyClock(), options), stop);
                           }};
    ScanPlan plan;
    const bool isSweep = qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG");
    if (!isSweep) {
        // A head that stands still asks nothing of the time that a busy machine takes.
        plan.mode = ScanPlan::Mode::StepAndStare;
        plan.firstPitch = degrees(75.0);
        plan.slices = 25;
        // Under sanitizers the emulated laser takes longer to see all beams than they take.
        plan.firstBearing = degrees(80.0);
        plan.lastBearing = degrees(100.0);
    }

    auto source = NoddingSource::open(openers, plan, steadyClock(), {});
    QVERIFY2(source.has_value(), source ? "" : source.error().message.c_str());
    // A machine that is busy for tens of milliseconds makes answers late: somebody tries again.
    auto begun = (*source)->begin({});
    for (int attempt = 1; attempt < 5 && !begun; ++attempt)
        begun = (*source)->begin({});
    QVERIFY2(begun.has_value(), begun ? "" : begun.error().message.c_str());
    std::vector<ScanSlice> slices;
    int sure = 0;
    int like = 0;
    int faults = 0;
    for (;;) {
        const auto slice = (*source)->next({});
        if (!slice && ++faults < 5)
            continue;
        QVERIFY2(slice.has_value(), slice ? "" : slice.error().message.c_str());
        if (!*slice)
            break;
        slices.push_back(**slice);
        if ((*slice)->angleSuspect)
            continue;
        ++sure;
        AcquisitionSettings settings;
        settings.slices = 1;
        settings.firstBearing = (*slice)->firstBearing;
        settings.beams = static_cast<int>((*slice)->ranges.size());
        settings.continuous = true;
        settings.tiltStep = isSweep ? (*slice)->tiltEnd.value() - (*slice)->tilt : 0.0;
        // So well is the angle known, which is much where a beam grazes the floor.
        const double slack = kHalfCount + (isSweep ? plan.pitchStep * (kWorstTiming / kTurn) : 0.0);
        std::vector<ScanSlice> simulated;
        for (const double off : {-slack, 0.0, slack}) {
            settings.firstTilt = (*slice)->tilt + off;
            simulated.push_back(simulateSlice(setup.scene, settings, {}, 1, 0).slice);
        }
        int near = 0;
        for (std::size_t beam = 0; beam < (*slice)->ranges.size(); ++beam) {
            const auto [nearest, farthest] =
                std::minmax({simulated[0].ranges[beam], simulated[1].ranges[beam], simulated[2].ranges[beam]});
            const double range = (*slice)->ranges[beam];
            near += range > nearest - slackAt(range) && range < farthest + slackAt(range) ? 1 : 0;
        }
        like += near > 0.9 * static_cast<double>((*slice)->ranges.size()) ? 1 : 0;
    }

    const std::string health = factsOf((*source)->deviceHealth()).front().value;
    qInfo("%zu of %d slices; laser %s", slices.size(), plan.slices, health.c_str());
    // A busy machine may be late for some of a sweep; what comes is right, or marked.
    QVERIFY(sure >= (isSweep ? plan.slices * 2 / 3 : plan.slices));
    QCOMPARE(like, sure);
    if (!isSweep)
        return;  // whole_scan_test has the planes of a whole scan each time, without the cables
    AcquisitionSettings settings;
    settings.firstTilt = plan.firstPitch;
    settings.slices = plan.slices;
    settings.firstBearing = (*source)->description().firstBearing;
    settings.beams = (*source)->description().beams;
    const Recording simulated = simulate(setup.scene, settings, {}, 1).recording;
    verifySamePlanes(planesOf((*source)->description(), slices), planesOf(simulated.description, simulated.slices),
                     3000, 4);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UsbScanTest)
#include "usb_scan_test.moc"
