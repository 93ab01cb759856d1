// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/cli/temporary_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include <climits>

namespace planewright {

namespace {

constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};

/// Paths as the signal handler needs them: no memory but this, changed only while signals are held back.
std::array<std::array<char, PATH_MAX>, kMaxTemporaryFiles> notedPaths{};

void removeAndEnd(int signal)
{
    for (const auto& path : notedPaths) {
        if (path[0] != '\0')
            ::unlink(path.data());
    }
    ::_exit(128 + signal);
}

std::array<char, PATH_MAX>* notedPath(const std::string& path)
{
    const auto found =
        std::find_if(notedPaths.begin(), notedPaths.end(), [&](const auto& noted) { return path == noted.data(); });
    return found == notedPaths.end() ? nullptr : &*found;
}

}  // namespace

void handleSignals()
{
    struct sigaction action {};
    action.sa_handler = removeAndEnd;
    ::sigfillset(&action.sa_mask);
    for (const int signal : kSignals) {
        // A signal that the parent had set to be ignored (nohup, a background job) stays ignored.
        struct sigaction before {};
        if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
            ::sigaction(signal, &action, nullptr);
    }
    // A closed pipe and the shell's limit on file sizes come as errors of write() instead.
    ::signal(SIGPIPE, SIG_IGN);
    ::signal(SIGXFSZ, SIG_IGN);
}

SignalsHeldBack::SignalsHeldBack()
{
    sigset_t held;
    ::sigemptyset(&held);
    for (const int signal : kSignals)
        ::sigaddset(&held, signal);
    ::sigprocmask(SIG_BLOCK, &held, &before_);
}

SignalsHeldBack::~SignalsHeldBack()
{
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

int createTemporaryFile(const std::string& folder, std::string& path)
{
    static int number = 0;
    const SignalsHeldBack heldBack;
    std::array<char, PATH_MAX>* note = notedPath("");
    if (note == nullptr) {
        errno = ENFILE;
        return -1;
    }
    for (;;) {
        path = folder + "/.planewright-" + std::to_string(::getpid()) + "-" + std::to_string(number++) + ".tmp";
        if (path.size() >= note->size()) {
            errno = ENAMETOOLONG;
            return -1;
        }
        const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOCTTY, 0666);
        if (descriptor >= 0)
            std::memcpy(note->data(), path.c_str(), path.size() + 1);
        if (descriptor >= 0 || errno != EEXIST)
            return descriptor;
    }
}

void forgetTemporaryFile(const std::string& path)
{
    const SignalsHeldBack heldBack;
    if (std::array<char, PATH_MAX>* note = notedPath(path); note != nullptr)
        (*note)[0] = '\0';
}

void removeTemporaryFile(const std::string& path)
{
    const SignalsHeldBack heldBack;
    ::unlink(path.c_str());
    forgetTemporaryFile(path);
}

}  // namespace planewright
