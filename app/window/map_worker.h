// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <unordered_map>
#include <vector>

#include <QObject>
#include <QStringList>

#include "app/session/session_map.h"
#include "core/params/parameters.h"
#include "core/types/edit.h"
#include "core/types/recording.h"
#include "ui/common/shown_map.h"

namespace planewright {

/// What is to be shown: a scan at one moment, with the edits of its planes.
struct MapRequest {
    std::shared_ptr<const SessionMap> map;
    std::vector<Edit> edits;  ///< those in force
    ScanDescription description;
    Parameters parameters;
};

/// Makes what the window shows out of a session's map, on a thread of its own: the operator's edits and the planes'
/// outlines, which may take a tenth of a second each.
///
/// The newest request wins. A map is shown at once with the outlines that are there, and again when more of them are.
class MapWorker : public QObject {
    Q_OBJECT

public:
    explicit MapWorker(QObject* parent = nullptr);
    ~MapWorker() override;

    void show(MapRequest request);

    /// True while something is being worked out.
    bool isBusy() const;

signals:
    /// In this object's thread. `problems` are the edits that could not be applied.
    void shown(const std::shared_ptr<const planewright::ShownMap>& map, const QStringList& problems);

private:
    struct Known {
        std::shared_ptr<const Plane> plane;  ///< keeps the address from being used again
        std::shared_ptr<const FilledOutline> outline;
    };

    void run(const std::stop_token& stop);
    void work(const MapRequest& request);
    bool fillOutlines(ShownMap& map, const Snapshot& snapshot);
    bool isSuperseded() const;
    void publish(std::shared_ptr<const ShownMap> map, QStringList problems);

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<MapRequest> next_;
    bool busy_ = false;
    std::unordered_map<const Plane*, Known> known_;                               ///< of the thread
    std::unordered_map<PlaneId, std::shared_ptr<const FilledOutline>> lastOfId_;  ///< of the thread
    std::jthread thread_;                                                         // last: it uses all the others
};

}  // namespace planewright
