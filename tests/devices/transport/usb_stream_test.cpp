// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <sys/resource.h>
#include <thread>

#include <QtTest>

#include "devices/transport/usb_cdc.h"
#include "devices/transport/usb_ftdi.h"
#include "tests/devices/transport/usb_rig.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class UsbStreamTest : public QObject {
    Q_OBJECT

private slots:
    void everyByteOfFortyFramesASecondComes();
    void anAdapterThatSaysNothingCostsLittle();
};

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kFrame = 3372;  // 1081 beams at 3 characters, with sums, echo and time stamp
constexpr auto kPeriod = 25ms;

/// Processor time of this process: the laser's and libusb's and the reader's.
std::chrono::nanoseconds processorTime()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto of = [](const timeval& time) {
        return std::chrono::seconds{time.tv_sec} + std::chrono::microseconds{time.tv_usec};
    };
    return of(usage.ru_utime) + of(usage.ru_stime);
}

/// What a stream of scans may cost with its emulated device [%]. A machine under test is granted ten times as much.
constexpr double kMostShare = 3.0;
constexpr double kMargin = 10.0;
/// Requests to the kernel that a packet may cost: one that fetches it, one that waits for the next, and one that finds
/// nothing more. Emulated ones cost far more time than true ones, so that the share of the processor tells little.
constexpr double kMostRequests = 6.0;

double shareOfAProcessor(std::chrono::nanoseconds usedBefore, std::chrono::nanoseconds since)
{
    return 100.0 * std::chrono::duration<double>(processorTime() - usedBefore) /
           std::chrono::duration<double>(steadyClock().now() - since);
}

/// Does something at equal times; what comes late is made up for.
template <class What>
void every(std::chrono::nanoseconds period, int times, What what)
{
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    auto due = steadyClock().now();
    for (int i = 0; i < times; ++i, due += period) {
        while (steadyClock().now() < due)
            steadyClock().wait(lock, never, {}, due);
        what(i);
    }
}

/// Sends frame after frame at the times of a laser.
void sendFrames(EmulatedUsbDevice& laser, std::uint32_t frames)
{
    every(kPeriod, static_cast<int>(frames),
          [&](int i) { laser.send(pattern(kFrame, static_cast<std::uint32_t>(i))); });
}

}  // namespace

void UsbStreamTest::everyByteOfFortyFramesASecondComes()
{
    const std::uint32_t frames = qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG") ? 2400 : 80;
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 4);
    auto link = openUsbCdc(rig.bus, rig.devices(1).at(0), steadyClock());
    QVERIFY(link);
    const auto began = steadyClock().now();
    const auto used = processorTime();
    const long requests = rig.usb.requests();

    std::jthread sender{[&] { sendFrames(*laser, frames); }};
    for (std::uint32_t i = 0; i < frames; ++i)
        QVERIFY2(readBytes(**link, kFrame) == pattern(kFrame, i), qPrintable(QString("frame %1").arg(i)));
    sender.join();

    const double share = shareOfAProcessor(used, began);
    qInfo("%u frames, every byte as it was sent; %.1f %% of a processor with the emulated laser, %.1f requests a frame",
          frames, share, static_cast<double>(rig.usb.requests() - requests) / frames);
    QVERIFY2(share < kMargin * kMostShare, qPrintable(QString::number(share)));
}

/// A converter of FTDI sends two bytes of its state every millisecond, though nothing is on the line.
void UsbStreamTest::anAdapterThatSaysNothingCostsLittle()
{
    const int milliseconds = qEnvironmentVariableIsSet("PLANEWRIGHT_TEST_LONG") ? 60'000 : 2'000;
    UsbRig rig;
    const auto adapter = rig.usb.plug(ft232rModel(), 4);
    const auto link = UsbFtdi::open(rig.bus, rig.devices(1).at(0), 57'142, steadyClock());
    QVERIFY(link);
    const auto began = steadyClock().now();
    const auto used = processorTime();
    const long requests = rig.usb.requests();

    std::jthread sender{[&] { every(1ms, milliseconds, [&](int) { adapter->sendPacket({0x01, 0x60}); }); }};
    std::array<std::uint8_t, 64> into{};
    const auto arrival = (*link)->read(into, began + std::chrono::milliseconds{milliseconds}, {});
    sender.join();

    QVERIFY(arrival && arrival->count == 0);
    QVERIFY(comesTrue([&] { return adapter->unread() == 0; }));
    const double share = shareOfAProcessor(used, began);
    const double each = static_cast<double>(rig.usb.requests() - requests) / milliseconds;
    qInfo(
        "an idle adapter: %.1f %% of a processor with the emulated one, %.1f requests for each of 1000 packets a "
        "second",
        share, each);
    QVERIFY2(each <= kMostRequests, qPrintable(QString::number(each)));
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UsbStreamTest)
#include "usb_stream_test.moc"
