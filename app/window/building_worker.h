// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include <QObject>
#include <QString>

#include "app/window/building_maker.h"

namespace planewright {

/// Makes maps on a thread of its own. The newest request wins: what is being made for an older one is given up.
class BuildingWorker : public QObject {
    Q_OBJECT

public:
    explicit BuildingWorker(QObject* parent = nullptr);
    ~BuildingWorker() override;

    void make(BuildingRequest request);
    /// Gives up what is being made; nothing comes of it.
    void cancel();

    /// True while something is being made or about to be told. To be asked in this object's thread.
    bool isBusy() const { return wanted_ != told_; }

signals:
    // In this object's thread, of the newest request alone.
    void progressed(const QString& what, int done, int all);
    void made(const std::shared_ptr<const planewright::BuiltMap>& map);
    void failed(const planewright::Error& error);

private:
    void run(const std::stop_token& stop);
    /// Does something in this object's thread if nothing newer was asked for meanwhile.
    void post(int number, std::function<void()> what);

    int wanted_ = 0;  ///< the newest request
    int told_ = 0;    ///< the request whose end was told, or that was given up

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<BuildingRequest> next_;
    int nextNumber_ = 0;
    std::stop_source giveUp_;

    std::jthread thread_;  // last: it uses all the others
};

}  // namespace planewright
