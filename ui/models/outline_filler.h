// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <chrono>
#include <map>
#include <memory>

#include <QObject>
#include <QTimer>

#include "ui/common/shown_map.h"

namespace planewright {

/// Works out the outlines that a map lacks, a few at a time, and keeps them by plane and revision.
///
/// It takes up its thread for no longer than one outline beyond the budget at a time. A plane shows its earlier outline
/// until the new one is there. Maps with outlines pass through as they are. It may be moved to a thread of its own,
/// since the largest planes take a tenth of a second each.
class OutlineFiller : public QObject {
    Q_OBJECT

public:
    explicit OutlineFiller(QObject* parent = nullptr);

    /// How long it may work before it lets others go on.
    void setBudget(std::chrono::milliseconds budget) { budget_ = budget; }

    bool isBusy() const { return timer_.isActive(); }

public slots:
    /// Gives the map at once with the outlines that are known (filled), and again when more are.
    void setMap(const std::shared_ptr<const planewright::ShownMap>& map);

signals:
    void filled(const std::shared_ptr<const planewright::ShownMap>& map);

private:
    void work();
    bool isOpen(const ShownPlane& plane) const;
    void publish();

    std::shared_ptr<const ShownMap> map_;
    std::map<PlaneId, std::shared_ptr<const FilledOutline>> outlines_;
    std::size_t next_ = 0;  // place among the map's planes; those before have their outline
    QTimer timer_;
    std::chrono::milliseconds budget_{15};
};

}  // namespace planewright
