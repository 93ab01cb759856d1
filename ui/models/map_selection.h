// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <set>

#include <QObject>

#include "ui/common/beam_run.h"
#include "ui/common/shown_map.h"

namespace planewright {

/// What is chosen in the map, and what the pointer is on: one for the tables and the 3D view.
class MapSelection : public QObject {
    Q_OBJECT

public:
    explicit MapSelection(QObject* parent = nullptr);

    const std::set<PlaneId>& planes() const { return planes_; }
    const std::set<SegmentId>& segments() const { return segments_; }
    /// Pieces of slices that were discarded.
    const std::set<BeamRun>& pieces() const { return pieces_; }
    PlaneId hovered() const { return hovered_; }
    bool isEmpty() const { return planes_.empty() && segments_.empty() && pieces_.empty(); }

    /// Chooses these and nothing else.
    void select(std::set<PlaneId> planes, std::set<SegmentId> segments = {}, std::set<BeamRun> pieces = {});
    /// The planes chosen become these, all else stays; and the same of segments.
    void selectPlanes(std::set<PlaneId> planes) { select(std::move(planes), segments_, pieces_); }
    void selectSegments(std::set<SegmentId> segments) { select(planes_, std::move(segments), pieces_); }
    void addPlane(PlaneId plane);
    void togglePlane(PlaneId plane);
    void addSegment(const SegmentId& segment);
    void toggleSegment(const SegmentId& segment);
    void clear() { select({}); }

    /// All planes of a map that are not hidden; and those of them that are not chosen now.
    void selectAll(const ShownMap& map);
    void invert(const ShownMap& map);

    /// Drops what a map no longer has.
    void keepWhatIsIn(const ShownMap& map);

    /// kNoPlane where the pointer is on none.
    void hover(PlaneId plane);

signals:
    void changed();
    void hoverChanged(planewright::PlaneId plane);

private:
    std::set<PlaneId> planes_;
    std::set<SegmentId> segments_;
    std::set<BeamRun> pieces_;
    PlaneId hovered_ = kNoPlane;
};

}  // namespace planewright
