// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/console.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <mutex>
#include <unistd.h>
#include <utility>

namespace planewright {

namespace {

constexpr std::string_view kClearLine = "\r\x1b[K";

/// The line that is printed in place, and the one that was waited with last.
struct Waiting {
    std::mutex mutex;
    std::string last;
    bool isShown = false;
};

Waiting& waiting()
{
    static Waiting waiting;
    return waiting;
}

std::string printable(std::string line)
{
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = '?';
    }
    return line;
}

void printLine(std::string line)
{
    line = printable(std::move(line)) + "\n";
    const std::scoped_lock lock{waiting().mutex};
    if (std::exchange(waiting().isShown, false))
        line.insert(0, kClearLine);
    std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace

void reserveStandardStreams()
{
    // Open for reading only: to write to a closed standard output stays an error.
    int descriptor = 0;
    do {
        descriptor = ::open("/dev/null", O_RDONLY);
    } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
    if (descriptor >= 0)
        ::close(descriptor);
}

void printError(std::string_view message)
{
    printLine("planewright-cli: " + std::string{message});
}

void printNote(std::string_view message)
{
    printLine("planewright-cli: " + std::string{message});
}

void printWarning(std::string_view message)
{
    printLine("planewright-cli: warning: " + std::string{message});
}

void printWaiting(const std::string& line)
{
    const bool isTerminal = ::isatty(STDERR_FILENO) == 1;
    const std::scoped_lock lock{waiting().mutex};
    if (std::exchange(waiting().last, line) == line)
        return;
    const std::string text = "planewright-cli: " + printable(line);
    const std::string whole = isTerminal ? std::string{kClearLine} + text : text + "\n";
    waiting().isShown = isTerminal;
    std::fwrite(whole.data(), 1, whole.size(), stderr);
    std::fflush(stderr);
}

Result<void> print(std::string_view text)
{
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
        return {};
    return fail(ErrorCode::NotWritten, std::string{"standard output: "} + std::strerror(errno) +
                                           "; send it to a file or program that takes it");
}

}  // namespace planewright
