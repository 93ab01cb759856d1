// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/devices/transport/emulated_usb_device.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <linux/ioctl.h>
#include <linux/usbdevice_fs.h>

namespace planewright {

namespace {

constexpr EmulatedUsbDevice::Answer kDone{0, 0};

EmulatedUsbDevice::Answer refusal(int error)
{
    return {-1, error};
}

constexpr std::size_t kSetupSize = 8;
constexpr int kGetDescriptor = 6;
constexpr int kStringDescriptor = 3;

std::uint16_t word(const std::uint8_t* bytes)
{
    return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
}

std::uint8_t* bufferOf(const usbdevfs_urb* urb)
{
    return static_cast<std::uint8_t*>(urb->buffer);
}

std::span<const std::uint8_t> bytesOf(const usbdevfs_urb* urb)
{
    return {bufferOf(urb), static_cast<std::size_t>(urb->buffer_length)};
}

}  // namespace

void EmulatedUsbDevice::onReceive(std::function<void(std::span<const std::uint8_t>)> receive)
{
    const std::scoped_lock lock(mutex_);
    receive_ = std::move(receive);
}

void EmulatedUsbDevice::send(std::span<const std::uint8_t> bytes, bool withEmptyPacket)
{
    const std::scoped_lock lock(mutex_);
    while (!bytes.empty()) {
        const auto packet = bytes.first(std::min(bytes.size(), model_.packetSize));
        packets_.emplace_back(packet.begin(), packet.end());
        bytes = bytes.subspan(packet.size());
    }
    if (withEmptyPacket)
        packets_.emplace_back();
    moveIn();
}

void EmulatedUsbDevice::sendPacket(Bytes packet)
{
    const std::scoped_lock lock(mutex_);
    packets_.push_back(std::move(packet));
    moveIn();
}

void EmulatedUsbDevice::stallIn(int times)
{
    const std::scoped_lock lock(mutex_);
    stallsIn_ = times;
    moveIn();
}

void EmulatedUsbDevice::stallOut(int times)
{
    const std::scoped_lock lock(mutex_);
    stallsOut_ = times;
}

void EmulatedUsbDevice::blockOut(std::size_t after)
{
    const std::scoped_lock lock(mutex_);
    blocksOut_ = true;
    takesBeforeBlock_ = after;
}

void EmulatedUsbDevice::unblockOut()
{
    const std::scoped_lock lock(mutex_);
    blocksOut_ = false;
}

std::vector<EmulatedUsbDevice::Setting> EmulatedUsbDevice::settings() const
{
    const std::scoped_lock lock(mutex_);
    return settings_;
}

void EmulatedUsbDevice::refuse(std::uint8_t request)
{
    const std::scoped_lock lock(mutex_);
    refused_.insert(request);
}

void EmulatedUsbDevice::leaveSettingsUnanswered()
{
    const std::scoped_lock lock(mutex_);
    answersSettings_ = false;
}

void EmulatedUsbDevice::loseDrivers()
{
    const std::scoped_lock lock(mutex_);
    drivers_.assign(drivers_.size(), "");
}

void EmulatedUsbDevice::keep(int interface)
{
    const std::scoped_lock lock(mutex_);
    kept_.insert(interface);
}

int EmulatedUsbDevice::transfersIn() const
{
    const std::scoped_lock lock(mutex_);
    return static_cast<int>(waitingIn_.size());
}

int EmulatedUsbDevice::transfersOut() const
{
    const std::scoped_lock lock(mutex_);
    return static_cast<int>(waitingOut_.size());
}

int EmulatedUsbDevice::freedIn() const
{
    const std::scoped_lock lock(mutex_);
    return freedIn_;
}

int EmulatedUsbDevice::closedInFlight() const
{
    const std::scoped_lock lock(mutex_);
    return closedInFlight_;
}

std::size_t EmulatedUsbDevice::unread() const
{
    const std::scoped_lock lock(mutex_);
    return packets_.size();
}

bool EmulatedUsbDevice::isClaimed(int interface) const
{
    const std::scoped_lock lock(mutex_);
    return claims_.contains(interface);
}

std::vector<int> EmulatedUsbDevice::released() const
{
    const std::scoped_lock lock(mutex_);
    return released_;
}

std::string EmulatedUsbDevice::driver(int interface) const
{
    const std::scoped_lock lock(mutex_);
    return drivers_.at(static_cast<std::size_t>(interface));
}

void EmulatedUsbDevice::plugIn(std::function<void(bool)> gate)
{
    const std::scoped_lock lock(mutex_);
    isThere_ = true;
    gate_ = std::move(gate);
    drivers_ = model_.drivers;
    claims_.clear();
    packets_.clear();
    isHaltedIn_ = isHaltedOut_ = false;
}

void EmulatedUsbDevice::pullOut(const std::function<void()>& hangUp)
{
    const std::scoped_lock lock(mutex_);
    isThere_ = false;
    hangUp();
    for (auto* queue : {&waitingIn_, &waitingOut_, &waitingControl_}) {
        for (const Transfer& transfer : std::exchange(*queue, {}))
            finish(transfer, -ESHUTDOWN);
    }
}

EmulatedUsbDevice::Answer EmulatedUsbDevice::ioctl(const void* opener, unsigned long request, void* argument)
{
    if (request == USBDEVFS_SUBMITURB)
        return submit(opener, static_cast<usbdevfs_urb*>(argument));
    const std::scoped_lock lock(mutex_);
    const auto number = [&] { return *static_cast<unsigned*>(argument); };
    switch (request) {
        case USBDEVFS_GET_CAPABILITIES:
            *static_cast<unsigned*>(argument) = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                                USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_BULK_SCATTER_GATHER |
                                                USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
            return kDone;
        case USBDEVFS_REAPURB:
        case USBDEVFS_REAPURBNDELAY:
            return reap(opener, static_cast<usbdevfs_urb**>(argument));
        default:
            break;
    }
    if (!isThere_)
        return refusal(ENODEV);
    switch (request) {
        case USBDEVFS_DISCARDURB:
            return discard(static_cast<usbdevfs_urb*>(argument));
        case USBDEVFS_CLAIMINTERFACE:
            return claim(opener, static_cast<int>(number()), false);
        case USBDEVFS_DISCONNECT_CLAIM:
            return claim(opener, static_cast<int>(static_cast<usbdevfs_disconnect_claim*>(argument)->interface), true);
        case USBDEVFS_RELEASEINTERFACE:
            return release(opener, static_cast<int>(number()));
        case USBDEVFS_CLEAR_HALT:
            return clearHalt(number());
        case USBDEVFS_GETDRIVER: {
            auto& wanted = *static_cast<usbdevfs_getdriver*>(argument);
            if (!has(static_cast<int>(wanted.interface)) || drivers_[wanted.interface].empty())
                return refusal(ENODATA);
            std::strncpy(wanted.driver, drivers_[wanted.interface].c_str(), USBDEVFS_MAXDRIVERNAME);
            return kDone;
        }
        case USBDEVFS_IOCTL: {
            const auto& wanted = *static_cast<usbdevfs_ioctl*>(argument);
            if (!has(wanted.ifno))
                return refusal(EINVAL);
            auto& driver = drivers_[static_cast<std::size_t>(wanted.ifno)];
            driver = static_cast<unsigned>(wanted.ioctl_code) == USBDEVFS_CONNECT
                         ? model_.drivers[static_cast<std::size_t>(wanted.ifno)]
                         : "";
            return {1, 0};
        }
        default:
            return refusal(ENOTTY);
    }
}

void EmulatedUsbDevice::closed(const void* opener)
{
    const std::scoped_lock lock(mutex_);
    const auto isOfOpener = [&](const Transfer& transfer) { return transfer.opener == opener; };
    bool isInFlight = !finished_[opener].empty();
    for (auto* queue : {&waitingIn_, &waitingOut_, &waitingControl_})
        isInFlight = std::erase_if(*queue, isOfOpener) > 0 || isInFlight;
    closedInFlight_ += isInFlight ? 1 : 0;
    finished_.erase(opener);
    std::erase_if(claims_, [&](const auto& claim) { return claim.second == opener; });
    updateGate();
}

EmulatedUsbDevice::Answer EmulatedUsbDevice::submit(const void* opener, usbdevfs_urb* urb)
{
    if (urb->type == USBDEVFS_URB_TYPE_BULK && urb->endpoint == model_.out)
        return submitOut(opener, urb);
    const std::scoped_lock lock(mutex_);
    if (!isThere_)
        return refusal(ENODEV);
    if (urb->type == USBDEVFS_URB_TYPE_CONTROL)
        return submitControl(opener, urb);
    const bool hasClaim = std::any_of(claims_.begin(), claims_.end(), [&](auto& c) { return c.second == opener; });
    if (urb->type != USBDEVFS_URB_TYPE_BULK || urb->endpoint != model_.in || !hasClaim)
        return refusal(ENOENT);
    waitingIn_.push_back({opener, urb});
    moveIn();
    return kDone;
}

EmulatedUsbDevice::Answer EmulatedUsbDevice::submitControl(const void* opener, usbdevfs_urb* urb)
{
    Transfer transfer{opener, urb};
    const std::uint8_t* setup = bufferOf(urb);
    if (setup[1] == kGetDescriptor && setup[3] == kStringDescriptor) {
        finish(transfer, answerString(transfer) ? 0 : -EPIPE);
        return kDone;
    }
    settings_.push_back({setup[0], setup[1], word(setup + 2), word(setup + 4),
                         Bytes(setup + kSetupSize, setup + kSetupSize + word(setup + 6))});
    if (!answersSettings_)
        waitingControl_.push_back(transfer);
    else
        finish(transfer, refused_.contains(setup[1]) ? -EPIPE : 0);
    return kDone;
}

bool EmulatedUsbDevice::answerString(const Transfer& transfer)
{
    const std::uint8_t* setup = bufferOf(transfer.urb);
    Bytes answer{2, kStringDescriptor};
    const auto text = model_.strings.find(setup[2]);
    if (setup[2] == 0)
        answer.insert(answer.end(), {0x09, 0x04});  // English
    else if (text == model_.strings.end())
        return false;
    else {
        for (const char c : text->second)
            answer.insert(answer.end(), {static_cast<std::uint8_t>(c), 0});
    }
    answer[0] = static_cast<std::uint8_t>(answer.size());
    const std::size_t count = std::min<std::size_t>(answer.size(), word(setup + 6));
    std::copy_n(answer.begin(), count, bufferOf(transfer.urb) + kSetupSize);
    transfer.urb->actual_length = static_cast<int>(count);
    return true;
}

EmulatedUsbDevice::Answer EmulatedUsbDevice::submitOut(const void* opener, usbdevfs_urb* urb)
{
    std::function<void(std::span<const std::uint8_t>)> receive;
    Transfer transfer{opener, urb};
    int status = 0;
    bool isBlocked = false;
    {
        const std::scoped_lock lock(mutex_);
        if (!isThere_)
            return refusal(ENODEV);
        receive = receive_;
        transfer.done = static_cast<std::size_t>(urb->buffer_length);
        if (isHaltedOut_ || stallsOut_ > 0) {
            isHaltedOut_ = true;
            transfer.done = 0;
            status = -EPIPE;
        } else if (blocksOut_) {
            isBlocked = takesBeforeBlock_ < transfer.done;
            transfer.done = std::min(transfer.done, takesBeforeBlock_);
            takesBeforeBlock_ -= transfer.done;
        }
        if (isBlocked)
            waitingOut_.push_back(transfer);
    }
    // Without the lock, since the far end may answer at once.
    if (receive && transfer.done > 0)
        receive(bytesOf(urb).first(transfer.done));
    if (!isBlocked) {
        const std::scoped_lock lock(mutex_);
        finish(transfer, status);
    }
    return kDone;
}

EmulatedUsbDevice::Answer EmulatedUsbDevice::reap(const void* opener, usbdevfs_urb** urb)
{
    auto& finished = finished_[opener];
    if (finished.empty())
        return refusal(isThere_ ? EAGAIN : ENODEV);
    *urb = finished.front();
    finished.pop_front();
    updateGate();
    return kDone;
}

EmulatedUsbDevice::Answer EmulatedUsbDevice::discard(usbdevfs_urb* urb)
{
    for (auto* queue : {&waitingIn_, &waitingOut_, &waitingControl_}) {
        const auto found =
            std::find_if(queue->begin(), queue->end(), [&](const Transfer& each) { return each.urb == urb; });
        if (found == queue->end())
            continue;
        const Transfer transfer = *found;
        queue->erase(found);
        finish(transfer, -ENOENT);
        return kDone;
    }
    return refusal(EINVAL);
}

EmulatedUsbDevice::Answer EmulatedUsbDevice::claim(const void* opener, int interface, bool withDriver)
{
    if (!has(interface))
        return refusal(EINVAL);
    std::string& driver = drivers_[static_cast<std::size_t>(interface)];
    const bool isTaken = claims_.contains(interface) && claims_.at(interface) != opener;
    if (isTaken || driver == "usbfs" || (!driver.empty() && (!withDriver || kept_.contains(interface))))
        return refusal(EBUSY);
    driver.clear();
    claims_[interface] = opener;
    return kDone;
}

EmulatedUsbDevice::Answer EmulatedUsbDevice::release(const void* opener, int interface)
{
    const auto claim = claims_.find(interface);
    if (claim == claims_.end() || claim->second != opener)
        return refusal(EINVAL);
    claims_.erase(claim);
    released_.push_back(interface);
    return kDone;
}

EmulatedUsbDevice::Answer EmulatedUsbDevice::clearHalt(unsigned endpoint)
{
    if (endpoint == model_.in) {
        ++freedIn_;
        if (std::exchange(isHaltedIn_, false))
            --stallsIn_;
        moveIn();
    } else if (endpoint == model_.out && std::exchange(isHaltedOut_, false)) {
        --stallsOut_;
    }
    return kDone;
}

void EmulatedUsbDevice::finish(const Transfer& transfer, int status)
{
    transfer.urb->status = status;
    if (transfer.urb->type == USBDEVFS_URB_TYPE_BULK)
        transfer.urb->actual_length = static_cast<int>(transfer.done);
    finished_[transfer.opener].push_back(transfer.urb);
    updateGate();
}

/// A transfer ends when it is full or with a packet that is not, as USB 2.0 5.8.3 has it.
void EmulatedUsbDevice::moveIn()
{
    if (stallsIn_ > 0 && !isHaltedIn_ && !waitingIn_.empty()) {
        isHaltedIn_ = true;
        finish(waitingIn_.front(), -EPIPE);
        waitingIn_.pop_front();
    }
    while (!isHaltedIn_ && !waitingIn_.empty() && !packets_.empty()) {
        Transfer& first = waitingIn_.front();
        const Bytes packet = std::move(packets_.front());
        packets_.pop_front();
        const std::size_t room = static_cast<std::size_t>(first.urb->buffer_length) - first.done;
        const std::size_t count = std::min({packet.size(), room, model_.packetSize});
        std::copy_n(packet.begin(), count, bufferOf(first.urb) + first.done);
        first.done += count;
        const bool isTooLong = packet.size() > count;
        if (!isTooLong && packet.size() == model_.packetSize && count < room)
            continue;
        finish(first, isTooLong ? -EOVERFLOW : 0);
        waitingIn_.pop_front();
        if (isTooLong) {  // host controllers halt the endpoint as they do after a stall
            isHaltedIn_ = true;
            ++stallsIn_;
        }
    }
}

void EmulatedUsbDevice::updateGate()
{
    const bool hasFinished =
        std::any_of(finished_.begin(), finished_.end(), [](const auto& each) { return !each.second.empty(); });
    if (gate_)
        gate_(hasFinished);
}

bool EmulatedUsbDevice::has(int interface) const
{
    return interface >= 0 && static_cast<std::size_t>(interface) < drivers_.size();
}

}  // namespace planewright
