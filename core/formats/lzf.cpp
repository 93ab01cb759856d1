// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/formats/lzf.h"

namespace planewright {

bool decompressLzf(std::string_view compressed, std::size_t size, std::string& plain)
{
    constexpr std::size_t kPlainRuns = 32;
    constexpr std::size_t kLongCopy = 7;
    plain.clear();
    plain.reserve(size);
    std::size_t at = 0;
    const auto next = [&](std::size_t& value) {
        if (at == compressed.size())
            return false;
        value = static_cast<unsigned char>(compressed[at++]);
        return true;
    };
    for (std::size_t control = 0; next(control);) {
        if (control < kPlainRuns) {
            const std::size_t length = control + 1;
            if (length > compressed.size() - at || length > size - plain.size())
                return false;
            plain.append(compressed.substr(at, length));
            at += length;
            continue;
        }
        std::size_t length = control >> 5U;
        std::size_t more = 0;
        if (length == kLongCopy && !next(more))
            return false;
        length += more + 2;
        std::size_t low = 0;
        if (!next(low))
            return false;
        const std::size_t distance = ((control & 31U) << 8U | low) + 1;
        if (distance > plain.size() || length > size - plain.size())
            return false;
        // A copy may reach into what it makes itself.
        for (std::size_t from = plain.size() - distance, end = from + length; from < end; ++from)
            plain += plain[from];
    }
    return plain.size() == size;
}

}  // namespace planewright
