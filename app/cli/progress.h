// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace planewright {

/// One line on stderr that counts work, where stderr is a terminal and the work takes over a second; gone at its end.
class Progress {
public:
    explicit Progress(std::string_view what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(std::size_t done, std::size_t all);

private:
    std::string what_;
    bool onTerminal_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point next_;
};

}  // namespace planewright
