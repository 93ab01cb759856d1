// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/devices/transport/emulated_usb.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <pty.h>
#include <stdexcept>
#include <sys/stat.h>
#include <termios.h>
#include <umockdev.h>
#include <unistd.h>
#include <utility>

namespace planewright {

namespace {

constexpr int kFirstAddress = 2;  // 1 is the root hub
constexpr int kAddresses = 120;

void require(bool holds, const char* what)
{
    if (!holds)
        throw std::runtime_error(what);
}

std::string digits(int number)
{
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%03d", number);
    return text.data();
}

std::string devnodeOf(int address)
{
    return "/dev/bus/usb/001/" + digits(address);
}

std::string hex(const std::vector<std::uint8_t>& bytes)
{
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += "0123456789ABCDEF"[byte >> 4];
        text += "0123456789ABCDEF"[byte & 15];
    }
    return text;
}

/// A node on which a program can wait: a terminal that takes output only while there is something to fetch. The plain
/// file that umockdev would make is always ready, and waiting for it takes a whole processor.
class Node {
public:
    Node(const std::filesystem::path& path, bool mayOpen)
    {
        std::array<char, 64> name{};
        require(openpty(&far_, &near_, name.data(), nullptr, nullptr) == 0, "no pseudo terminal");
        termios settings{};
        tcgetattr(near_, &settings);
        cfmakeraw(&settings);
        tcsetattr(near_, TCSANOW, &settings);
        ready(false);
        require(mayOpen || chmod(name.data(), 0) == 0, "no way to forbid a node");
        std::filesystem::create_directories(path.parent_path());
        std::filesystem::remove(path);
        std::filesystem::create_symlink(name.data(), path);
    }
    ~Node()
    {
        hangUp();
        ::close(near_);
    }
    Node(const Node&) = delete;
    Node& operator=(const Node&) = delete;

    void ready(bool isReady) { tcflow(near_, isReady ? TCOON : TCOOFF); }

    /// Whoever waits is told of an error, as Linux does for a device that is gone.
    void hangUp()
    {
        if (far_ >= 0)
            ::close(far_);
        far_ = -1;
    }

private:
    int near_ = -1;
    int far_ = -1;
};

/// A device where it is plugged in. Stays until the testbed goes, since a program may hold the node open for long.
struct Socket {
    std::shared_ptr<EmulatedUsbDevice> device;
    int address = 0;
    std::string sysfs;
    std::string devnode;
    std::unique_ptr<Node> node;
    UMockdevIoctlBase* handler = nullptr;
    std::atomic<long>* requests = nullptr;
    bool isPlugged = true;
    bool isAttached = false;  ///< to the node, longer than it is plugged in: somebody may be about to open it

    static gboolean requested(UMockdevIoctlBase* /*handler*/, UMockdevIoctlClient* client, Socket* self)
    {
        ++*self->requests;
        // Program and device are in one process: the argument is the program's own pointer.
        void* argument = *reinterpret_cast<void**>(umockdev_ioctl_client_get_arg(client)->data);
        const auto answer = self->device->ioctl(
            client, static_cast<unsigned long>(umockdev_ioctl_client_get_request(client)), argument);
        umockdev_ioctl_client_complete(client, answer.result, answer.error);
        return TRUE;
    }
    static void opened(UMockdevIoctlBase* /*handler*/, UMockdevIoctlClient* client, Socket* self)
    {
        g_signal_connect(client, "notify::connected", G_CALLBACK(&Socket::closed), self);
    }
    static void closed(UMockdevIoctlClient* client, GParamSpec* /*property*/, Socket* self)
    {
        if (!umockdev_ioctl_client_get_connected(client))
            self->device->closed(client);
    }
};

/// umockdev's testbed takes a tenth of a second to end: all tests of a program have the same, and leave it empty.
UMockdevTestbed* sharedTestbed()
{
    static const std::unique_ptr<UMockdevTestbed, void (*)(UMockdevTestbed*)> testbed{
        umockdev_testbed_new(), [](UMockdevTestbed* each) { g_object_unref(each); }};
    return testbed.get();
}

}  // namespace

class EmulatedUsb::Testbed {
public:
    UMockdevTestbed* testbed = sharedTestbed();
    std::vector<std::unique_ptr<Socket>> sockets;
    int nextAddress = kFirstAddress;
    std::atomic<long> requests{0};

    Socket& find(const std::shared_ptr<EmulatedUsbDevice>& device) const
    {
        for (const auto& socket : sockets) {
            if (socket->device == device && socket->isPlugged)
                return *socket;
        }
        throw std::runtime_error("the device is not plugged in");
    }

    void add(const std::string& description)
    {
        GError* error = nullptr;
        if (umockdev_testbed_add_from_string(testbed, description.c_str(), &error) == FALSE)
            throw std::runtime_error(error->message);
    }

    void detach(Socket& socket) const
    {
        if (std::exchange(socket.isAttached, false))
            umockdev_testbed_detach_ioctl(testbed, socket.devnode.c_str(), nullptr);
    }

    /// Where the testbed keeps what programs see as a path.
    std::filesystem::path inside(const std::string& path) const
    {
        char* root = umockdev_testbed_get_root_dir(testbed);
        const std::string whole = root + path;
        g_free(root);
        return whole;
    }
};

namespace {

/// What umockdev is told of a device: its place in the system and its descriptors.
std::string describe(const std::string& sysfs, int address, const UsbModel& model)
{
    std::string text = "P: " + sysfs +
                       "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: BUSNUM=001\nE: DEVNUM=" + digits(address) +
                       "\nE: DEVNAME=" + devnodeOf(address) + "\n";
    text += "A: busnum=1\\n\nA: devnum=" + std::to_string(address) + "\\n\nA: speed=" + model.speed + "\\n\n";
    text += "A: bConfigurationValue=1\\n\nH: descriptors=" + hex(model.device) + hex(model.configuration) + "\n";
    if (model.stringsInSysfs) {
        for (const auto& [number, string] : model.strings)
            text += std::string{"A: "} +
                    (number == 1   ? "manufacturer"
                     : number == 2 ? "product"
                                   : "serial") +
                    "=" + string + "\\n\n";
    }
    return text + "\n";
}

std::string interfaceOf(const std::string& sysfs, std::size_t number)
{
    return sysfs + sysfs.substr(sysfs.rfind('/')) + ":1." + std::to_string(number);
}

std::string describeInterface(const std::string& sysfs, std::size_t number, const std::string& driver)
{
    std::string text = "P: " + interfaceOf(sysfs, number) + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\n";
    if (!driver.empty())
        text += "L: driver=../../../../bus/usb/drivers/" + driver + "\n";
    return text + "\n";
}

/// Where the kernel shows the serial port that a driver has made of the first interface.
std::string describePort(const std::string& sysfs, const std::string& driver, const std::string& port)
{
    const std::string between = driver == "cdc_acm" ? "" : "/" + port;
    return "P: " + interfaceOf(sysfs, 0) + between + "/tty/" + port + "\nN: " + port +
           "\nE: SUBSYSTEM=tty\nE: DEVNAME=/dev/" + port + "\n\n";
}

}  // namespace

EmulatedUsb::EmulatedUsb() : testbed_(std::make_unique<Testbed>())
{
    // A terminal that hangs up may be the controlling one of this process.
    std::signal(SIGHUP, SIG_IGN);
    static const bool hasHub = [this] {
        UsbModel hub;
        hub.device = {18, 1, 0x00, 0x02, 9, 0, 1, 64, 0x6B, 0x1D, 0x02, 0x00, 0x01, 0x06, 0, 0, 0, 1};
        hub.configuration = {9, 2, 25, 0, 1, 1, 0, 0xE0, 0, 9, 4, 0, 0, 1, 9, 0, 0, 0, 7, 5, 0x81, 3, 4, 0, 12};
        testbed_->add(describe("/devices/usb1", 1, hub));
        return true;
    }();
    require(hasHub, "no hub");
}

EmulatedUsb::~EmulatedUsb()
{
    for (const auto& socket : testbed_->sockets) {
        if (socket->isPlugged)
            unplug(socket->device);
        testbed_->detach(*socket);
        socket->device->plugIn({});  // its node goes
        g_signal_handlers_disconnect_by_data(socket->handler, socket.get());
        g_object_unref(socket->handler);
    }
}

std::shared_ptr<EmulatedUsbDevice> EmulatedUsb::plug(const UsbModel& model, int port)
{
    auto device = std::make_shared<EmulatedUsbDevice>(model);
    plugAgain(device, port);
    return device;
}

void EmulatedUsb::plugAgain(const std::shared_ptr<EmulatedUsbDevice>& device, int port)
{
    const UsbModel& model = device->model();
    auto& socket = *testbed_->sockets.emplace_back(std::make_unique<Socket>());
    socket.device = device;
    socket.address =
        std::exchange(testbed_->nextAddress, kFirstAddress + (testbed_->nextAddress - kFirstAddress + 1) % kAddresses);
    socket.requests = &testbed_->requests;
    socket.devnode = devnodeOf(socket.address);
    socket.node = std::make_unique<Node>(testbed_->inside(socket.devnode), model.mayOpen);
    device->plugIn([node = socket.node.get()](bool isReady) { node->ready(isReady); });
    for (const auto& before : testbed_->sockets) {
        if (before->devnode == socket.devnode)
            testbed_->detach(*before);
    }
    socket.handler = umockdev_ioctl_base_new();
    g_signal_connect(socket.handler, "handle-ioctl", G_CALLBACK(&Socket::requested), &socket);
    g_signal_connect(socket.handler, "client-connected", G_CALLBACK(&Socket::opened), &socket);
    umockdev_testbed_attach_ioctl(testbed_->testbed, socket.devnode.c_str(), socket.handler, nullptr);
    socket.isAttached = true;

    const std::string sysfs = "/devices/usb1/1-" + std::to_string(port);
    socket.sysfs = "/sys" + sysfs;
    std::string description = describe(sysfs, socket.address, model);
    for (std::size_t i = 0; model.driversInSysfs && i < model.drivers.size(); ++i)
        description += describeInterface(sysfs, i, model.drivers[i]);
    if (!model.serialPort.empty())
        description += describePort(sysfs, model.drivers[0], model.serialPort);
    testbed_->add(description);
}

void EmulatedUsb::unplug(const std::shared_ptr<EmulatedUsbDevice>& device, Unplugging order)
{
    Socket& socket = testbed_->find(device);
    const auto node = testbed_->inside(socket.devnode);
    if (order == Unplugging::TransfersOnly) {
        std::filesystem::remove(node);
    } else {
        // Whoever is about to open it finds a file, and a device that is gone behind it: the preload library keeps
        // something for ever of every node that cannot be opened, and has room for 50.
        const std::filesystem::path gone = node.string() + ".gone";
        std::ofstream{gone}.close();
        std::filesystem::rename(gone, node);
    }
    const auto tell = [&] { umockdev_testbed_uevent(testbed_->testbed, socket.sysfs.c_str(), "remove"); };
    if (order == Unplugging::EventFirst)
        tell();
    device->pullOut([&] { socket.node->hangUp(); });
    if (order == Unplugging::TransfersFirst)
        tell();
    socket.isPlugged = false;
    if (const std::string& port = device->model().serialPort; !port.empty()) {
        const std::string between = device->model().drivers[0] == "cdc_acm" ? "" : "/" + port;
        umockdev_testbed_remove_device(testbed_->testbed,
                                       (interfaceOf(socket.sysfs, 0) + between + "/tty/" + port).c_str());
    }
    for (std::size_t i = 0; device->model().driversInSysfs && i < device->model().drivers.size(); ++i)
        umockdev_testbed_remove_device(testbed_->testbed, interfaceOf(socket.sysfs, i).c_str());
    umockdev_testbed_remove_device(testbed_->testbed, socket.sysfs.c_str());
}

void EmulatedUsb::announceAgain(const std::shared_ptr<EmulatedUsbDevice>& device)
{
    umockdev_testbed_uevent(testbed_->testbed, testbed_->find(device).sysfs.c_str(), "add");
}

std::string EmulatedUsb::fileOf(const std::string& serialPort) const
{
    return testbed_->inside("/dev/" + serialPort);
}

int EmulatedUsb::address(const std::shared_ptr<EmulatedUsbDevice>& device) const
{
    return testbed_->find(device).address;
}

long EmulatedUsb::requests() const
{
    return testbed_->requests;
}

}  // namespace planewright
