// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "app/window/waiting.h"

#include <QDeadlineTimer>
#include <QEventLoop>
#include <QTimer>

namespace planewright {

bool waitUntil(const std::function<bool()>& holds, std::chrono::milliseconds time)
{
    constexpr int kLookEvery = 5;  // [ms]
    const QDeadlineTimer deadline(time);
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (holds() || deadline.hasExpired())
            loop.quit();
    });
    if (holds())
        return true;
    look.start(kLookEvery);
    loop.exec();
    return holds();
}

bool isAtRest(SessionState state)
{
    return state == SessionState::Empty || state == SessionState::Ready || state == SessionState::Review ||
           state == SessionState::ReadOnly || state == SessionState::Paused;
}

bool isShown(const WindowParts& parts)
{
    return parts.shown->snapshot == (parts.shownPhase ? parts.shownPhase : parts.session.map()->snapshot);
}

Result<void> waitForRest(WindowParts& parts, std::chrono::milliseconds time)
{
    const bool rested = waitUntil(
        [&] { return parts.fault || (isAtRest(parts.session.state()) && !parts.isAtWork() && isShown(parts)); }, time);
    if (parts.fault)
        return tl::unexpected{*parts.fault};
    if (!rested)
        return fail(ErrorCode::Internal,
                    "The scan did not come to rest within " + std::to_string(time.count() / 1000) + " s.");
    return {};
}

}  // namespace planewright
