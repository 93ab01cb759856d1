// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include <QObject>
#include <QStringList>
#include <QTimer>

#include "app/session/session_map.h"
#include "app/window/outline_maker.h"
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

/// Makes what the window shows out of a session's map: the operator's edits, on a thread of its own, and the planes'
/// outlines, on another.
///
/// The newest request wins. A map is shown at once with the outlines that are there, and again when more of them are.
class MapWorker : public QObject {
    Q_OBJECT

public:
    explicit MapWorker(QObject* parent = nullptr);
    ~MapWorker() override;

    void show(MapRequest request);

    /// True while something is being worked out or about to be shown. To be asked in this object's thread.
    bool isBusy() const;

signals:
    /// In this object's thread. `problems` are the edits that could not be applied.
    void shown(const std::shared_ptr<const planewright::ShownMap>& map, const QStringList& problems);

private:
    void run(const std::stop_token& stop);
    /// Does something in this object's thread.
    void post(std::function<void()> what);
    void take(std::shared_ptr<ShownMap> map, const QStringList& problems);
    /// Gives planes the outlines that there are.
    void fill(ShownMap& map) const;
    void showMore();

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<MapRequest> next_;
    bool busy_ = false;
    int posted_ = 0;

    std::shared_ptr<const ShownMap> last_;  ///< that was shown
    QStringList problems_;
    QTimer more_;  ///< there are more outlines than are shown; another map may come first and show them
    OutlineMaker outlines_;
    std::jthread thread_;  // last: it uses all the others
};

}  // namespace planewright
