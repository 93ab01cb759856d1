// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace planewright {

/// Compresses a text piece by piece as gzip. The header has neither time nor name nor system, so that the same text
/// gives the same bytes.
class GzipText {
public:
    GzipText();
    ~GzipText();

    /// Takes a piece in and appends to `compressed` what is ready; the last call has `finish`.
    void add(std::string_view piece, bool finish, std::string& compressed);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace planewright
