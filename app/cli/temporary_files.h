// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <csignal>
#include <cstddef>
#include <string>

namespace planewright {

/// Most temporary files at a time.
inline constexpr std::size_t kMaxTemporaryFiles = 64;

/// From here on SIGINT, SIGTERM and SIGHUP remove the temporary files and end the program with 128 + signal, and a
/// closed pipe or a limit on file sizes is an error of writing instead of a signal.
void handleSignals();

/// Holds these signals back while it lives: what happens meanwhile happens wholly or not at all.
class SignalsHeldBack {
public:
    SignalsHeldBack();
    ~SignalsHeldBack();
    SignalsHeldBack(const SignalsHeldBack&) = delete;
    SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;

private:
    sigset_t before_;
};

/// Creates a new empty file with a name of its own in a folder and notes it for removal at a signal. Gives its
/// descriptor, open for writing, or −1 with errno set (ENFILE beyond kMaxTemporaryFiles).
int createTemporaryFile(const std::string& folder, std::string& path);

/// Forgets a temporary file that has been renamed.
void forgetTemporaryFile(const std::string& path);

/// Removes a temporary file, and forgets it.
void removeTemporaryFile(const std::string& path);

}  // namespace planewright
