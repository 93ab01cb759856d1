// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "devices/clock.h"
#include "devices/transport/dialogue_file.h"
#include "devices/transport/transport.h"

namespace planewright {

/// A link to a dialogue that was recorded: answers what the device answered, as long as the host says what it said.
///
/// Bytes from the device come when the host has said all that it had said before them: at the recorded pace as long
/// after it as then, with that time of arrival; or at once. A host that says anything else ends the link with an error
/// that names the file, the line and the place where it differs. After the last event the device is silent.
class ReplayedDialogue : public Transport {
public:
    enum class Pace { Recorded, AsFastAsPossible };

    /// Reads the whole file once, so that what is wrong with it shows before anything is played. The dialogue begins
    /// now. Errors (Unreadable) as of DialogueReader.
    static Result<std::unique_ptr<ReplayedDialogue>> open(const std::string& path, Pace pace, const Clock& clock);

    std::string name() const override { return path_; }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override;
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override;
    void close() override;

    /// Whether all that the host had said was said, and all that the device had was read.
    bool isPlayed();

private:
    using Time = std::chrono::nanoseconds;
    /// What the host said, up to a number of its bytes, and how much later than in the record.
    struct Turn {
        std::uint64_t bytes;
        Time later;
    };

    ReplayedDialogue(std::string path, DialogueReader host, DialogueReader device, Pace pace, const Clock& clock);

    /// Makes `next_` what comes next from the device; it stays empty at the end.
    Result<void> lookAhead();
    /// When that is due, as long as the host has said what it had said before.
    std::optional<Time> due(Time now);
    Arrival give(std::span<std::uint8_t> into, Time at);
    /// Makes `expected_` what the host must say next, of which something is left; false where it must say nothing more.
    Result<bool> expect();
    /// Takes what the host says as far as the expected line goes; gives the rest. Errors: it says something else.
    Result<std::span<const std::uint8_t>> hear(std::span<const std::uint8_t> bytes);
    tl::unexpected<Error> endWith(const std::string& why);
    tl::unexpected<Error> endAtLoss(const DialogueReader& reader, const DialogueEvent& loss);

    std::string path_;
    Pace pace_;
    const Clock& clock_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Error> over_;

    DialogueReader host_;  ///< the file is read twice at once: what the host says next, and what the device does
    std::optional<DialogueEvent> expected_;
    std::size_t said_ = 0;         ///< bytes of `expected_` that the host has said
    std::uint64_t saidInAll_ = 0;  ///< bytes that the host has said
    std::deque<Turn> turns_;       ///< that the device has not come to yet

    DialogueReader device_;
    std::optional<DialogueEvent> next_;
    std::size_t given_ = 0;     ///< bytes of `next_` that were read
    std::uint64_t needed_ = 0;  ///< bytes that the host had said before `next_`
    Time later_;                ///< how much later than in the record it is
    Time lastDue_;
    bool deviceIsDone_ = false;
};

}  // namespace planewright
