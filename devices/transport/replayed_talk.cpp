// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "devices/transport/replayed_talk.h"

#include <algorithm>
#include <utility>

namespace planewright {

namespace {

std::string inSeconds(std::chrono::nanoseconds time)
{
    const auto milliseconds = std::chrono::round<std::chrono::milliseconds>(time).count();
    std::string text = std::to_string(milliseconds);
    text.insert(0, text.size() < 4 ? 4 - text.size() : 0, '0');
    return text.insert(text.size() - 3, ".") + " s";
}

}  // namespace

Result<std::unique_ptr<ReplayedTalk>> ReplayedTalk::open(const std::string& path, Pace pace,
                                                         std::unique_ptr<DialogueSpeech> speech, const Clock& clock)
{
    Result<DialogueReader> reader = DialogueReader::open(path);
    if (!reader)
        return tl::unexpected<Error>(reader.error());
    std::unique_ptr<ReplayedTalk> talk{new ReplayedTalk(path, pace, std::move(speech), clock)};
    for (;;) {
        auto event = reader->next();
        if (!event)
            return tl::unexpected<Error>(event.error());
        if (!*event)
            return talk;
        talk->add(std::move(**event));
    }
}

ReplayedTalk::ReplayedTalk(std::string path, Pace pace, std::unique_ptr<DialogueSpeech> speech, const Clock& clock)
    : path_(std::move(path)),
      pace_(pace),
      speech_(std::move(speech)),
      clock_(clock),
      later_(clock.now()),
      inAll_(later_),
      lastDue_(later_)
{
}

void ReplayedTalk::add(DialogueEvent event)
{
    if (event.kind != DialogueEvent::Kind::ToDevice) {
        answers_.push_back(
            {event.at, std::move(event.bytes), messages_.size(), event.kind == DialogueEvent::Kind::Lost});
        return;
    }
    DialogueSpeech::Meaning meaning = speech_->meaningOf(event.bytes);
    // What is said again to the byte had no answer in time.
    meaning.isQuestion = meaning.isQuestion || (!messages_.empty() && messages_.back().bytes == event.bytes);
    messages_.push_back({event.at, std::move(event.bytes), std::move(meaning)});
}

Result<Transport::Arrival> ReplayedTalk::read(std::span<std::uint8_t> into, Time deadline, const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    for (;;) {
        if (over_)
            return tl::unexpected<Error>(*over_);
        const Time now = clock_.now();
        release(now);
        if (over_)
            return tl::unexpected<Error>(*over_);
        if (!due_.empty() && now >= due_.front().at) {
            Due& first = due_.front();
            const std::size_t count = std::min(into.size(), first.bytes.size() - first.given);
            std::copy_n(first.bytes.begin() + static_cast<std::ptrdiff_t>(first.given), count, into.begin());
            first.given += count;
            const Arrival arrival{count, first.at};
            if (first.given == first.bytes.size())
                due_.pop_front();
            return arrival;
        }
        if (now >= deadline || stop.stop_requested())
            return Arrival{0, now};
        Time until = due_.empty() ? deadline : std::min(deadline, due_.front().at);
        if (answered_ < answers_.size() && answers_[answered_].after <= said_)
            until = std::min(until, dueAt(answers_[answered_].at, now));
        clock_.wait(lock, changed_, stop, until);
    }
}

ReplayedTalk::Time ReplayedTalk::dueAt(Time then, Time now) const
{
    return pace_ == Pace::Recorded ? std::max(lastDue_, then + later_) : now;
}

void ReplayedTalk::release(Time now)
{
    while (answered_ < answers_.size() && answers_[answered_].after <= said_) {
        Answer& answer = answers_[answered_];
        const Time at = dueAt(answer.at, now);
        if (at > now)
            return;
        if (answer.isLoss) {
            endWith("the link was lost then, " + inSeconds(answer.at) +
                    " after it began: " + std::string{answer.bytes.begin(), answer.bytes.end()});
            return;
        }
        ++answered_;
        lastDue_ = at;
        if (Bytes bytes = speech_->translated(answer.bytes); !bytes.empty())
            due_.push_back({at, std::move(bytes), 0});
    }
}

Result<void> ReplayedTalk::write(std::span<const std::uint8_t> bytes, Time /*deadline*/)
{
    const std::scoped_lock lock(mutex_);
    if (over_)
        return tl::unexpected<Error>(*over_);
    if (bytes.empty())
        return {};
    const DialogueSpeech::Meaning meaning = speech_->meaningOf(bytes);
    if (const auto found = find(meaning)) {
        skipTo(*found);
        speech_->pair(messages_[*found].bytes, bytes);
        later_ = clock_.now() - messages_[*found].at;
        if (!meaning.isQuestion)
            inAll_ = later_;
        said_ = *found + 1;
        repeated_ = 0;
    } else if (!repeat(meaning)) {
        const bool isOver = said_ == messages_.size();
        return endWith("after " + inSeconds(isOver ? Time{0} : messages_[said_].at) + " the host said " +
                       (isOver ? std::string{"nothing more"} : quotedDialogue(messages_[said_].bytes)) +
                       " and now says " + quotedDialogue(bytes) + kRecordAnew);
    }
    changed_.notify_all();
    return {};
}

/// The message that is meant: the next one, or one before which only questions stand. Of a question that is asked again
/// and again, the one of this moment.
std::optional<std::size_t> ReplayedTalk::find(const DialogueSpeech::Meaning& meaning) const
{
    std::optional<std::size_t> found;
    const std::size_t end = std::min(messages_.size(), said_ + kMostLeftOut + 1);
    for (std::size_t i = said_; i < end; ++i) {
        const bool isToCome = messages_[i].at + inAll_ > clock_.now();
        if (messages_[i].meaning.what == meaning.what && !(found && isToCome))
            found = i;
        if (!messages_[i].meaning.isQuestion || (found && (isToCome || !meaning.isQuestion)))
            break;
    }
    return found;
}

/// Leaves out the messages up to one, and the answers to them.
void ReplayedTalk::skipTo(std::size_t message)
{
    if (!speech_->answersOnly() || message == said_)
        return;
    while (answered_ < answers_.size() && answers_[answered_].after <= message && !answers_[answered_].isLoss) {
        if (answers_[answered_].after <= said_)
            release(clock_.now());  // to what was said before
        if (answered_ < answers_.size() && answers_[answered_].after <= message)
            ++answered_;
    }
}

/// A question that the record does not have here; false where it is none, or one too many.
bool ReplayedTalk::repeat(const DialogueSpeech::Meaning& meaning)
{
    const auto last = std::find_if(messages_.rbegin() + static_cast<std::ptrdiff_t>(messages_.size() - said_),
                                   messages_.rend(), [&](const Message& m) { return m.meaning.what == meaning.what; });
    const bool wasSaidAgain = last != messages_.rend() && said_ > 0 && &*last == &messages_[said_ - 1];
    if ((!meaning.isQuestion && !wasSaidAgain) || repeated_++ >= kMostRepeated)
        return false;
    if (!speech_->answersOnly() || last == messages_.rend())
        return true;
    const auto number = static_cast<std::size_t>(messages_.rend() - last);  // messages up to it, it included
    const auto first = std::lower_bound(answers_.begin(), answers_.end(), number,
                                        [](const Answer& answer, std::size_t after) { return answer.after < after; });
    for (auto answer = first; answer != answers_.end() && answer->after == number && !answer->isLoss; ++answer) {
        const Time waited = pace_ == Pace::Recorded ? answer->at - last->at : Time{0};
        due_.push_back({clock_.now() + waited, speech_->translated(answer->bytes), 0});
    }
    return true;
}

bool ReplayedTalk::isPlayed()
{
    const std::scoped_lock lock(mutex_);
    const auto isQuestion = [](const Message& message) { return message.meaning.isQuestion; };
    const bool isSaid =
        std::all_of(messages_.begin() + static_cast<std::ptrdiff_t>(said_), messages_.end(), isQuestion);
    return isSaid && due_.empty() &&
           std::all_of(answers_.begin() + static_cast<std::ptrdiff_t>(answered_), answers_.end(),
                       [&](const Answer& answer) { return answer.isLoss || answer.after > said_; });
}

void ReplayedTalk::close()
{
    const std::scoped_lock lock(mutex_);
    if (!over_)
        over_ = Error{ErrorCode::DeviceLost, path_ + ": the dialogue was closed; open it again"};
    changed_.notify_all();
}

tl::unexpected<Error> ReplayedTalk::endWith(const std::string& why)
{
    over_ = Error{ErrorCode::DeviceLost, path_ + ": " + why};
    changed_.notify_all();
    return tl::unexpected<Error>(*over_);
}

}  // namespace planewright
