// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_time.h"

#include <string>

#include "devices/scip/scip_encoding.h"

namespace planewright {

namespace {

constexpr int kQuestions = 8;

/// One question; false where it is not answered. The tag tells its answer from a late one to the question before.
Result<bool> askTime(ScipLink& link, int number, ScipClock& clock, const std::stop_token& stop)
{
    const auto answer = link.ask(withScipTag(kScipTime, "t" + std::to_string(number)), kScipReply, stop);
    if (!answer)
        return tl::unexpected{answer.error()};
    if (!*answer || (*answer)->status != "00" || (*answer)->lines.size() != 1)
        return false;
    const auto stamp = fromScip((*answer)->lines[0].text);
    if (stamp && (*answer)->lines[0].text.size() == 4)
        clock.addAnswer(*stamp, (*answer)->asked, (*answer)->answered);
    return true;
}

}  // namespace

Result<void> compareScipClocks(ScipLink& link, ScipVersion version, ScipClock& clock, const ScipProgress& progress,
                               const std::stop_token& stop)
{
    const Result<ScipReply> on = askScipPatiently(link, kScipTimeModeOn, version, progress, stop);
    if (!on)
        return tl::unexpected{on.error()};
    const ScipVerdict verdict = scipMeaning("TM", on->status, version).verdict;
    if (verdict != ScipVerdict::Good && verdict != ScipVerdict::AlreadySo)
        return {};
    for (int question = 0; question < kQuestions; ++question) {
        const Result<bool> answered = askTime(link, question, clock, stop);
        if (!answered)
            return tl::unexpected{answered.error()};
        if (!*answered)
            break;
    }
    for (int attempt = 0; attempt < 2; ++attempt) {
        // Not to be stopped: a laser left in time mode refuses everything else.
        const auto off = link.ask(kScipTimeModeOff, kScipReply, {});
        if (!off)
            return tl::unexpected{off.error()};
        if (*off)
            break;
    }
    return {};
}

}  // namespace planewright
