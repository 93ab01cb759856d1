// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/dialogue_writer.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace planewright {

namespace {

constexpr int kEveryonesToRead = 0644;

std::string firstLines(const std::string& device)
{
    const std::span bytes{reinterpret_cast<const std::uint8_t*>(device.data()), device.size()};
    return std::string{kDialogueFirstLine} + "\n# " +
           dialogueText(bytes.first(std::min<std::size_t>(bytes.size(), kMostDialogueBytes))) + "\n";
}

}  // namespace

Result<std::unique_ptr<DialogueWriter>> DialogueWriter::create(const std::string& path, const std::string& device,
                                                               OnTrouble onTrouble)
{
    Descriptor file{::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kEveryonesToRead)};
    if (!file.isOpen())
        return fail(ErrorCode::NotWritten,
                    path + (errno == EEXIST ? ": exists already; give another name"
                                            : ": cannot be written (" + std::generic_category().message(errno) + ")"));
    return begin(std::move(file), path, device, std::move(onTrouble));
}

Result<std::unique_ptr<DialogueWriter>> DialogueWriter::begin(Descriptor file, const std::string& path,
                                                              const std::string& device, OnTrouble onTrouble)
{
    std::unique_ptr<DialogueWriter> writer{new DialogueWriter(std::move(file), path, std::move(onTrouble))};
    writer->waiting_ = firstLines(device);
    try {
        writer->thread_ = std::thread{[writing = writer.get()] { writing->run(); }};
    } catch (const std::system_error&) {
        return fail(ErrorCode::NotWritten, path + ": the system has no threads left; end other programs");
    }
    return writer;
}

DialogueWriter::DialogueWriter(Descriptor file, std::string path, OnTrouble onTrouble)
    : file_(std::move(file)), path_(std::move(path)), onTrouble_(std::move(onTrouble))
{
}

DialogueWriter::~DialogueWriter()
{
    finish();
}

void DialogueWriter::add(DialogueEvent event)
{
    const std::scoped_lock lock(mutex_);
    if (isFinished_ || isLost_ || !trouble_.empty())
        return;
    isLost_ = event.kind == DialogueEvent::Kind::Lost;
    last_ = std::max(last_, event.at);
    event.at = last_;
    const std::string lines = dialogueLines(event);
    if (waiting_.size() + lines.size() > kMostWaiting) {
        endBecause("the disk is too slow");
        return;
    }
    waiting_ += lines;
    changed_.notify_all();
}

void DialogueWriter::finish()
{
    {
        const std::scoped_lock lock(mutex_);
        isFinished_ = true;
        changed_.notify_all();
    }
    const std::scoped_lock lock(joining_);
    if (thread_.joinable())
        thread_.join();
}

std::string DialogueWriter::trouble() const
{
    const std::scoped_lock lock(mutex_);
    return trouble_;
}

void DialogueWriter::run()
{
    writeWhatWaits();
    file_.reset();
}

void DialogueWriter::writeWhatWaits()
{
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return isFinished_ || !waiting_.empty(); });
        if (waiting_.empty())
            return;
        const std::string text = std::exchange(waiting_, {});
        lock.unlock();
        const bool isWritten = writeAll(text);
        const int error = errno;
        lock.lock();
        if (!isWritten) {
            endBecause(std::generic_category().message(error));
            waiting_.clear();
            return;
        }
    }
}

bool DialogueWriter::writeAll(const std::string& text)
{
    const off_t begin = ::lseek(file_.number(), 0, SEEK_CUR);
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t written = ::write(file_.number(), text.data() + done, text.size() - done);
        if (written >= 0) {
            done += static_cast<std::size_t>(written);
        } else if (errno != EINTR) {
            const int error = errno;
            // Half a line would be read as another dialogue: it ends with the last one that is whole.
            const std::size_t lineEnd = text.rfind('\n', done == 0 ? 0 : done - 1);
            const std::size_t whole = done == 0 || lineEnd == std::string::npos ? 0 : lineEnd + 1;
            [[maybe_unused]] const int cut = ::ftruncate(file_.number(), begin + static_cast<off_t>(whole));
            errno = error;
            return false;
        }
    }
    return true;
}

/// Called under the lock: the dialogue ends here.
void DialogueWriter::endBecause(std::string why)
{
    if (!trouble_.empty())
        return;
    trouble_ = path_ + ": the dialogue is recorded no further (" + std::move(why) + "); the scan goes on without it";
    if (onTrouble_)
        onTrouble_(trouble_);
}

}  // namespace planewright
