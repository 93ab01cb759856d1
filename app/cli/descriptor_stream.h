// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <ostream>
#include <streambuf>

namespace planewright {

/// Writes to a file descriptor, which it does not own, and remembers why that failed.
class DescriptorOutputBuffer : public std::streambuf {
public:
    explicit DescriptorOutputBuffer(int descriptor);

    int error() const { return error_; }  ///< errno of the first write that failed; 0 if none did

protected:
    int_type overflow(int_type c) override;
    int sync() override;
    std::streamsize xsputn(const char* text, std::streamsize size) override;

private:
    bool writeOut(const char* bytes, std::size_t size);
    bool flushBytes();

    int descriptor_;
    int error_ = 0;
    std::array<char, 1 << 16> bytes_;
};

}  // namespace planewright
