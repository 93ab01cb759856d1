// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <string>
#include <vector>

struct z_stream_s;

namespace planewright {

/// The bytes of a stream; those of a gzip stream (by its first two bytes) are inflated on the way, member after member.
/// Holds a fixed amount of memory whatever the stream contains.
class ByteSource {
public:
    /// Why there are no more bytes.
    enum class End {
        NotYet,
        Complete,
        CutShort,    ///< the compressed data stop in the middle; what came before is right
        Corrupt,     ///< the compressed data are damaged
        Garbage,     ///< something else follows the compressed data
        Unreadable,  ///< the stream itself failed
    };

    explicit ByteSource(std::istream& in);

    /// Puts at most `size` bytes to `to` and gives their number; 0 at the end, and then end() says why.
    std::size_t read(char* to, std::size_t size);

    End end() const { return end_; }

private:
    struct Inflater {
        void operator()(z_stream_s* stream) const;
    };

    bool fill();
    std::size_t readPlain(char* to, std::size_t size);
    std::size_t readInflated(char* to, std::size_t size);

    std::istream& in_;
    std::vector<char> input_;
    std::size_t next_ = 0;  ///< first byte of input_ that has not been used
    std::size_t last_ = 0;  ///< one past its last byte
    std::unique_ptr<z_stream_s, Inflater> inflater_;
    bool betweenMembers_ = false;
    bool afterFirstMember_ = false;
    End end_ = End::NotYet;
};

/// What is wrong where there are no more bytes; empty where nothing is.
std::string problemText(ByteSource::End end);

}  // namespace planewright
