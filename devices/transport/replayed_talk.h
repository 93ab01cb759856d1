// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "devices/clock.h"
#include "devices/transport/dialogue_file.h"
#include "devices/transport/dialogue_speech.h"
#include "devices/transport/replayed_dialogue.h"
#include "devices/transport/transport.h"

namespace planewright {

/// A recorded dialogue whose messages are understood: the host need not say the same bytes at the same moments, but
/// must mean the same. ReplayedDialogue is for everything else.
///
/// Questions may be left out, up to kMostLeftOut in a row, and asked more often than then, up to kMostRepeated times in
/// a row. So may a message be that was repeated to the byte. What the device says comes as long after the message
/// before it as then (Pace::Recorded), or at once. A host that means something else ends the link with an error that
/// names the file and the moment. After the last event the device is silent.
class ReplayedTalk : public Transport {
public:
    using Pace = ReplayedDialogue::Pace;
    static constexpr int kMostLeftOut = 64;
    static constexpr int kMostRepeated = 256;

    /// Reads the whole file. The dialogue begins now. Errors (Unreadable) as of DialogueReader.
    static Result<std::unique_ptr<ReplayedTalk>> open(const std::string& path, Pace pace,
                                                      std::unique_ptr<DialogueSpeech> speech, const Clock& clock);

    std::string name() const override { return path_; }
    Result<Arrival> read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                         const std::stop_token& stop) override;
    Result<void> write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds deadline) override;
    void close() override;

    /// Whether all that the host had said was said or left out, and all that the device had was read.
    bool isPlayed();

private:
    using Time = std::chrono::nanoseconds;
    using Bytes = DialogueSpeech::Bytes;

    /// What the host has said, then.
    struct Message {
        Time at;
        Bytes bytes;
        DialogueSpeech::Meaning meaning;
    };
    /// What the device has said, then, and how many messages of the host came before it.
    struct Answer {
        Time at;
        Bytes bytes;
        std::size_t after;
        bool isLoss;
    };
    /// Bytes that the host of now can read, and from when on.
    struct Due {
        Time at;
        Bytes bytes;
        std::size_t given;
    };

    ReplayedTalk(std::string path, Pace pace, std::unique_ptr<DialogueSpeech> speech, const Clock& clock);
    void add(DialogueEvent event);

    std::optional<std::size_t> find(const DialogueSpeech::Meaning& meaning) const;
    void skipTo(std::size_t message);
    bool repeat(const DialogueSpeech::Meaning& meaning);
    /// Puts what the device says next into `due_`, where the host has said all that came before it.
    void release(Time now);
    Time dueAt(Time then, Time now) const;
    tl::unexpected<Error> endWith(const std::string& why);

    std::string path_;
    Pace pace_;
    std::unique_ptr<DialogueSpeech> speech_;
    const Clock& clock_;
    std::vector<Message> messages_;
    std::vector<Answer> answers_;

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Error> over_;
    std::size_t said_ = 0;      ///< messages that were said or left out
    std::size_t answered_ = 0;  ///< answers that were released or left out
    int repeated_ = 0;          ///< questions in a row that the record has not
    Time later_;                ///< how much later than in the record the last message was
    Time inAll_;                ///< and the last one that was no question
    Time lastDue_;
    std::deque<Due> due_;
};

}  // namespace planewright
