// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/replayed_dialogue.h"

#include <algorithm>
#include <utility>

namespace planewright {

Result<std::unique_ptr<ReplayedDialogue>> ReplayedDialogue::open(const std::string& path, Pace pace, const Clock& clock)
{
    Result<DialogueReader> check = DialogueReader::open(path);
    if (!check)
        return tl::unexpected<Error>(check.error());
    for (;;) {
        const auto event = check->next();
        if (!event)
            return tl::unexpected<Error>(event.error());
        if (!*event)
            break;
    }
    Result<DialogueReader> host = DialogueReader::open(path);
    Result<DialogueReader> device = DialogueReader::open(path);
    if (!host || !device)
        return fail(ErrorCode::Unreadable, path + ": was changed while it was read; try again");
    return std::unique_ptr<ReplayedDialogue>{
        new ReplayedDialogue(path, std::move(*host), std::move(*device), pace, clock)};
}

ReplayedDialogue::ReplayedDialogue(std::string path, DialogueReader host, DialogueReader device, Pace pace,
                                   const Clock& clock)
    : path_(std::move(path)),
      pace_(pace),
      clock_(clock),
      host_(std::move(host)),
      device_(std::move(device)),
      later_(clock.now()),
      lastDue_(later_)
{
}

Result<Transport::Arrival> ReplayedDialogue::read(std::span<std::uint8_t> into, std::chrono::nanoseconds deadline,
                                                  const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    for (;;) {
        if (over_)
            return tl::unexpected<Error>(*over_);
        if (const Result<void> looked = lookAhead(); !looked)
            return endWith(looked.error().message);
        const Time now = clock_.now();
        const std::optional<Time> at = due(now);
        if (at && now >= *at) {
            if (next_->kind == DialogueEvent::Kind::Lost)
                return endAtLoss(device_, *next_);
            return give(into, *at);
        }
        if (now >= deadline || stop.stop_requested())
            return Arrival{0, now};
        clock_.wait(lock, changed_, stop, std::min(deadline, at.value_or(deadline)));
    }
}

Result<void> ReplayedDialogue::lookAhead()
{
    while (!next_ && !deviceIsDone_) {
        auto event = device_.next();
        if (!event)
            return tl::unexpected<Error>(event.error());
        deviceIsDone_ = !*event;
        if (*event && (*event)->kind == DialogueEvent::Kind::ToDevice)
            needed_ += (*event)->bytes.size();
        else
            next_ = std::move(*event);
    }
    return {};
}

std::optional<ReplayedDialogue::Time> ReplayedDialogue::due(Time now)
{
    if (!next_ || needed_ > saidInAll_)
        return std::nullopt;
    for (; !turns_.empty() && turns_.front().bytes <= needed_; turns_.pop_front())
        later_ = turns_.front().later;
    // What was read in part has come as a whole.
    if (given_ > 0)
        return lastDue_;
    return pace_ == Pace::Recorded ? std::max(lastDue_, next_->at + later_) : now;
}

Transport::Arrival ReplayedDialogue::give(std::span<std::uint8_t> into, Time at)
{
    const auto rest = std::span{next_->bytes}.subspan(given_);
    const std::size_t count = std::min(into.size(), rest.size());
    std::copy_n(rest.begin(), count, into.begin());
    lastDue_ = at;
    given_ += count;
    if (given_ == next_->bytes.size()) {
        next_.reset();
        given_ = 0;
    }
    return {count, at};
}

Result<void> ReplayedDialogue::write(std::span<const std::uint8_t> bytes, std::chrono::nanoseconds /*deadline*/)
{
    const std::scoped_lock lock(mutex_);
    while (!bytes.empty()) {
        const auto rest = hear(bytes);
        if (!rest)
            return tl::unexpected<Error>(rest.error());
        bytes = *rest;
    }
    if (over_)
        return tl::unexpected<Error>(*over_);
    changed_.notify_all();
    return {};
}

Result<std::span<const std::uint8_t>> ReplayedDialogue::hear(std::span<const std::uint8_t> bytes)
{
    if (over_)
        return tl::unexpected<Error>(*over_);
    const Result<bool> isMore = expect();
    if (!isMore)
        return endWith(isMore.error().message);
    if (!*isMore)
        return endWith(host_.place() + ": the dialogue has nothing more from the host, which now says " +
                       quotedDialogue(bytes) + kRecordAnew);
    if (expected_->kind == DialogueEvent::Kind::Lost)
        return endAtLoss(host_, *expected_);
    const auto recorded = std::span{std::as_const(expected_->bytes)}.subspan(said_);
    const auto said = bytes.first(std::min(bytes.size(), recorded.size()));
    const auto same =
        static_cast<std::size_t>(std::mismatch(said.begin(), said.end(), recorded.begin()).first - said.begin());
    if (same < said.size())
        return endWith(host_.place() + ": the host said " + quotedDialogue(recorded.subspan(same)) + " and now says " +
                       quotedDialogue(bytes.subspan(same)) + ", from byte " + std::to_string(said_ + same + 1) + " on" +
                       kRecordAnew);
    said_ += said.size();
    saidInAll_ += said.size();
    if (said_ == expected_->bytes.size())
        turns_.push_back({saidInAll_, clock_.now() - expected_->at});
    return bytes.subspan(said.size());
}

Result<bool> ReplayedDialogue::expect()
{
    while (!expected_ || (said_ == expected_->bytes.size() && expected_->kind == DialogueEvent::Kind::ToDevice)) {
        auto event = host_.next();
        if (!event)
            return tl::unexpected<Error>(event.error());
        if (!*event)
            return false;
        if ((*event)->kind == DialogueEvent::Kind::FromDevice)
            continue;
        expected_ = std::move(*event);
        said_ = 0;
    }
    return true;
}

bool ReplayedDialogue::isPlayed()
{
    const std::scoped_lock lock(mutex_);
    const Result<void> looked = lookAhead();
    const Result<bool> isMore = expect();
    const auto isDone = [](const std::optional<DialogueEvent>& event) {
        return !event || event->kind == DialogueEvent::Kind::Lost;
    };
    return looked && isMore && isDone(next_) && (!*isMore || isDone(expected_));
}

void ReplayedDialogue::close()
{
    const std::scoped_lock lock(mutex_);
    if (!over_)
        over_ = Error{ErrorCode::DeviceLost, path_ + ": the dialogue was closed; open it again"};
    changed_.notify_all();
}

tl::unexpected<Error> ReplayedDialogue::endWith(const std::string& why)
{
    over_ = Error{ErrorCode::DeviceLost, why};
    changed_.notify_all();
    return tl::unexpected<Error>(*over_);
}

tl::unexpected<Error> ReplayedDialogue::endAtLoss(const DialogueReader& reader, const DialogueEvent& loss)
{
    return endWith(reader.place() + ": the link was lost here: " + std::string{loss.bytes.begin(), loss.bytes.end()});
}

}  // namespace planewright
