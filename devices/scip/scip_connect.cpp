// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/scip/scip_connect.h"

#include <algorithm>
#include <utility>

#include "devices/scip/scip_facts.h"

namespace planewright {

namespace {

using std::chrono::milliseconds;
using Time = ScipLink::Time;

constexpr milliseconds kSettle{200};   ///< after the link was opened
constexpr milliseconds kSilence{150};  ///< without a byte: nothing more comes
constexpr milliseconds kLongestDrain{2'000};
constexpr milliseconds kFirstReply{2'000};  ///< a slow host has just found the device
constexpr int kAttempts = 3;

/// One conversation that ends with a laser known and at rest.
class Connection {
public:
    Connection(ScipLink& link, const ScipProgress& progress, const std::stop_token& stop)
        : link_(link), progress_(progress), stop_(stop)
    {
    }

    Result<void> clearLine();
    Result<void> comeToRest();
    Result<ScipPartner> getToKnow();
    Result<void> reboot();

private:
    enum class Rest { Reached, AskAgain };
    Result<Rest> follow(const ScipReply& quit);
    Result<ScipReply> askIntact(std::string_view request);
    Result<ScipState> checkCondition();
    tl::unexpected<Error> giveUp() const;
    tl::unexpected<Error> tooOld() const;

    ScipLink& link_;
    const ScipProgress& progress_;
    const std::stop_token& stop_;
    ScipPartner partner_;
    bool hasAskedForScip2_ = false;
    bool hasReset_ = false;
    int timesInTimeMode_ = 0;
};

/// An empty request ends half a one that somebody before has left behind.
Result<void> Connection::clearLine()
{
    if (const auto settled = link_.discard(kSettle, kSettle, stop_); !settled)
        return tl::unexpected{settled.error()};
    if (Result<void> sent = link_.send(""); !sent)
        return sent;
    if (const auto drained = link_.discard(kSilence, kLongestDrain, stop_); !drained)
        return tl::unexpected{drained.error()};
    return {};
}

/// QT until it is answered, and once more: one may be lost, or its answer be that to somebody else's.
Result<void> Connection::comeToRest()
{
    const Time deadline = link_.now() + kScipBootTime;
    for (Time patience = kFirstReply; link_.now() < deadline; patience = kScipReply) {
        const auto quit = link_.ask(kScipQuit, patience, stop_);
        if (!quit)
            return tl::unexpected{quit.error()};
        if (stop_.stop_requested())
            return scipInterrupted(link_);
        if (!*quit) {
            tellScipCountdown(link_, deadline, progress_);
            continue;
        }
        const Result<Rest> rest = follow(**quit);
        if (!rest)
            return tl::unexpected{rest.error()};
        if (*rest == Rest::Reached)
            return {};
    }
    return giveUp();
}

/// Does what the answer to QT asks for.
Result<Connection::Rest> Connection::follow(const ScipReply& quit)
{
    if (quit.status.size() == 1) {
        if (std::exchange(hasAskedForScip2_, true))
            return tooOld();
        const auto changed = link_.ask(kScipSpeak2, kScipReply, stop_);
        return changed ? Result<Rest>{Rest::AskAgain} : tl::unexpected{changed.error()};
    }
    const ScipVerdict verdict = scipMeaning(kScipQuit, quit.status, partner_.version).verdict;
    if (quit.status == "0E" && timesInTimeMode_++ < kAttempts) {  // in time mode QT is no request
        const auto left = link_.ask(kScipTimeModeOff, kScipReply, stop_);
        return left ? Result<Rest>{Rest::AskAgain} : tl::unexpected{left.error()};
    }
    if (verdict == ScipVerdict::Good) {
        const auto again = link_.ask(kScipQuit, kScipReply, stop_);
        if (!again)
            return tl::unexpected{again.error()};
        const auto drained = link_.discard(kSilence, kLongestDrain, stop_);
        if (!drained)
            return tl::unexpected{drained.error()};
        return drained->scans ? Rest::AskAgain : Rest::Reached;
    }
    // Whatever else it says, a fault among it: there is time to say something better.
    const auto waited = link_.discard(kScipReply, kScipReply, stop_);
    if (!waited)
        return tl::unexpected{waited.error()};
    if (verdict == ScipVerdict::Malfunction && !std::exchange(hasReset_, true)) {
        if (const Result<void> reset = resetScip(link_, stop_); !reset)
            return tl::unexpected{reset.error()};
    }
    return Rest::AskAgain;
}

/// Asks until every line of the answer is intact, or two answers say the same: then it is the laser's own sum that is
/// wrong, and not the line.
Result<ScipReply> Connection::askIntact(std::string_view request)
{
    std::optional<ScipAnswer> last;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        auto reply = link_.ask(request, kScipReply, stop_);
        if (!reply)
            return tl::unexpected{reply.error()};
        if (stop_.stop_requested())
            return scipInterrupted(link_);
        if (!*reply || (*reply)->status != "00")
            continue;
        const auto isIntact = [](const ScipLine& line) { return line.isIntact; };
        const auto isSame = [](const ScipLine& a, const ScipLine& b) { return a.text == b.text; };
        const std::vector<ScipLine>& lines = (*reply)->lines;
        if (std::all_of(lines.begin(), lines.end(), isIntact) ||
            (last && std::equal(lines.begin(), lines.end(), last->lines.begin(), last->lines.end(), isSame)))
            return std::move(**reply);
        last = std::move(**reply);
    }
    return fail(ErrorCode::NoDevice, link_.name() + ": the laser does not answer to " + std::string{request} +
                                         " as it should; check its cable, then connect again");
}

Result<ScipPartner> Connection::getToKnow()
{
    const Result<ScipReply> identity = askIntact(kScipIdentity);
    if (!identity)
        return tl::unexpected{identity.error()};
    const Result<ScipReply> facts = askIntact(kScipLimits);
    if (!facts)
        return tl::unexpected{facts.error()};
    partner_.identity = readScipIdentity(*identity);
    partner_.identity.model = scipField(*facts, "MODL").value_or("");
    partner_.version = scipVersionOf(partner_.identity.protocol);
    partner_.able = scipCapabilities(partner_.identity);
    const Result<LaserLimits> limits = readScipLimits(*facts, link_.name());
    if (!limits)
        return tl::unexpected{limits.error()};
    partner_.limits = *limits;

    Result<ScipState> state = checkCondition();
    if (state && state->isFaulty) {
        if (const Result<void> reset = resetScip(link_, stop_); !reset)
            return tl::unexpected{reset.error()};
        state = checkCondition();
    }
    if (state && state->isFaulty && partner_.able.reboot) {
        if (const Result<void> rebooted = reboot(); !rebooted)
            return tl::unexpected{rebooted.error()};
        state = checkCondition();
    }
    if (!state)
        return tl::unexpected{state.error()};
    if (state->isFaulty)
        return fail(ErrorCode::NoDevice, link_.name() + ": the laser reports a fault ('" + state->condition +
                                             "'); switch its power off and on, then connect again");
    if (!state->isHealthy)
        partner_.warning = "the laser says of itself '" + state->condition + "'";
    return partner_;
}

Result<ScipState> Connection::checkCondition()
{
    return askIntact(kScipState).map([](const ScipReply& reply) { return readScipState(reply); });
}

/// RB counts only where it comes twice within a second; some that obey never answer.
Result<void> Connection::reboot()
{
    for (int time = 0; time < 2; ++time) {
        const auto answered = link_.ask(kScipReboot, milliseconds{300}, stop_);
        if (!answered)
            return tl::unexpected{answered.error()};
    }
    return comeToRest();
}

tl::unexpected<Error> Connection::giveUp() const
{
    const ScipLink::Heard& heard = link_.heard();
    if (heard.replies || heard.scans)
        return fail(ErrorCode::NoDevice, link_.name() +
                                             ": the laser answers but does not come to rest; switch its "
                                             "power off and on, then connect again");
    if (heard.anything)
        return fail(ErrorCode::NoDevice, link_.name() +
                                             ": what answers there is no laser that speaks SCIP; choose "
                                             "another port");
    return fail(ErrorCode::NoDevice, link_.name() +
                                         ": no laser answers; check its 12 V supply, its cable, and that no "
                                         "other program uses it");
}

tl::unexpected<Error> Connection::tooOld() const
{
    return fail(ErrorCode::NoDevice, link_.name() +
                                         ": the laser speaks only SCIP 1.1, which is too old; give it newer "
                                         "firmware or take another laser");
}

}  // namespace

Result<ScipPartner> connectScip(ScipLink& link, const ScipProgress& progress, const std::stop_token& stop)
{
    Connection connection{link, progress, stop};
    if (const Result<void> clear = connection.clearLine(); !clear)
        return tl::unexpected{clear.error()};
    if (const Result<void> rest = connection.comeToRest(); !rest)
        return tl::unexpected{rest.error()};
    return connection.getToKnow();
}

Result<void> restartScip(ScipLink& link, const ScipProgress& progress, const std::stop_token& stop)
{
    return Connection{link, progress, stop}.reboot();
}

}  // namespace planewright
