// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_ftdi.h"

#include <numeric>

#include <QtTest>

#include "tests/devices/transport/usb_rig.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class UsbFtdiTest : public QObject {
    Q_OBJECT

private slots:
    void anAdapterIsSetUpByteByByte();
    void aFastAdapterHasItsOwnDivisor();
    void aRateIsChangedWhileOpen();
    void aRateThatItLacksIsRefusedBeforeItIsTouched();
    void oneThatRefusesASettingIsNotOpened();
    void statusBytesAreTakenFromEveryPacket_data();
    void statusBytesAreTakenFromEveryPacket();
    void statusAloneIsNoArrival();
    void lostBytesAreCounted();
    void anAnswerComesBackThroughBothDirections();
    void itsInterfaceGoesBackToTheKernel();
    void whatIsSetAfterTheEndIsAnError();
};

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kFine = 0x60;     // transmitter empty
constexpr std::uint8_t kOverrun = 0x62;  // and bytes lost

/// An emulated adapter, and the transport to it.
struct OpenAdapter {
    explicit OpenAdapter(const UsbModel& model = ft232rModel(), int rate = 57'142) : adapter(rig.usb.plug(model, 2))
    {
        auto opened = UsbFtdi::open(rig.bus, rig.devices(1).at(0), rate, steadyClock());
        if (!opened)
            throw std::runtime_error(opened.error().message);
        link = std::move(*opened);
    }

    /// Sends bytes as the chip does: each packet begins with two bytes of status.
    void send(const Bytes& bytes, std::uint8_t status = kFine) const
    {
        const std::size_t room = adapter->model().packetSize - 2;
        for (std::size_t at = 0; at <= bytes.size(); at += room) {
            Bytes packet{0x01, status};
            const std::size_t end = std::min(bytes.size(), at + room);
            packet.insert(packet.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                          bytes.begin() + static_cast<std::ptrdiff_t>(end));
            adapter->sendPacket(std::move(packet));
        }
    }

    UsbRig rig;
    std::shared_ptr<EmulatedUsbDevice> adapter;
    std::unique_ptr<UsbFtdi> link;
};

using Setting = EmulatedUsbDevice::Setting;

}  // namespace

void UsbFtdiTest::anAdapterIsSetUpByteByByte()
{
    OpenAdapter open;

    const std::vector<Setting> expected{
        {0x40, 0, 0, 0, {}},       // reset
        {0x40, 0, 1, 0, {}},       // purge
        {0x40, 0, 2, 0, {}},       //
        {0x40, 3, 0x4034, 0, {}},  // 3 MHz / 52.5
        {0x40, 4, 0x0008, 0, {}},  // 8N1
        {0x40, 2, 0, 0, {}},       // no flow control
        {0x40, 9, 1, 0, {}},       // 1 ms
    };
    QVERIFY(open.adapter->settings() == expected);
    QCOMPARE(open.link->name(), std::string("usb 1-2"));
}

void UsbFtdiTest::aFastAdapterHasItsOwnDivisor()
{
    OpenAdapter open(ft232hModel(), 57'600);

    QVERIFY((open.adapter->settings().at(3) == Setting{0x40, 3, 0x00D0, 0x0300, {}}));
}

void UsbFtdiTest::aRateIsChangedWhileOpen()
{
    OpenAdapter open;

    QVERIFY(open.link->setRate(1'000'000));
    QVERIFY(open.link->setRate(57'600));
    const auto refused = open.link->setRate(2'500'000);

    const auto settings = open.adapter->settings();
    QCOMPARE(settings.size(), std::size_t(9));
    QVERIFY((settings[7] == Setting{0x40, 3, 0x0003, 0, {}}));
    QVERIFY((settings[8] == Setting{0x40, 3, 0xC034, 0, {}}));
    QCOMPARE(refused.error().code, ErrorCode::Usage);
}

void UsbFtdiTest::aRateThatItLacksIsRefusedBeforeItIsTouched()
{
    UsbRig rig;
    const auto adapter = rig.usb.plug(ft232rModel(), 2);

    const auto link = UsbFtdi::open(rig.bus, rig.devices(1).at(0), 5'000'000, steadyClock());

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::Usage);
    QVERIFY(adapter->settings().empty());
    QCOMPARE(adapter->driver(0), std::string("ftdi_sio"));
}

void UsbFtdiTest::oneThatRefusesASettingIsNotOpened()
{
    UsbRig rig;
    const auto adapter = rig.usb.plug(ft232rModel(), 2);
    adapter->refuse(3);

    const auto link = UsbFtdi::open(rig.bus, rig.devices(1).at(0), 57'142, steadyClock());

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::NoDevice);
    QVERIFY2(link.error().message.starts_with("usb 1-2 (0403:6001 USB Serial Converter): "),
             link.error().message.c_str());
    QVERIFY(!adapter->isClaimed(0));
}

void UsbFtdiTest::statusBytesAreTakenFromEveryPacket_data()
{
    QTest::addColumn<bool>("isFast");
    QTest::addColumn<int>("count");
    for (const bool isFast : {false, true}) {
        const int room = isFast ? 510 : 62;
        for (const int count : {1, room - 1, room, room + 1, 2 * room, 17 * room + 5, 40'000})
            QTest::addRow("%d bytes, packets of %d", count, room + 2) << isFast << count;
    }
}

void UsbFtdiTest::statusBytesAreTakenFromEveryPacket()
{
    QFETCH(bool, isFast);
    QFETCH(int, count);
    OpenAdapter open(isFast ? ft232hModel() : ft232rModel());
    const Bytes sent = pattern(static_cast<std::size_t>(count), 5);

    open.send(sent);

    QVERIFY(readBytes(*open.link, sent.size()) == sent);
    QCOMPARE(open.link->overruns(), std::uint64_t(0));
}

void UsbFtdiTest::statusAloneIsNoArrival()
{
    OpenAdapter open;
    for (int i = 0; i < 200; ++i)
        open.send({});
    open.send({7, 8});
    std::array<std::uint8_t, 64> into{};

    const auto arrival = open.link->read(into, in(10s), {});

    QCOMPARE(arrival->count, std::size_t(2));
    QCOMPARE(into[1], std::uint8_t(8));
}

void UsbFtdiTest::lostBytesAreCounted()
{
    OpenAdapter open;

    open.send({1}, kOverrun);
    open.send({2});
    open.send({}, kOverrun);
    open.send({3});

    QCOMPARE(readBytes(*open.link, 3), (Bytes{1, 2, 3}));
    QCOMPARE(open.link->overruns(), std::uint64_t(2));
    QCOMPARE(open.link->health().overruns, std::uint64_t(2));
}

void UsbFtdiTest::anAnswerComesBackThroughBothDirections()
{
    OpenAdapter open;
    const Bytes ping{0xFF, 0xFF, 0x01, 0x02, 0x01, 0xFB};
    const Bytes status{0xFF, 0xFF, 0x01, 0x02, 0x00, 0xFC};
    open.adapter->onReceive([&](std::span<const std::uint8_t> bytes) {
        if (std::equal(bytes.begin(), bytes.end(), ping.begin(), ping.end()))
            open.send(status);
    });

    QVERIFY(open.link->write(ping, in(10s)));

    QCOMPARE(readBytes(*open.link, status.size()), status);
    open.adapter->onReceive({});
}

void UsbFtdiTest::itsInterfaceGoesBackToTheKernel()
{
    OpenAdapter open;
    QVERIFY(open.adapter->isClaimed(0));

    open.link->close();

    QCOMPARE(open.adapter->released(), std::vector<int>{0});
    QCOMPARE(open.adapter->driver(0), std::string("ftdi_sio"));
    QCOMPARE(open.adapter->closedInFlight(), 0);
}

void UsbFtdiTest::whatIsSetAfterTheEndIsAnError()
{
    OpenAdapter open;
    open.rig.usb.unplug(open.adapter);

    const auto gone = open.link->setRate(1'000'000);
    open.link->close();
    const auto closed = open.link->setRate(1'000'000);

    QVERIFY(!gone && !closed);
    QCOMPARE(gone.error().code, ErrorCode::DeviceLost);
    QCOMPARE(closed.error().message, gone.error().message);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UsbFtdiTest)
#include "usb_ftdi_test.moc"
