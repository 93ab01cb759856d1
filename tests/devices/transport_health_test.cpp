// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QtTest>

#include "devices/board/board_tilt.h"
#include "devices/dynamixel/dynamixel_tilt.h"
#include "devices/emulated/emulated_link.h"
#include "devices/emulated/emulated_servo.h"
#include "devices/scip/scip_laser.h"
#include "tests/devices/emulated/board_host.h"
#include "tests/devices/emulated/laser_rig.h"
#include "tests/devices/fake_clock.h"
#include "tests/test_program.h"

namespace planewright {

/// What a transport tells of its own troubles shows in the health of whatever is driven over it.
class TransportHealthTest : public QObject {
    Q_OBJECT

private slots:
    void aLaserTellsIt();
    void aServoTellsItAndLogsIt();
    void aBoardTellsIt();
};

namespace {

/// A link with troubles.
class TroubledLink : public Transport {
public:
    TroubledLink(std::unique_ptr<Transport> link, const TransportHealth& health)
        : link_(std::move(link)), health_(health)
    {
    }

    std::string name() const override { return link_->name(); }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override
    {
        return link_->read(into, deadline, stop);
    }
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override
    {
        return link_->write(bytes, deadline);
    }
    TransportHealth health() const override { return health_; }
    void close() override { link_->close(); }

private:
    std::unique_ptr<Transport> link_;
    const TransportHealth& health_;
};

struct Bench {
    FakeClock clock;
    TransportHealth health;

    std::unique_ptr<Transport> linkTo(std::shared_ptr<EmulatedDevice> device)
    {
        auto link = std::make_unique<EmulatedLink>(std::move(device), std::make_shared<std::mutex>(), clock, "link");
        return std::make_unique<TroubledLink>(std::move(link), health);
    }
    TiltMounting mounting{degrees(90.0), 1.0, 1.0, degrees(20.0), degrees(160.0), degrees(120.0)};
};

const TransportHealth kTroubled{3, "the dialogue is recorded no further"};

}  // namespace

void TransportHealthTest::aLaserTellsIt()
{
    Bench bench;
    ScipLaser laser{bench.linkTo(*EmulatedLaser::make(viewOfWall(), level, laserOptions())), bench.clock};
    QVERIFY(laser.connect({}));
    QCOMPARE(laser.health().trouble, std::string{});

    bench.health = kTroubled;

    QCOMPARE(laser.health().overruns, std::uint64_t(3));
    QCOMPARE(laser.health().trouble, kTroubled.trouble);
}

void TransportHealthTest::aServoTellsItAndLogsIt()
{
    Bench bench;
    DynamixelOptions options;
    options.mounting = bench.mounting;
    EmulatedServoSettings settings;
    settings.mounting = bench.mounting;
    settings.pitch = degrees(90.0);
    DynamixelTilt tilt{bench.linkTo(EmulatedServo::make(settings).value()), bench.clock, options};
    QVERIFY(tilt.connect({}));
    QVERIFY(tilt.takeLog().empty());
    bench.health = kTroubled;

    QVERIFY(tilt.arm({}));

    QCOMPARE(tilt.health().overruns, std::uint64_t(3));
    QCOMPARE(tilt.health().trouble, kTroubled.trouble);
    const auto log = tilt.takeLog();
    QCOMPARE(log.size(), std::size_t(1));
    QCOMPARE(log[0].code, std::string{"adapter-overrun"});
    QVERIFY(log[0].text.find("3 times") != std::string::npos);
}

void TransportHealthTest::aBoardTellsIt()
{
    Bench bench;
    BoardTiltOptions options;
    options.mounting = bench.mounting;
    BoardTilt tilt{bench.linkTo(EmulatedBoard::make(levelBoard()).value()), bench.clock, options};
    QVERIFY(tilt.connect({}));

    bench.health = kTroubled;

    QCOMPARE(tilt.health().overruns, std::uint64_t(3));
    QCOMPARE(tilt.health().trouble, kTroubled.trouble);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::TransportHealthTest)
#include "transport_health_test.moc"
