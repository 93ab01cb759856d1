// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_event.h"

namespace planewright {

namespace {

struct Words {
    std::string_view code;
    std::string_view text;
};

constexpr std::array<Words, kScipDamageKinds> kWords{{
    {"laser-unknown-echo", "a message that answers no request"},
    {"laser-status", "a message with a wrong status"},
    {"laser-sum", "a line with a wrong sum"},
    {"laser-character", "a character that no number has"},
    {"laser-line-length", "a line of data that is too short or too long"},
    {"laser-count", "a scan with another number of ranges than was asked for"},
    {"laser-interrupted", "a message with another one in it"},
    {"laser-line-too-long", "a line without an end"},
    {"laser-frame-too-long", "a message without an end"},
}};

const Words& wordsOf(ScipDamageKind kind)
{
    return kWords[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string_view codeOf(ScipDamageKind kind)
{
    return wordsOf(kind).code;
}

std::string describe(ScipDamageKind kind)
{
    return std::string{wordsOf(kind).text};
}

}  // namespace planewright
