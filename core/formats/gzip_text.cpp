// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/gzip_text.h"

#include <array>
#include <cassert>

#include <zlib.h>

namespace planewright {

namespace {
constexpr int kGzip = 15 + 16;  // the largest window, and a gzip header as zlib asks for it
constexpr int kMemory = 8;      // zlib's default
constexpr int kUnknownSystem = 255;
}  // namespace

struct GzipText::State {
    z_stream stream{};
    gz_header header{};
};

GzipText::GzipText() : state_(std::make_unique<State>())
{
    [[maybe_unused]] const int started =
        deflateInit2(&state_->stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY);
    assert(started == Z_OK);
    state_->header.os = kUnknownSystem;
    deflateSetHeader(&state_->stream, &state_->header);
}

GzipText::~GzipText()
{
    deflateEnd(&state_->stream);
}

void GzipText::add(std::string_view piece, bool finish, std::string& compressed)
{
    z_stream& stream = state_->stream;
    std::array<char, std::size_t{32} * 1024> ready;
    // zlib's interface predates const; it does not write here.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(piece.data()));
    stream.avail_in = static_cast<uInt>(piece.size());
    do {
        stream.next_out = reinterpret_cast<Bytef*>(ready.data());
        stream.avail_out = static_cast<uInt>(ready.size());
        deflate(&stream, finish ? Z_FINISH : Z_NO_FLUSH);
        compressed.append(ready.data(), ready.size() - stream.avail_out);
    } while (stream.avail_out == 0);
}

}  // namespace planewright
