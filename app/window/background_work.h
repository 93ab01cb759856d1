// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QObject>
#include <QThreadPool>

#include "core/types/error.h"

namespace planewright {

/// Work that takes too long for the GUI's thread, one piece after the other on a thread of its own: files that are
/// written, copied or checked.
class BackgroundWork : public QObject {
    Q_OBJECT

public:
    explicit BackgroundWork(QObject* parent = nullptr);
    /// Waits until everything has been done; what was to follow in the GUI's thread does not.
    ~BackgroundWork() override;

    /// Does `work`, which must touch nothing that others change, and then calls `then` in this object's thread.
    template <class Value>
    void start(std::function<Value()> work, std::function<void(Value&)> then)
    {
        auto value = std::make_shared<std::optional<Value>>();
        run([work = std::move(work), value] { value->emplace(work()); },
            [then = std::move(then), value] { then(**value); });
    }

    bool isBusy() const { return pending_ > 0; }

private:
    void run(std::function<void()> work, std::function<void()> then);

    QThreadPool thread_;
    int pending_ = 0;
};

}  // namespace planewright
