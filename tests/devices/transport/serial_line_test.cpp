// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/serial_line.h"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <numeric>
#include <thread>

#include <QTemporaryDir>
#include <QtTest>

#include "devices/transport/serial_settings.h"
#include "tests/devices/fake_clock.h"
#include "tests/devices/holds.h"
#include "tests/devices/transport/test_pty.h"
#include "tests/devices/transport/test_socket.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

class SerialLineTest : public QObject {
    Q_OBJECT

private slots:
    void everyByteGoesThroughAsItIs();
    void theSpeedIsSetThatWasAskedFor_data();
    void theSpeedIsSetThatWasAskedFor();
    void anArrivalHasTheTimeOfTheClock();
    void aSilentLineIsNotLost();
    void aHangUpIsTheEndAfterWhatCameBefore();
    void aLineThatHungUpTakesNothing();
    void theNameIsFreeAfterAHangUp();
    void aPortThatIsHeldIsBusy();
    void aPortThatWasClosedCanBeOpenedAgain();
    void aPortThatTakesNothingEndsTheLink();
    void closingWakesTheReader();
    void aPortThatIsNotThereIsExplained();
    void whatIsNoPortIsExplained();
    void noPermissionIsExplainedWithTheCommand();
    void aRuleForUdevIsForPortsOfUsbAlone();
};

namespace {

Result<std::unique_ptr<Transport>> openLine(const TestPty& pty, const Clock& clock = steadyClock())
{
    return openSerialLine(pty.path, 115200, clock);
}

}  // namespace

void SerialLineTest::everyByteGoesThroughAsItIs()
{
    const TestPty pty;
    const auto line = openLine(pty);
    QVERIFY2(line, line ? "" : line.error().message.c_str());
    // Line ends, XON, XOFF, end of file, interrupt, delete: a terminal would do something about each of them.
    std::string all(256, '\0');
    std::iota(all.begin(), all.end(), '\0');

    QVERIFY((*line)->write(asBytes(all), steadyClock().now() + kPatience));
    QVERIFY(receiveText(pty.master, all.size()) == all);
    QVERIFY(sendText(pty.master, all));

    QVERIFY(readText(**line, all.size()) == all);
    QCOMPARE((*line)->name(), pty.path);
}

void SerialLineTest::theSpeedIsSetThatWasAskedFor_data()
{
    QTest::addColumn<int>("baud");
    for (const int baud : {19200, 57142, 115200, 1000000, 4500000})
        QTest::addRow("%d", baud) << baud;
}

void SerialLineTest::theSpeedIsSetThatWasAskedFor()
{
    QFETCH(int, baud);
    const TestPty pty;

    const auto line = openSerialLine(pty.path, baud, steadyClock());

    QVERIFY2(line, line ? "" : line.error().message.c_str());
    QCOMPARE(baudOf(pty.master.number()), baud);
}

void SerialLineTest::anArrivalHasTheTimeOfTheClock()
{
    FakeClock clock{FakeClock::Kind::Stands};
    clock.advance(5s);
    const TestPty pty;
    const auto line = openLine(pty, clock);
    QVERIFY(line);
    QVERIFY(sendText(pty.master, "abc"));
    std::array<std::uint8_t, 8> into{};

    const auto arrival = (*line)->read(into, clock.now() + kPatience, {});

    QVERIFY(arrival);
    QCOMPARE(arrival->count, std::size_t{3});
    QVERIFY(arrival->at == 5s);
}

void SerialLineTest::aSilentLineIsNotLost()
{
    const TestPty pty;
    const auto line = openLine(pty);
    QVERIFY(line);
    std::array<std::uint8_t, 8> into{};

    const auto deadline = steadyClock().now() + 20ms;
    const auto arrival = (*line)->read(into, deadline, {});

    QVERIFY(arrival);
    QCOMPARE(arrival->count, std::size_t{0});
    QVERIFY(steadyClock().now() >= deadline);
}

void SerialLineTest::aHangUpIsTheEndAfterWhatCameBefore()
{
    TestPty pty;
    const auto line = openLine(pty);
    QVERIFY(line);
    QVERIFY(sendText(pty.master, "half a fra"));
    QCOMPARE(readText(**line, 10), std::string("half a fra"));

    pty.master.reset();

    QCOMPARE(readText(**line, 1), "<" + pty.path + ": the device is gone; plug it in again>");
}

void SerialLineTest::aLineThatHungUpTakesNothing()
{
    TestPty pty;
    const auto line = openLine(pty);
    QVERIFY(line);

    pty.master.reset();

    const auto written = (*line)->write(asBytes("QT\n"), steadyClock().now() + kPatience);
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::DeviceLost);
}

void SerialLineTest::theNameIsFreeAfterAHangUp()
{
    TestPty pty;
    const auto line = openLine(pty);
    QVERIFY(line);
    const auto isHeld = [&] {
        for (const auto& entry : std::filesystem::directory_iterator{"/proc/self/fd"}) {
            std::error_code error;
            if (std::filesystem::read_symlink(entry.path(), error).string().starts_with(pty.path))
                return true;
        }
        return false;
    };
    QVERIFY(isHeld());

    pty.master.reset();

    // Nobody reads, writes or closes: the descriptor is given back all the same.
    QTRY_VERIFY_WITH_TIMEOUT(!isHeld(), 30'000);
}

void SerialLineTest::aPortThatIsHeldIsBusy()
{
    const TestPty pty;
    const auto line = openLine(pty);
    QVERIFY(line);

    const auto second = openLine(pty);

    QVERIFY(!second);
    QCOMPARE(second.error().code, ErrorCode::NoDevice);
    QVERIFY2(second.error().message.starts_with(pty.path + ": another program holds the port"),
             second.error().message.c_str());
    // Whoever was refused has changed nothing.
    QVERIFY(sendText(pty.master, "abc"));
    QCOMPARE(readText(**line, 3), std::string("abc"));
}

void SerialLineTest::aPortThatWasClosedCanBeOpenedAgain()
{
    const TestPty pty;
    {
        const auto line = openLine(pty);
        QVERIFY(line);
        (*line)->close();
        const auto second = openLine(pty);
        QVERIFY2(second, second ? "" : second.error().message.c_str());
    }

    const auto third = openLine(pty);

    QVERIFY2(third, third ? "" : third.error().message.c_str());
    QVERIFY(sendText(pty.master, "abc"));
    QCOMPARE(readText(**third, 3), std::string("abc"));
}

void SerialLineTest::aPortThatTakesNothingEndsTheLink()
{
    const TestPty pty;
    const auto line = openLine(pty);
    QVERIFY(line);

    const auto written = (*line)->write(std::vector<std::uint8_t>(std::size_t{1} << 20), steadyClock().now() + 50ms);

    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::DeviceLost);
    QVERIFY2(holds(written.error().message, "did not take"), written.error().message.c_str());
}

void SerialLineTest::closingWakesTheReader()
{
    const TestPty pty;
    const auto line = openLine(pty);
    QVERIFY(line);
    std::atomic<bool> lost{false};
    std::jthread reader{[&] {
        std::array<std::uint8_t, 8> into{};
        lost = !(*line)->read(into, steadyClock().now() + 1h, {});
    }};

    (*line)->close();
    reader.join();

    QVERIFY(lost);
}

void SerialLineTest::aPortThatIsNotThereIsExplained()
{
    const auto line = openSerialLine("/dev/ttyNOWHERE7", 115200, steadyClock());

    QVERIFY(!line);
    QCOMPARE(line.error().code, ErrorCode::NoDevice);
    QVERIFY2(line.error().message.starts_with("/dev/ttyNOWHERE7: there is no such port; plug the device in"),
             line.error().message.c_str());
}

void SerialLineTest::whatIsNoPortIsExplained()
{
    const QTemporaryDir folder;
    const std::string file = folder.filePath("file").toStdString();
    QVERIFY(Descriptor{::open(file.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600)}.isOpen());

    for (const std::string& path : {std::string{"/dev/null"}, file, folder.path().toStdString()}) {
        const auto line = openSerialLine(path, 115200, steadyClock());

        QVERIFY(!line);
        QCOMPARE(line.error().code, ErrorCode::NoDevice);
        QVERIFY2(line.error().message.starts_with(path + ": is no serial port"), line.error().message.c_str());
    }
}

void SerialLineTest::noPermissionIsExplainedWithTheCommand()
{
    // Root may open anything, so that this is told of the text and not of a file.
    const std::string text = serialTroubleText(EACCES, "/dev/ttyUSB77");

    QVERIFY2(holds(text, "sudo usermod -aG dialout \"$USER\""), text.c_str());
    QVERIFY2(holds(text, "/etc/udev/rules.d/"), text.c_str());
    QVERIFY(holds(serialTroubleText(EACCES, "/dev/ttyACM77"), "/etc/udev/rules.d/"));
    QVERIFY2(holds(serialTroubleText(EBUSY, "/dev/ttyNOWHERE7"), "another program"), text.c_str());
}

void SerialLineTest::aRuleForUdevIsForPortsOfUsbAlone()
{
    const QTemporaryDir folder;
    const std::string name = folder.filePath("usb-FTDI_FT232R-if00-port0").toStdString();
    QVERIFY(QFile(folder.filePath("ttyUSB0")).open(QIODevice::WriteOnly));
    QVERIFY(QFile::link("ttyUSB0", QString::fromStdString(name)));

    const std::string text = serialTroubleText(EACCES, "/dev/ttyS0");

    QVERIFY2(holds(text, "sudo usermod -aG dialout \"$USER\""), text.c_str());
    QVERIFY2(!holds(text, "udev"), text.c_str());
    QVERIFY(holds(serialTroubleText(EACCES, name), "udev"));  // as in /dev/serial/by-id
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::SerialLineTest)
#include "serial_line_test.moc"
