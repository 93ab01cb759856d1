// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <sys/resource.h>
#include <thread>

#include <QtTest>

#include "devices/transport/usb_cdc.h"
#include "tests/devices/transport/usb_rig.h"

namespace planewright {

using namespace std::chrono_literals;

class UsbStreamTest : public QObject {
    Q_OBJECT

private slots:
    void everyByteOfFortyFramesASecondComes();
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

/// Sends frame after frame at the times of a laser.
void sendFrames(EmulatedUsbDevice& laser, std::uint32_t frames)
{
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    auto due = steadyClock().now();
    for (std::uint32_t i = 0; i < frames; ++i, due += kPeriod) {
        while (steadyClock().now() < due)
            steadyClock().wait(lock, never, {}, due);
        laser.send(pattern(kFrame, i));
    }
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

    const auto share = 100.0 * std::chrono::duration<double>(processorTime() - used) /
                       std::chrono::duration<double>(steadyClock().now() - began);
    qInfo("%u frames, every byte as it was sent; %.1f %% of a processor with the emulated laser, %.1f requests a frame",
          frames, share, static_cast<double>(rig.usb.requests() - requests) / frames);
}

}  // namespace planewright

QTEST_GUILESS_MAIN(planewright::UsbStreamTest)
#include "usb_stream_test.moc"
