// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QProcess>
#include <QtTest>

#include "devices/transport/port_holder.h"
#include "devices/transport/usb_cdc.h"
#include "devices/transport/usb_error.h"
#include "devices/transport/usb_ftdi.h"
#include "tests/devices/transport/far_end.h"
#include "tests/devices/transport/usb_rig.h"
#include "tests/test_program.h"

namespace planewright {

using namespace std::chrono_literals;

/// What keeps a device from being opened is told with its cure; which of two is which, their answers tell.
class UsbOpenTest : public QObject {
    Q_OBJECT

private slots:
    void whoHasNoRightIsToldTheRuleAndHowToInstallIt();
    void anotherProgramIsNamedAsTheHolder();
    void aKernelDriverThatDoesNotLetGoIsNamed();
    void aProgramThatHasItsSerialPortOpenKeepsIt_data();
    void aProgramThatHasItsSerialPortOpenKeepsIt();
    void aSerialPortThatSomebodyUnseenHasLockedIsLeft();
    void afterAKilledProgramItIsOpenedAndGivenBackToTheKernel();
    void oneThatIsOpenHereIsNotOpenedAgain();
    void oneThatHasGoneIsNotOpened();
    void twoLasersThatAreAlikeAreToldApartByWhatTheyAnswer();
    void theBusStaysUntilItsLastTransportGoes();
};

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Answers every line with its serial number, after a time.
class NamedLaser : public EmulatedDevice {
public:
    explicit NamedLaser(std::string serial) : serial_(std::move(serial)) {}

    void receive(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds now) override
    {
        line_.append(bytes.begin(), bytes.end());
        if (!line_.ends_with('\n'))
            return;
        const std::string answer = line_ + "SERI:" + serial_ + "\n\n";
        answers_.push_back({now + 3ms, Bytes(answer.begin(), answer.end())});
        line_.clear();
    }
    std::vector<EmulatedOutput> takeOutput(std::chrono::nanoseconds now) override
    {
        std::vector<EmulatedOutput> due;
        while (!answers_.empty() && answers_.front().at <= now) {
            due.push_back(std::move(answers_.front()));
            answers_.erase(answers_.begin());
        }
        return due;
    }
    std::optional<std::chrono::nanoseconds> nextOutput() const override
    {
        return answers_.empty() ? std::nullopt : std::optional{answers_.front().at};
    }
    bool isConnected(std::chrono::nanoseconds /*now*/) override { return true; }

private:
    std::string serial_;
    std::string line_;
    std::vector<EmulatedOutput> answers_;
};

/// A program that has locked a file, and of which nobody may see what it has open, as if another user ran it.
class HiddenProgram {
public:
    explicit HiddenProgram(const std::string& path) : process_(fork())
    {
        if (process_ != 0)
            return;
        prctl(PR_SET_DUMPABLE, 0);
        flock(::open(path.c_str(), O_RDONLY), LOCK_EX);
        for (;;)
            pause();
    }
    ~HiddenProgram()
    {
        ::kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    HiddenProgram(const HiddenProgram&) = delete;
    HiddenProgram& operator=(const HiddenProgram&) = delete;

private:
    pid_t process_;
};

std::string textOf(const Bytes& bytes)
{
    return {bytes.begin(), bytes.end()};
}

}  // namespace

void UsbOpenTest::whoHasNoRightIsToldTheRuleAndHowToInstallIt()
{
    UsbRig rig;
    UsbModel model = cdcModel();
    model.mayOpen = false;
    rig.usb.plug(model, 1);

    const auto link = openUsbCdc(rig.bus, rig.devices(1).at(0), steadyClock());

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::NoDevice);
    const std::string& message = link.error().message;
    QVERIFY2(message.starts_with("usb 1-1 (15d1:0000 URG-Series USB Driver): you have no right"), message.c_str());
    QVERIFY2(message.ends_with(usbPermissionCommand()), message.c_str());
    QVERIFY(usbPermissionCommand().starts_with("sudo cp "));
    QVERIFY(
        usbPermissionCommand().ends_with("60-planewright.rules /etc/udev/rules.d/ && sudo udevadm control --reload "
                                         "&& sudo udevadm trigger"));
    QVERIFY(message.find('\n') == std::string::npos);
}

void UsbOpenTest::anotherProgramIsNamedAsTheHolder()
{
    UsbRig rig;
    UsbModel model = cdcModel();
    model.drivers = {"usbfs", "usbfs"};
    const auto laser = rig.usb.plug(model, 1);

    const auto link = openUsbCdc(rig.bus, rig.devices(1).at(0), steadyClock());

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::NoDevice);
    QVERIFY2(link.error().message.ends_with("another program has it; close that program"),
             link.error().message.c_str());
    QVERIFY(!laser->isClaimed(0));
}

void UsbOpenTest::aKernelDriverThatDoesNotLetGoIsNamed()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 1);
    QVERIFY(comesTrue([&] { return !rig.bus->devices().empty() && rig.bus->devices()[0].driver == "cdc_acm"; }));
    laser->keep(1);

    const auto link = openUsbCdc(rig.bus, rig.bus->devices().at(0), steadyClock());

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::NoDevice);
    QVERIFY2(link.error().message.find("the kernel driver cdc_acm does not give it up") != std::string::npos,
             link.error().message.c_str());
    QCOMPARE(laser->released(), std::vector<int>{0});  // what it had got already
}

void UsbOpenTest::aProgramThatHasItsSerialPortOpenKeepsIt_data()
{
    QTest::addColumn<bool>("isModem");
    QTest::newRow("laser") << true;
    QTest::newRow("servo adapter") << false;
}

void UsbOpenTest::aProgramThatHasItsSerialPortOpenKeepsIt()
{
    QFETCH(bool, isModem);
    UsbRig rig;
    UsbModel model = isModem ? cdcModel() : ft232rModel();
    model.serialPort = isModem ? "ttyACM7" : "ttyUSB7";
    const std::string driver = model.drivers.at(0);
    const auto plugged = rig.usb.plug(model, 1);
    QProcess other;
    other.setStandardInputFile(QString::fromStdString(rig.usb.fileOf(model.serialPort)));
    other.start("sleep", {"600"});
    QVERIFY(other.waitForStarted());
    const auto open = [&](const UsbDevice& device) -> std::optional<Error> {
        if (isModem) {
            const auto link = openUsbCdc(rig.bus, device, steadyClock());
            return link ? std::nullopt : std::optional{link.error()};
        }
        const auto link = UsbFtdi::open(rig.bus, device, 57'142, steadyClock());
        return link ? std::nullopt : std::optional{link.error()};
    };
    QVERIFY(comesTrue([&] { return !rig.bus->devices().empty() && !rig.bus->devices()[0].holder.empty(); }));
    const UsbDevice device = rig.bus->devices().at(0);
    const std::string holder = "the program sleep (process " + std::to_string(other.processId()) + ")";
    QCOMPARE(device.holder, holder);
    QCOMPARE(device.access, UsbAccess::Busy);
    QCOMPARE(device.serialPort, "/dev/" + model.serialPort);

    const auto refused = open(device);

    QVERIFY(refused);
    QCOMPARE(refused->code, ErrorCode::NoDevice);
    QVERIFY2(refused->message.find(holder + " has its serial port /dev/" + model.serialPort + " open (kernel driver " +
                                   driver + "); close that program") != std::string::npos,
             refused->message.c_str());
    QCOMPARE(plugged->driver(0), driver);  // nothing was taken from it
    QVERIFY(!plugged->isClaimed(0));
    other.kill();
    QVERIFY(other.waitForFinished());
    const auto opened = open(device);
    QVERIFY2(!opened, opened ? opened->message.c_str() : "");
}

void UsbOpenTest::aSerialPortThatSomebodyUnseenHasLockedIsLeft()
{
    UsbRig rig;
    UsbModel model = cdcModel();
    model.serialPort = "ttyACM8";
    const auto laser = rig.usb.plug(model, 1);
    const UsbDevice device = rig.devices(1).at(0);
    const HiddenProgram other{rig.usb.fileOf("ttyACM8")};
    QVERIFY(comesTrue([&] { return holderOrLockOf("/dev/ttyACM8").has_value(); }));
    QVERIFY(!holderOf("/dev/ttyACM8"));

    const auto link = openUsbCdc(rig.bus, device, steadyClock());

    QVERIFY(!link);
    QVERIFY2(link.error().message.find("another program has its serial port /dev/ttyACM8 open") != std::string::npos,
             link.error().message.c_str());
    QVERIFY(!laser->isClaimed(0));
}

void UsbOpenTest::afterAKilledProgramItIsOpenedAndGivenBackToTheKernel()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 1);
    laser->loseDrivers();
    const auto device = rig.devices(1).at(0);
    QCOMPARE(device.access, UsbAccess::Openable);

    auto link = openUsbCdc(rig.bus, device, steadyClock());

    QVERIFY(link);
    laser->send(Bytes{1, 2});
    QCOMPARE(readBytes(**link, 2), (Bytes{1, 2}));
    link->reset();
    QVERIFY(comesTrue([&] { return laser->driver(0) == "cdc_acm" && laser->driver(1) == "cdc_acm"; }));
}

void UsbOpenTest::oneThatIsOpenHereIsNotOpenedAgain()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 1);
    const auto device = rig.devices(1).at(0);
    const auto link = openUsbCdc(rig.bus, device, steadyClock());
    QVERIFY(link);

    const auto second = openUsbCdc(rig.bus, device, steadyClock());

    QVERIFY(!second);
    QCOMPARE(second.error().code, ErrorCode::NoDevice);
    QCOMPARE(rig.bus->devices().at(0).access, UsbAccess::Busy);
    laser->send(Bytes{1, 2});
    QCOMPARE(readBytes(**link, 2), (Bytes{1, 2}));
}

void UsbOpenTest::oneThatHasGoneIsNotOpened()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 1);
    const auto device = rig.devices(1).at(0);
    rig.usb.unplug(laser);
    QVERIFY(rig.devices(0).empty());

    const auto link = openUsbCdc(rig.bus, device, steadyClock());

    QVERIFY(!link);
    QCOMPARE(link.error().code, ErrorCode::NoDevice);
    QVERIFY2(link.error().message.find("not there any more") != std::string::npos, link.error().message.c_str());
}

void UsbOpenTest::twoLasersThatAreAlikeAreToldApartByWhatTheyAnswer()
{
    UsbRig rig;
    const auto left = rig.usb.plug(cdcModel(), 1);
    const auto right = rig.usb.plug(cdcModel(), 2);
    const FarEnd leftLaser(left, std::make_shared<NamedLaser>("00903971"), steadyClock());
    const FarEnd rightLaser(right, std::make_shared<NamedLaser>("00905555"), steadyClock());
    const auto devices = rig.devices(2);
    QCOMPARE(devices.at(0).productName, devices.at(1).productName);

    const auto first = openUsbCdc(rig.bus, devices[0], steadyClock());
    const auto second = openUsbCdc(rig.bus, devices[1], steadyClock());
    QVERIFY(first && second);
    for (const auto& link : {first->get(), second->get()})
        QVERIFY(link->write(Bytes{'V', 'V', '\n'}, in(10s)));

    const std::string answer = "VV\nSERI:00903971\n\n";
    QCOMPARE(textOf(readBytes(**first, answer.size())), answer);
    QCOMPARE(textOf(readBytes(**second, answer.size())), std::string("VV\nSERI:00905555\n\n"));
}

void UsbOpenTest::theBusStaysUntilItsLastTransportGoes()
{
    UsbRig rig;
    const auto laser = rig.usb.plug(cdcModel(), 1);
    auto link = openUsbCdc(rig.bus, rig.devices(1).at(0), steadyClock());
    QVERIFY(link);

    rig.bus.reset();

    laser->send(Bytes{1, 2});
    QCOMPARE(readBytes(**link, 2), (Bytes{1, 2}));
    link->reset();
    QVERIFY(comesTrue([&] { return !laser->isClaimed(1); }));
    QCOMPARE(laser->closedInFlight(), 0);
}

}  // namespace planewright

PLANEWRIGHT_TEST(planewright::UsbOpenTest)
#include "usb_open_test.moc"
