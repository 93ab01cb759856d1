// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/fault_words.h"

#include <algorithm>
#include <array>

namespace planewright {

namespace {

struct FaultWords {
    std::string_view code;
    std::string_view words;
};

constexpr auto kFaultWords = std::to_array<FaultWords>({
    {"adapter-overrun", "the adapter lost bytes"},
    {"board-cobs", "a frame that is not stuffed as it must be"},
    {"board-crc", "a frame with a wrong checksum"},
    {"board-disarmed", "disarmed by somebody else"},
    {"board-estop", "stopped in an emergency"},
    {"board-firmware", "an error of its firmware"},
    {"board-jump", "an angle that cannot be"},
    {"board-length", "a frame of a wrong length"},
    {"board-limit", "beyond its limit"},
    {"board-lost-events", "events that did not come"},
    {"board-no-angles", "no angles any more"},
    {"board-no-reply", "no answer to a request"},
    {"board-no-sync", "no sync edge from the laser"},
    {"board-overheat", "the motor was too hot"},
    {"board-overload", "the motor was overloaded"},
    {"board-reset", "started anew"},
    {"board-servo-refused", "its servo refused a request"},
    {"board-servo-silent", "its servo does not answer"},
    {"board-slip", "not where it says that it arrived"},
    {"board-slow", "angles that come too late"},
    {"board-stall", "something blocks the head"},
    {"board-stopped", "stopped by itself"},
    {"board-times", "a heartbeat whose times cannot be"},
    {"board-unfetched", "more messages than were fetched"},
    {"board-unreadable", "a message that cannot be read"},
    {"board-version", "a frame of another version"},
    {"board-voltage", "a supply out of range"},
    {"board-watchdog", "stopped, since heartbeats were missing"},
    {"board-wheel-mode", "its servo turns without end"},
    {"dialogue-ended", "a dialogue that is recorded no further"},
    {"laser-blind", "hardly a beam came back"},
    {"laser-character", "a character that no number has"},
    {"laser-count", "a scan with a wrong number of ranges"},
    {"laser-echo", "a scan that answers another request"},
    {"laser-frame-too-long", "a message without an end"},
    {"laser-interrupted", "a message with another one in it"},
    {"laser-line-length", "a line of a wrong length"},
    {"laser-line-too-long", "a line without an end"},
    {"laser-lost", "lost for good"},
    {"laser-malfunction", "a malfunction of the laser"},
    {"laser-silent", "no scans any more"},
    {"laser-status", "a message with a wrong status"},
    {"laser-stuck-time", "a scan with the time of the one before"},
    {"laser-sum", "a line with a wrong sum"},
    {"laser-unknown-echo", "a message that answers no request"},
    {"laser-verifying", "the laser checked itself"},
    {"servo-alarm", "an alarm"},
    {"servo-damaged", "an answer that came damaged"},
    {"servo-jump", "an angle that cannot be"},
    {"servo-no-torque", "its torque stayed off"},
    {"servo-off", "turned off by an alarm"},
    {"servo-other-goal", "moved by another program"},
    {"servo-other-number", "another servo answered"},
    {"servo-power-loss", "without power for a while"},
    {"servo-refused", "it refused a request"},
    {"servo-silent", "no answer to a question"},
    {"servo-stuck", "something blocks the head"},
    {"servo-supply", "a supply out of range"},
    {"servo-warm", "too warm to go on"},
});
static_assert(std::is_sorted(kFaultWords.begin(), kFaultWords.end(),
                             [](const FaultWords& a, const FaultWords& b) { return a.code < b.code; }));

}  // namespace

std::string_view faultWords(std::string_view code)
{
    const auto* const found = std::lower_bound(kFaultWords.begin(), kFaultWords.end(), code,
                                               [](const FaultWords& row, std::string_view c) { return row.code < c; });
    return found != kFaultWords.end() && found->code == code ? found->words : std::string_view{};
}

}  // namespace planewright
