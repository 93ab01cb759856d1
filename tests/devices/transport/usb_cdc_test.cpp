// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_cdc.h"

#include <array>
#include <atomic>
#include <thread>

#include <QtTest>

#include "tests/devices/transport/usb_rig.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class UsbCdcTest : public QObject {
    Q_OBJECT

private slots:
    // Opening and closing.
    void openingTakesBothInterfacesFromTheKernelAndClosingGivesThemBack();
    void theLineIsSetAsATerminalSetsIt();
    void theLineIsSetOnTheControlInterface();
    void aDeviceThatRefusesLinesIsUsedAllTheSame();
    void aDeviceThatLeavesALineUnansweredIsNotOpened();
    void aDeviceIsOpenedAgainAfterItWasClosed();
    void closingTwiceFromTwoThreadsIsFine();
    void closingBringsHomeWhoReadsAndWhoWrites();

    // Receiving.
    void whatArrivesIsReadWithItsTime();
    void twoArrivalsAreNotMerged();
    void emptyPacketsAreNothing();
    void eightTransfersWaitAtAllTimes();
    void wholePacketsWithoutAnEndAreFetched();
    void moreThanAllTransfersHoldComesInOrder();

    // Sending.
    void whatIsSentArrivesByteByByte();
    void nothingIsSentForNothing();
    void whatADeviceDoesNotTakeIsAnErrorAtTheDeadline();
    void aDeviceThatTakesAPartIsToldOfInTheError();
    void aLinkWorksOnAfterADeadline();

    // Stalls.
    void aStallIsFreedUpToThreeTimes();
    void aFourthStallInARowEndsTheLink();
    void whatCameBeforeAStallIsKept();
    void aPacketThatIsTooLongIsSurvived();
    void aStallWhileSendingIsFreedUpToThreeTimes();
};

namespace {

using Bytes = std::vector<std::uint8_t>;

/// An emulated laser, and the transport to it.
struct OpenLaser {
    explicit OpenLaser(const UsbModel& model = cdcModel()) : laser(rig.usb.plug(model, 4))
    {
        auto opened = openUsbCdc(rig.bus, rig.devices(1).at(0), steadyClock());
        if (!opened)
            throw std::runtime_error(opened.error().message);
        link = std::move(*opened);
    }

    UsbRig rig;
    std::shared_ptr<EmulatedUsbDevice> laser;
    std::unique_ptr<Transport> link;
};

const Bytes kLineCoding{0x00, 0xC2, 0x01, 0x00, 0x00, 0x00, 0x08};  // 115200, 8N1
const Bytes kRequest{'V', 'V', '\n'};

}  // namespace

void UsbCdcTest::openingTakesBothInterfacesFromTheKernelAndClosingGivesThemBack()
{
    OpenLaser open;
    QVERIFY(open.laser->isClaimed(0));
    QVERIFY(open.laser->isClaimed(1));
    QCOMPARE(open.laser->driver(0), std::string());
    QCOMPARE(open.link->name(), std::string("usb 1-4"));

    open.link->close();

    QCOMPARE(open.laser->released(), (std::vector<int>{1, 0}));
    QCOMPARE(open.laser->driver(0), std::string("cdc_acm"));
    QCOMPARE(open.laser->driver(1), std::string("cdc_acm"));
    QCOMPARE(open.laser->closedInFlight(), 0);
}

void UsbCdcTest::theLineIsSetAsATerminalSetsIt()
{
    OpenLaser open;

    const auto settings = open.laser->settings();

    QCOMPARE(settings.size(), std::size_t(2));
    QVERIFY((settings[0] == EmulatedUsbDevice::Setting{0x21, 0x20, 0, 0, kLineCoding}));
    QVERIFY((settings[1] == EmulatedUsbDevice::Setting{0x21, 0x22, 3, 0, {}}));
}

void UsbCdcTest::theLineIsSetOnTheControlInterface()
{
    OpenLaser open(cdcModel({.controlInterface = 2, .dataInterface = 3, .unitedWith = 3}));

    for (const auto& setting : open.laser->settings())
        QCOMPARE(int(setting.index), 2);
    QVERIFY(open.laser->isClaimed(2));
    QVERIFY(open.laser->isClaimed(3));
    QVERIFY(!open.laser->isClaimed(0));
}

void UsbCdcTest::aDeviceThatRefusesLinesIsUsedAllTheSame()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 4);
    laser->refuse(0x20);
    laser->refuse(0x22);

    const auto link = openUsbCdc(rig.bus, rig.devices(1).at(0), steadyClock());

    QVERIFY(link);
    laser->send(Bytes{1, 2, 3});
    QCOMPARE(readBytes(**link, 3), (Bytes{1, 2, 3}));
}

void UsbCdcTest::aDeviceThatLeavesALineUnansweredIsNotOpened()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 4);
    laser->leaveSettingsUnanswered();

    const auto link = openUsbCdc(rig.bus, rig.devices(1).at(0), steadyClock());

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::NoDevice);
    QVERIFY2(link.error().message.starts_with("usb 1-4 (15d1:0000 URG-Series USB Driver): it does not answer"),
             link.error().message.c_str());
    QVERIFY(!laser->isClaimed(0));
    QVERIFY(!laser->isClaimed(1));
    QVERIFY(comesTrue([&] { return rig.bus->devices().at(0).access == UsbAccess::Openable; }));
}

void UsbCdcTest::aDeviceIsOpenedAgainAfterItWasClosed()
{
    OpenLaser open;
    for (int i = 0; i < 10; ++i) {
        open.link->close();
        auto again = openUsbCdc(open.rig.bus, open.rig.devices(1).at(0), steadyClock());
        QVERIFY2(again, again ? "" : again.error().message.c_str());
        open.link = std::move(*again);
        const Bytes sent = pattern(200, static_cast<std::uint32_t>(i));
        open.laser->send(sent);
        QCOMPARE(readBytes(*open.link, sent.size()), sent);
    }
    QCOMPARE(open.laser->closedInFlight(), 0);
}

void UsbCdcTest::closingTwiceFromTwoThreadsIsFine()
{
    OpenLaser open;
    std::jthread other{[&] { open.link->close(); }};
    open.link->close();
    other.join();
    open.link->close();

    std::array<std::uint8_t, 8> into{};
    const auto read = open.link->read(into, in(1h), {});
    const auto written = open.link->write(kRequest, in(1h));

    QVERIFY(!read && !written);
    QCOMPARE(read.error().code, ErrorCode::DeviceLost);
    QCOMPARE(read.error().message, written.error().message);
    QVERIFY(read.error().message.starts_with("usb 1-4: "));
    QCOMPARE(open.laser->closedInFlight(), 0);
}

void UsbCdcTest::closingBringsHomeWhoReadsAndWhoWrites()
{
    OpenLaser open;
    open.laser->blockOut();
    std::atomic<int> home{0};
    std::jthread reader{[&] {
        std::array<std::uint8_t, 8> into{};
        home += !open.link->read(into, in(1h), {}) ? 1 : 0;
    }};
    std::jthread writer{[&] { home += !open.link->write(kRequest, in(1h)) ? 1 : 0; }};
    std::jthread second{[&] { home += !open.link->write(kRequest, in(1h)) ? 1 : 0; }};
    QVERIFY(comesTrue([&] { return open.laser->transfersOut() == 1; }));

    open.link->close();
    reader.join();
    writer.join();
    second.join();

    QCOMPARE(home.load(), 3);
    QCOMPARE(open.laser->closedInFlight(), 0);
}

void UsbCdcTest::whatArrivesIsReadWithItsTime()
{
    OpenLaser open;
    std::array<std::uint8_t, 64> into{};
    const auto before = steadyClock().now();
    open.laser->send(Bytes{1, 2, 3, 4});

    const auto arrival = open.link->read(into, in(10s), {});

    QVERIFY(arrival);
    QCOMPARE(arrival->count, std::size_t(4));
    QVERIFY(arrival->at >= before && arrival->at <= steadyClock().now());
    QCOMPARE(into[3], std::uint8_t(4));
}

void UsbCdcTest::twoArrivalsAreNotMerged()
{
    OpenLaser open;
    open.laser->send(Bytes(70, 1));
    open.laser->send(Bytes(30, 2));
    std::array<std::uint8_t, 200> into{};

    const auto first = open.link->read(into, in(10s), {});
    const auto second = open.link->read(into, in(10s), {});

    QCOMPARE(first->count, std::size_t(70));
    QCOMPARE(second->count, std::size_t(30));
    QVERIFY(second->at >= first->at);
}

void UsbCdcTest::emptyPacketsAreNothing()
{
    OpenLaser open;
    for (int i = 0; i < 100; ++i)
        open.laser->send({}, true);
    open.laser->send(Bytes(128, 7), true);
    std::array<std::uint8_t, 200> into{};

    const auto arrival = open.link->read(into, in(10s), {});

    QCOMPARE(arrival->count, std::size_t(128));
    QVERIFY(comesTrue([&] { return open.laser->transfersIn() == 8; }));
}

void UsbCdcTest::eightTransfersWaitAtAllTimes()
{
    OpenLaser open;
    QCOMPARE(open.laser->transfersIn(), 8);

    open.laser->send(Bytes(10, 1));

    QCOMPARE(readBytes(*open.link, 10).size(), std::size_t(10));
    QVERIFY(comesTrue([&] { return open.laser->transfersIn() == 8; }));
}

void UsbCdcTest::wholePacketsWithoutAnEndAreFetched()
{
    OpenLaser open;
    for (std::uint32_t i = 0; i < 5; ++i) {
        const Bytes sent = pattern(64 * (1 + 3 * i), i);
        open.laser->send(sent);
        QCOMPARE(readBytes(*open.link, sent.size()), sent);
    }
    QCOMPARE(open.laser->freedIn(), 0);
}

void UsbCdcTest::moreThanAllTransfersHoldComesInOrder()
{
    OpenLaser open;
    const Bytes sent = pattern(20 * 16 * 1024 + 77, 3);

    open.laser->send(sent);

    QVERIFY(readBytes(*open.link, sent.size()) == sent);
}

void UsbCdcTest::whatIsSentArrivesByteByByte()
{
    OpenLaser open;
    Bytes received;
    open.laser->onReceive(
        [&](std::span<const std::uint8_t> bytes) { received.insert(received.end(), bytes.begin(), bytes.end()); });
    const Bytes sent = pattern(50'000, 9);

    QVERIFY(open.link->write(kRequest, in(10s)));
    QVERIFY(open.link->write(sent, in(10s)));

    Bytes both = kRequest;
    both.insert(both.end(), sent.begin(), sent.end());
    QVERIFY(received == both);
}

void UsbCdcTest::nothingIsSentForNothing()
{
    OpenLaser open;
    int calls = 0;
    open.laser->onReceive([&](std::span<const std::uint8_t>) { ++calls; });

    QVERIFY(open.link->write({}, in(10s)));

    QCOMPARE(calls, 0);
}

void UsbCdcTest::whatADeviceDoesNotTakeIsAnErrorAtTheDeadline()
{
    OpenLaser open;
    open.laser->blockOut();
    const auto began = steadyClock().now();

    const auto written = open.link->write(kRequest, in(50ms));

    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::DeviceLost);
    QVERIFY2(written.error().message.find("3 bytes") != std::string::npos, written.error().message.c_str());
    QVERIFY(steadyClock().now() - began >= 50ms);
    QCOMPARE(open.laser->transfersOut(), 0);
}

void UsbCdcTest::aDeviceThatTakesAPartIsToldOfInTheError()
{
    OpenLaser open;
    open.laser->blockOut(64);

    const auto written = open.link->write(pattern(100, 1), in(50ms));

    QVERIFY(!written);
    QVERIFY2(written.error().message.find("36 bytes") != std::string::npos, written.error().message.c_str());
}

void UsbCdcTest::aLinkWorksOnAfterADeadline()
{
    OpenLaser open;
    open.laser->blockOut();
    QVERIFY(!open.link->write(kRequest, in(20ms)));

    open.laser->unblockOut();

    QVERIFY(open.link->write(kRequest, in(10s)));
    open.laser->send(Bytes{5});
    QCOMPARE(readBytes(*open.link, 1), Bytes{5});
}

void UsbCdcTest::aStallIsFreedUpToThreeTimes()
{
    OpenLaser open;
    for (std::uint32_t times = 1; times <= 3; ++times) {
        const Bytes sent = pattern(1000, times);
        open.laser->stallIn(static_cast<int>(times));
        open.laser->send(sent);
        QCOMPARE(readBytes(*open.link, sent.size()), sent);
    }
    QCOMPARE(open.laser->freedIn(), 1 + 2 + 3);
    QVERIFY(comesTrue([&] { return open.laser->transfersIn() == 8; }));
}

void UsbCdcTest::aFourthStallInARowEndsTheLink()
{
    OpenLaser open;
    open.laser->stallIn(4);
    open.laser->send(Bytes(10, 1));

    const auto why = readToTheEnd(*open.link);

    QVERIFY(why);
    QCOMPARE(why->code, ErrorCode::DeviceLost);
    QVERIFY2(why->message.find("stall") != std::string::npos, why->message.c_str());
    QCOMPARE(open.laser->freedIn(), 3);
    QCOMPARE(open.link->write(kRequest, in(1s)).error().message, why->message);
    open.link->close();
    QCOMPARE(open.laser->closedInFlight(), 0);
}

void UsbCdcTest::whatCameBeforeAStallIsKept()
{
    OpenLaser open;
    const Bytes sent = pattern(128 + 50, 4);
    open.laser->send(std::span{sent}.first(128));  // whole packets: the transfer goes on
    open.laser->stallIn(1);
    open.laser->send(std::span{sent}.subspan(128));

    QCOMPARE(readBytes(*open.link, sent.size()), sent);
}

void UsbCdcTest::aPacketThatIsTooLongIsSurvived()
{
    OpenLaser open;
    open.laser->sendPacket(Bytes(100, 1));
    open.laser->send(Bytes(20, 2));

    // What fits into a packet has come; the rest of it is lost, and what follows is not.
    Bytes expected(64, 1);
    expected.insert(expected.end(), 20, 2);
    QCOMPARE(readBytes(*open.link, expected.size()), expected);
    QCOMPARE(open.laser->freedIn(), 1);
}

void UsbCdcTest::aStallWhileSendingIsFreedUpToThreeTimes()
{
    OpenLaser open;
    Bytes received;
    open.laser->onReceive(
        [&](std::span<const std::uint8_t> bytes) { received.insert(received.end(), bytes.begin(), bytes.end()); });

    open.laser->stallOut(3);
    QVERIFY(open.link->write(kRequest, in(10s)));
    QCOMPARE(received, kRequest);

    open.laser->stallOut(4);
    const auto written = open.link->write(kRequest, in(10s));
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::DeviceLost);
    QCOMPARE(received, kRequest);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UsbCdcTest)
#include "usb_cdc_test.moc"
