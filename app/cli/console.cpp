// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/console.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

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

void printError(std::string_view message)
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
    return fail(ErrorCode::NotWritten, std::string{"standard output: "} + std::strerror(errno));
}

}  // namespace planewright
