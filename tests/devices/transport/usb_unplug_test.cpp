// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <atomic>
#include <random>
#include <thread>

#include <QtTest>

#include "devices/transport/usb_cdc.h"
#include "devices/transport/usb_error.h"
#include "tests/devices/transport/usb_rig.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

/// A laser is pulled out again and again, in every situation and at random points of it. What must hold each time: no
/// byte is invented, lost in the middle or twice there; the link ends once, for one reason; nothing is left in flight;
/// and the laser works when it is plugged in again.
class UsbUnplugTest : public QObject {
    Q_OBJECT

private slots:
    void whileNothingHappens();
    void inTheMiddleOfAFrame();
    void whileTheHostSends();
    void whileAStallIsFreed();
    void whileItIsOpened();
    void whileItIsListed();
    void whileItIsClosed();
    void whoeverTellsFirst_data();
    void whoeverTellsFirst();
    void theFirstReasonStaysWhenTheLinkIsClosedLater();
};

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kWholeFrame = 3372;  // of a laser with 1081 beams

int repetitions()
{
    return qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG") ? 200 : 20;
}

/// The laser and the machine that it is plugged into again and again.
class Bench {
public:
    explicit Bench(std::uint32_t seed) : random(seed)
    {
        UsbModel model = cdcModel();
        model.driversInSysfs = false;
        laser = rig.usb.plug(model, 4);
    }

    std::unique_ptr<Transport> open()
    {
        auto opened = openUsbCdc(rig.bus, rig.devices(1).at(0), steadyClock());
        if (!opened)
            throw std::runtime_error(opened.error().message);
        return std::move(*opened);
    }

    /// In one of the orders in which the machine may learn of it, by chance. Where no link is open, only opening would
    /// tell a machine that is not told.
    void unplug(bool isOpen = true)
    {
        constexpr std::array kOrders{EmulatedUsb::Unplugging::TransfersFirst, EmulatedUsb::Unplugging::EventFirst,
                                     EmulatedUsb::Unplugging::TransfersOnly};
        rig.usb.unplug(laser, kOrders[random() % (isOpen ? 3 : 2)]);
    }

    std::uint32_t any() { return static_cast<std::uint32_t>(random()); }
    int upTo(int most) { return static_cast<int>(any() % static_cast<unsigned>(most + 1)); }

    /// The link tells that the device is gone, in the same words every time, and leaves nothing behind.
    void endsOnce(Transport& link)
    {
        const auto why = readToTheEnd(link);
        QVERIFY(why);
        QCOMPARE(why->code, ErrorCode::DeviceLost);
        QCOMPARE(why->message, usbGone("usb 1-4").message);
        const auto written = link.write(Bytes{1}, in(10s));
        QVERIFY(!written);
        QCOMPARE(written.error().message, why->message);
        link.close();
        QCOMPARE(readToTheEnd(link)->message, why->message);
        QCOMPARE(laser->closedInFlight(), 0);
        QCOMPARE(laser->transfersIn(), 0);
        QCOMPARE(laser->transfersOut(), 0);
    }

    /// Plugged in again it is another device of the machine, which works.
    void worksAgain()
    {
        laser->stallIn(0);
        laser->unblockOut();
        QVERIFY(rig.devices(0).empty());
        rig.usb.plugAgain(laser, 4);
        const auto link = open();
        const Bytes sent = pattern(300, any());
        laser->send(sent);
        QCOMPARE(readBytes(*link, sent.size()), sent);
        QVERIFY(link->write(sent, in(10s)));
    }

    std::mt19937 random;
    UsbRig rig;
    std::shared_ptr<EmulatedUsbDevice> laser;
};

bool isBeginningOf(const Bytes& part, const Bytes& whole)
{
    return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

}  // namespace

void UsbUnplugTest::whileNothingHappens()
{
    Bench bench(1);
    for (int i = 0; i < repetitions(); ++i) {
        const auto link = bench.open();
        bench.unplug();
        bench.endsOnce(*link);
        bench.worksAgain();
    }
}

void UsbUnplugTest::inTheMiddleOfAFrame()
{
    Bench bench(2);
    for (int i = 0; i < repetitions(); ++i) {
        const auto link = bench.open();
        const Bytes sent = pattern(4 * kWholeFrame, bench.any());
        const auto count = static_cast<std::size_t>(bench.upTo(static_cast<int>(sent.size())));
        std::jthread plug{[&] {
            for (std::size_t at = 0; at < count; at += kWholeFrame)
                bench.laser->send(std::span{sent}.subspan(at, std::min(kWholeFrame, count - at)));
            bench.unplug();
        }};

        Bytes received;
        std::array<std::uint8_t, 777> into{};
        while (const auto arrival = link->read(into, in(10s), {}))
            received.insert(received.end(), into.begin(), into.begin() + static_cast<std::ptrdiff_t>(arrival->count));
        plug.join();

        QVERIFY(isBeginningOf(received, sent));
        QVERIFY(received.size() <= count);
        bench.endsOnce(*link);
        bench.worksAgain();
    }
}

void UsbUnplugTest::whileTheHostSends()
{
    Bench bench(3);
    for (int i = 0; i < repetitions(); ++i) {
        const auto link = bench.open();
        const int before = bench.upTo(20);
        std::atomic<int> requests{0};
        bench.laser->onReceive([&](std::span<const std::uint8_t>) {
            if (++requests == before)
                bench.laser->blockOut(1);
        });
        std::jthread plug{[&] {
            comesTrue([&] { return requests >= before; });
            bench.unplug();
        }};

        Result<void> written;
        while (written)
            written = link->write(Bytes{'Q', 'T', '\n'}, in(10s));
        plug.join();

        QCOMPARE(written.error().message, usbGone("usb 1-4").message);
        bench.laser->onReceive({});
        bench.endsOnce(*link);
        bench.worksAgain();
    }
}

void UsbUnplugTest::whileAStallIsFreed()
{
    Bench bench(4);
    for (int i = 0; i < repetitions(); ++i) {
        const auto link = bench.open();
        const int freed = bench.laser->freedIn() + bench.upTo(3);
        bench.laser->stallIn(3);
        comesTrue([&] { return bench.laser->freedIn() >= freed; });
        bench.unplug();
        bench.endsOnce(*link);
        bench.worksAgain();
    }
}

void UsbUnplugTest::whileItIsOpened()
{
    Bench bench(5);
    for (int i = 0; i < repetitions(); ++i) {
        const UsbDevice device = bench.rig.devices(1).at(0);
        const std::chrono::microseconds after{bench.upTo(1500)};
        std::jthread plug{[&] {
            const auto until = in(after);
            while (steadyClock().now() < until)
                std::this_thread::yield();
            bench.unplug(false);
        }};

        const auto link = openUsbCdc(bench.rig.bus, device, steadyClock());
        plug.join();

        if (link)
            bench.endsOnce(**link);
        else
            QCOMPARE(link.error().code, ErrorCode::NoDevice);
        QCOMPARE(bench.laser->closedInFlight(), 0);
        bench.worksAgain();
    }
}

void UsbUnplugTest::whileItIsListed()
{
    Bench bench(6);
    for (int i = 0; i < repetitions(); ++i) {
        bench.rig.devices(1);
        std::jthread plug{[&] { bench.unplug(false); }};
        while (!bench.rig.bus->devices().empty()) {
        }
        plug.join();
        bench.worksAgain();
    }
}

void UsbUnplugTest::whileItIsClosed()
{
    Bench bench(7);
    for (int i = 0; i < repetitions(); ++i) {
        const auto link = bench.open();
        std::jthread plug{[&] { bench.unplug(false); }};
        link->close();
        plug.join();

        std::array<std::uint8_t, 8> into{};
        QCOMPARE(link->read(into, in(10s), {}).error().code, ErrorCode::DeviceLost);
        QCOMPARE(bench.laser->closedInFlight(), 0);
        QVERIFY(comesTrue([&] { return bench.rig.bus->devices().empty(); }));
        bench.worksAgain();
    }
}

void UsbUnplugTest::whoeverTellsFirst_data()
{
    QTest::addColumn<int>("order");
    QTest::newRow("transfers come back, then the system tells") << int(EmulatedUsb::Unplugging::TransfersFirst);
    QTest::newRow("the system tells, then transfers come back") << int(EmulatedUsb::Unplugging::EventFirst);
    QTest::newRow("the system does not tell") << int(EmulatedUsb::Unplugging::TransfersOnly);
}

void UsbUnplugTest::whoeverTellsFirst()
{
    QFETCH(int, order);
    Bench bench(8);
    const auto link = bench.open();
    const auto began = steadyClock().now();

    bench.rig.usb.unplug(bench.laser, static_cast<EmulatedUsb::Unplugging>(order));

    bench.endsOnce(*link);
    QVERIFY(steadyClock().now() - began < 5s);
    bench.worksAgain();
}

void UsbUnplugTest::theFirstReasonStaysWhenTheLinkIsClosedLater()
{
    Bench bench(9);
    const auto link = bench.open();
    const Bytes sent = pattern(500, 1);
    bench.laser->send(sent);
    bench.rig.usb.unplug(bench.laser);
    QVERIFY(comesTrue([&] { return !link->write(Bytes{1}, in(10s)); }));

    link->close();

    // What came before it went is still there.
    QCOMPARE(readBytes(*link, sent.size()), sent);
    QCOMPARE(readToTheEnd(*link)->message, usbGone("usb 1-4").message);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UsbUnplugTest)
#include "usb_unplug_test.moc"
