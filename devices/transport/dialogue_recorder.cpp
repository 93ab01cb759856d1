// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/dialogue_recorder.h"

#include <algorithm>
#include <utility>

namespace planewright {

DialogueRecorder::DialogueRecorder(std::unique_ptr<Transport> link, std::unique_ptr<DialogueWriter> writer,
                                   const Clock& clock)
    : link_(std::move(link)), writer_(std::move(writer)), clock_(clock), began_(clock.now())
{
}

DialogueRecorder::~DialogueRecorder()
{
    DialogueRecorder::close();
}

Result<Transport::Arrival> DialogueRecorder::read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                                                  const std::stop_token& stop)
{
    const Result<Arrival> arrival = link_->read(into, deadline, stop);
    if (!arrival)
        addLoss(arrival.error());
    else if (arrival->count > 0)
        add(DialogueEvent::Kind::FromDevice, arrival->at, into.first(arrival->count));
    return arrival;
}

Result<void> DialogueRecorder::write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline)
{
    // Before it is sent: the answer may be read by another thread before this call is over.
    if (!bytes.empty())
        add(DialogueEvent::Kind::ToDevice, clock_.now(), bytes);
    const Result<void> written = link_->write(bytes, deadline);
    if (!written)
        addLoss(written.error());
    return written;
}

TransportHealth DialogueRecorder::health() const
{
    TransportHealth health = link_->health();
    if (health.trouble.empty())
        health.trouble = trouble();
    return health;
}

void DialogueRecorder::close()
{
    isClosed_ = true;  // what the link says of it is no loss
    link_->close();
    writer_->finish();
}

void DialogueRecorder::add(DialogueEvent::Kind kind, std::chrono::nanoseconds at, std::span<const std::uint8_t> bytes)
{
    if (isClosed_)
        return;
    writer_->add({kind, std::max(at - began_, std::chrono::nanoseconds{0}), {bytes.begin(), bytes.end()}});
}

void DialogueRecorder::addLoss(const Error& error)
{
    const auto* text = reinterpret_cast<const std::uint8_t*>(error.message.data());
    add(DialogueEvent::Kind::Lost, clock_.now(), {text, error.message.size()});
}

}  // namespace planewright
