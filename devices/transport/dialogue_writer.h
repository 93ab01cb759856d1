// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/types/error.h"
#include "devices/transport/descriptor.h"
#include "devices/transport/dialogue_file.h"

namespace planewright {

/// Writes a dialogue to a file, on a thread of its own: whoever adds an event never waits for the disk.
///
/// A disk that is full or too slow ends the dialogue, never what is recorded: the file then holds whole lines only, and
/// trouble() tells.
class DialogueWriter {
public:
    /// Text that waits for the disk: half a minute of the fastest laser.
    static constexpr std::size_t kMostWaiting = std::size_t{4} << 20;

    /// Told once, with the line of trouble(), when the dialogue ends early, on any thread; it only takes note.
    using OnTrouble = std::function<void(const std::string&)>;

    /// Begins a file for a device of a name; an existing one is not touched. Errors (NotWritten), naming the file.
    static Result<std::unique_ptr<DialogueWriter>> create(const std::string& path, const std::string& device,
                                                          OnTrouble onTrouble = {});

    /// Begins in a file that is open, called `path` in messages. Errors as for create().
    static Result<std::unique_ptr<DialogueWriter>> begin(Descriptor file, const std::string& path,
                                                         const std::string& device, OnTrouble onTrouble = {});
    ~DialogueWriter();

    /// Appends an event. One that is earlier than what was added before is written with that one's time: two threads
    /// may tell of what happened at once. After a loss nothing more is written. Any thread.
    void add(DialogueEvent event);

    /// Writes what waits, and ends it. Twice is fine. Any thread.
    void finish();

    /// Empty, or a line about why the dialogue is not complete. Any thread.
    std::string trouble() const;

private:
    DialogueWriter(Descriptor file, std::string path, OnTrouble onTrouble);

    void run();
    /// Until it is finished or the disk takes no more.
    void writeWhatWaits();
    /// Writes a text; false where the disk does not take it.
    bool writeAll(const std::string& text);
    void endBecause(std::string why);

    Descriptor file_;
    std::string path_;
    OnTrouble onTrouble_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::string waiting_;
    std::chrono::nanoseconds last_{0};
    bool isLost_ = false;
    bool isFinished_ = false;
    std::string trouble_;
    std::mutex joining_;
    std::thread thread_;
};

}  // namespace planewright
