// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "devices/clock.h"
#include "devices/transport/dialogue_writer.h"
#include "devices/transport/transport.h"

namespace planewright {

/// A link that is recorded, both ways, as it is used. What goes wrong with the record never disturbs the link.
class DialogueRecorder : public Transport {
public:
    /// Times in the record begin now.
    DialogueRecorder(std::unique_ptr<Transport> link, std::unique_ptr<DialogueWriter> writer, const Clock& clock);
    ~DialogueRecorder() override;

    std::string name() const override { return link_->name(); }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override;
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override;
    /// Comes back when the record is on the disk.
    void close() override;

    /// Empty, or a line about why the record is not complete. Any thread.
    std::string trouble() const { return writer_->trouble(); }
    /// That of the link, and where it has no trouble, that of the record.
    TransportHealth health() const override;

private:
    void add(DialogueEvent::Kind kind, std::chrono::nanoseconds at, std::span<const std::uint8_t> bytes);
    void addLoss(const Error& error);

    std::unique_ptr<Transport> link_;
    std::unique_ptr<DialogueWriter> writer_;
    const Clock& clock_;
    std::chrono::nanoseconds began_;
    std::atomic<bool> isClosed_{false};
};

}  // namespace planewright
