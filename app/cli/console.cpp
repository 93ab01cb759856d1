// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/console.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace planewright {

namespace {

void printLine(std::string line)
{
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = '?';
    }
    line += '\n';
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

Result<void> print(std::string_view text)
{
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
        return {};
    return fail(ErrorCode::NotWritten, std::string{"standard output: "} + std::strerror(errno) +
                                           "; send it to a file or program that takes it");
}

}  // namespace planewright
