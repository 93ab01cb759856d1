// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/usb_pipe.h"

#include <algorithm>
#include <libusb.h>
#include <utility>

#include "devices/transport/usb_error.h"

namespace planewright {

namespace {

constexpr std::size_t kTransferSize = std::size_t{16} << 10;  // of whole packets, whatever their size
constexpr int kMostStalls = 3;
constexpr std::chrono::nanoseconds kFetchAfter = std::chrono::milliseconds{50};

}  // namespace

/// What libusb calls on the event thread.
class UsbPipe::Callbacks {
public:
    static void LIBUSB_CALL received(libusb_transfer* transfer)
    {
        auto& incoming = *static_cast<Incoming*>(transfer->user_data);
        incoming.pipe->arrived(incoming);
    }

    static void LIBUSB_CALL sent(libusb_transfer* transfer)
    {
        auto& pipe = *static_cast<UsbPipe*>(transfer->user_data);
        const std::scoped_lock lock(pipe.mutex_);
        pipe.isSending_ = false;
        pipe.changed_.notify_all();
    }
};

/// A call that needs the handle: close() waits for its end.
class UsbPipe::Call {
public:
    explicit Call(UsbPipe& pipe) : pipe_(pipe)
    {
        const std::scoped_lock lock(pipe_.mutex_);
        ++pipe_.calls_;
        mayBegin_ = !pipe_.isClosing_ && !pipe_.queue_.ended();
    }
    ~Call()
    {
        const std::scoped_lock lock(pipe_.mutex_);
        --pipe_.calls_;
        pipe_.changed_.notify_all();
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    /// False once the link has ended: the handle may be gone.
    bool mayBegin() const { return mayBegin_; }

private:
    UsbPipe& pipe_;
    bool mayBegin_ = false;
};

Result<std::unique_ptr<UsbPipe>> UsbPipe::open(std::shared_ptr<UsbBus> bus, const UsbDevice& device, const Clock& clock,
                                               const std::function<int(const UsbHandle&)>& setUp, Filter filter)
{
    std::unique_ptr<UsbPipe> self{new UsbPipe(device.name(), clock, std::move(filter))};
    auto handle =
        UsbHandle::open(std::move(bus), device, [pipe = self.get()] { pipe->queue_.end(usbGone(pipe->name_)); });
    if (!handle)
        return tl::unexpected<Error>(handle.error());
    self->handle_ = std::move(*handle);
    if (const int status = setUp(*self->handle_); status != LIBUSB_SUCCESS)
        return tl::unexpected<Error>(usbOpenError(device, status));
    if (const auto received = self->receive(); !received)
        return tl::unexpected<Error>(received.error());
    return self;
}

UsbPipe::UsbPipe(std::string name, const Clock& clock, Filter filter)
    : name_(std::move(name)), clock_(clock), filter_(std::move(filter)), queue_(clock, name_)
{
}

UsbPipe::~UsbPipe()
{
    close();
}

Result<Transport::Arrival> UsbPipe::read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                                         const std::stop_token& stop)
{
    for (;;) {
        auto arrival = queue_.read(into, std::min(deadline, nextFetch_), stop);
        const std::chrono::nanoseconds now = clock_.now();
        if (!arrival)
            return arrival;
        if (arrival->count == 0 && now >= nextFetch_)
            fetchOldest();
        if (arrival->count > 0 || now >= nextFetch_)
            nextFetch_ = now + kFetchAfter;
        if (arrival->count > 0 || now >= deadline || stop.stop_requested())
            return arrival;
    }
}

Result<void> UsbPipe::write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline)
{
    const Call call(*this);
    const std::scoped_lock writing(writing_);
    for (int stalls = 0; call.mayBegin() && !bytes.empty();) {
        const Sent sent = send(bytes.first(std::min(bytes.size(), kTransferSize)), deadline);
        bytes = bytes.subspan(sent.count);
        if (sent.status == LIBUSB_TRANSFER_COMPLETED && sent.count > 0)
            continue;
        if (queue_.ended() || (sent.status == LIBUSB_TRANSFER_CANCELLED && bytes.empty()))
            break;
        if (sent.status == LIBUSB_TRANSFER_CANCELLED)
            return fail(ErrorCode::DeviceLost, name_ + ": the device does not take what is sent to it (" +
                                                   std::to_string(bytes.size()) +
                                                   " bytes are left); check its power and connect it again");
        if (sent.status != LIBUSB_TRANSFER_STALL || ++stalls > kMostStalls)
            return tl::unexpected<Error>(usbFailed(name_, "sending"));
        libusb_clear_halt(handle_->get(), handle_->layout().out);
    }
    if (!bytes.empty() || !call.mayBegin())
        return tl::unexpected<Error>(whyEnded());
    return {};
}

void UsbPipe::close()
{
    std::unique_lock lock(mutex_);
    queue_.end(usbClosed(name_));
    if (std::exchange(isClosing_, true)) {
        changed_.wait(lock, [&] { return isClosed_; });
        return;
    }
    cancelAll();
    changed_.wait(lock, [&] { return inFlight_ == 0 && !isSending_ && calls_ == 0; });
    lock.unlock();
    mender_ = {};
    for (Incoming& incoming : incoming_)
        libusb_free_transfer(std::exchange(incoming.transfer, nullptr));
    libusb_free_transfer(std::exchange(outgoing_, nullptr));
    handle_.reset();
    lock.lock();
    isClosed_ = true;
    changed_.notify_all();
}

Result<void> UsbPipe::control(const UsbRequest& request)
{
    const Call call(*this);
    if (!call.mayBegin())
        return tl::unexpected<Error>(whyEnded());
    const int status = handle_->control(request);
    if (status == LIBUSB_SUCCESS)
        return {};
    if (status == LIBUSB_ERROR_NO_DEVICE) {
        failed(status);
        return tl::unexpected<Error>(whyEnded());
    }
    return tl::unexpected<Error>(usbFailed(name_, libusb_error_name(status)));
}

Result<void> UsbPipe::receive()
{
    const std::scoped_lock lock(mutex_);
    outgoing_ = libusb_alloc_transfer(0);
    for (Incoming& incoming : incoming_) {
        incoming.pipe = this;
        incoming.buffer.resize(kTransferSize);
        incoming.transfer = libusb_alloc_transfer(0);
        if (incoming.transfer == nullptr || outgoing_ == nullptr)
            return tl::unexpected<Error>(usbOpenError(handle_->device(), LIBUSB_ERROR_NO_MEM));
        libusb_fill_bulk_transfer(incoming.transfer, handle_->get(), handle_->layout().in, incoming.buffer.data(),
                                  static_cast<int>(kTransferSize), &Callbacks::received, &incoming, 0);
    }
    mender_ = std::jthread{[this](const std::stop_token& stop) { mendStalls(stop); }};
    submitAll();
    return {};
}

void UsbPipe::submitAll()
{
    for (Incoming& incoming : incoming_) {
        if (incoming.isInFlight || isStalled_ || isClosing_ || queue_.ended())
            continue;
        if (const int status = libusb_submit_transfer(incoming.transfer); status != LIBUSB_SUCCESS)
            return failed(status);
        incoming.number = ++submitted_;
        incoming.isInFlight = true;
        ++inFlight_;
    }
}

void UsbPipe::cancelAll()
{
    for (Incoming& incoming : incoming_) {
        if (incoming.isInFlight)
            libusb_cancel_transfer(incoming.transfer);
    }
    if (isSending_ && isClosing_)
        libusb_cancel_transfer(outgoing_);
}

void UsbPipe::fetchOldest()
{
    const std::scoped_lock lock(mutex_);
    Incoming* oldest = nullptr;
    for (Incoming& incoming : incoming_) {
        if (incoming.isInFlight && (oldest == nullptr || incoming.number < oldest->number))
            oldest = &incoming;
    }
    if (oldest != nullptr && !isClosing_)
        libusb_cancel_transfer(oldest->transfer);
}

void UsbPipe::arrived(Incoming& incoming)
{
    const auto status = incoming.transfer->status;
    // A transfer that was cancelled or timed out may have got something before.
    const auto bytes = std::span{incoming.buffer}.first(static_cast<std::size_t>(incoming.transfer->actual_length));
    queue_.push(filter_ ? bytes.first(filter_(bytes, handle_->layout().packetSize)) : bytes);

    const std::scoped_lock lock(mutex_);
    incoming.isInFlight = false;
    --inFlight_;
    if (!bytes.empty())
        stallsInARow_ = 0;
    if (status == LIBUSB_TRANSFER_NO_DEVICE)
        failed(LIBUSB_ERROR_NO_DEVICE);
    else if (status == LIBUSB_TRANSFER_STALL || status == LIBUSB_TRANSFER_OVERFLOW || status == LIBUSB_TRANSFER_ERROR)
        stalled(status == LIBUSB_TRANSFER_STALL      ? "stall"
                : status == LIBUSB_TRANSFER_OVERFLOW ? "overflow"
                                                     : "transfer error");
    submitAll();
    // Nobody else waits for this, and packets may come a thousand times a second.
    if (isClosing_ || isStalled_)
        changed_.notify_all();
}

void UsbPipe::stalled(const char* what)
{
    if (std::exchange(isStalled_, true))
        return;
    if (++stallsInARow_ > kMostStalls)
        queue_.end(usbFailed(name_, what));
    cancelAll();
}

void UsbPipe::failed(int error)
{
    queue_.end(error == LIBUSB_ERROR_NO_DEVICE ? usbGone(name_) : usbFailed(name_, libusb_error_name(error)));
}

void UsbPipe::mendStalls(const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [&] { return isStalled_ && inFlight_ == 0 && !isClosing_ && !queue_.ended(); })) {
        lock.unlock();
        libusb_clear_halt(handle_->get(), handle_->layout().in);  // whether it helped, the next transfer shows
        lock.lock();
        isStalled_ = false;
        submitAll();
    }
}

UsbPipe::Sent UsbPipe::send(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline)
{
    std::unique_lock lock(mutex_);
    if (isClosing_)
        return {LIBUSB_TRANSFER_CANCELLED, 0};
    sending_.assign(bytes.begin(), bytes.end());
    libusb_fill_bulk_transfer(outgoing_, handle_->get(), handle_->layout().out, sending_.data(),
                              static_cast<int>(sending_.size()), &Callbacks::sent, this, 0);
    if (const int status = libusb_submit_transfer(outgoing_); status != LIBUSB_SUCCESS) {
        failed(status);
        return {status, 0};
    }
    isSending_ = true;
    while (isSending_ && clock_.now() < deadline)
        clock_.wait(lock, changed_, {}, deadline);
    if (isSending_)
        libusb_cancel_transfer(outgoing_);
    changed_.wait(lock, [&] { return !isSending_; });
    if (outgoing_->status == LIBUSB_TRANSFER_NO_DEVICE)
        failed(LIBUSB_ERROR_NO_DEVICE);
    return {outgoing_->status, static_cast<std::size_t>(outgoing_->actual_length)};
}

Error UsbPipe::whyEnded() const
{
    return queue_.ended().value_or(usbClosed(name_));
}

}  // namespace planewright
